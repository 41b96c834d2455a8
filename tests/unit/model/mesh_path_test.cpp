// How mesh references find their files, and what the sources are called.
#include <cstdlib>

#include "mesh_files.hpp"
#include "model_fixture.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

HandModel load_with_mesh(const ScratchFolder& folder, const std::string& reference,
                         const ModelLoadOptions& options = {}, const std::string& urdf = "hand.urdf") {
  return load_hand_model(folder.write(urdf, one_finger(visual(mesh(reference)))), options);
}

}  // namespace

TEST_CASE("relative paths, absolute paths and file:// URIs are named relative to the URDF") {
  const ScratchFolder folder;
  const std::string file = folder.write("meshes/a b/\xC3\xA4.stl", ascii_stl());
  for (const std::string& reference :
       {std::string("meshes/a b/\xC3\xA4.stl"), std::string("./meshes/a b/\xC3\xA4.stl"), file, "file://" + file}) {
    const HandModel model = load_with_mesh(folder, reference);
    REQUIRE(model.sources.size() == 2);
    CHECK(model.sources[0].name == "hand.urdf");
    CHECK(model.sources[0].sha256.size() == 64);
    CHECK(model.sources[1].name == "meshes/a b/\xC3\xA4.stl");
  }
}

TEST_CASE("the URDF's own path may hold spaces and letters of any alphabet") {
  const ScratchFolder folder;
  folder.write("my hand \xE6\x89\x8B/a.stl", ascii_stl());
  const HandModel model = load_with_mesh(folder, "a.stl", {}, "my hand \xE6\x89\x8B/hand \xC3\xBC.urdf");
  CHECK(model.sources[0].name == "hand \xC3\xBC.urdf");
  CHECK(model.links[0].mesh.triangles.size() == 4);
}

TEST_CASE("a URDF in the current folder") {
  const ScratchFolder folder;
  folder.write("a.stl", ascii_stl());
  folder.write("hand.urdf", one_finger(visual(mesh("a.stl")) +
                                       visual(mesh("package://" + folder.path().filename().string() + "/a.stl"))));
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  const HandModel model = load_hand_model("hand.urdf");
  std::filesystem::current_path(before);
  CHECK(model.sources[0].name == "hand.urdf");
  CHECK(model.sources[1].name == "a.stl");
  CHECK(model.links[0].mesh.triangles.size() == 8);
}

TEST_CASE("a mesh used twice is one source") {
  const ScratchFolder folder;
  folder.write("a.stl", ascii_stl());
  const std::string both = visual(mesh("a.stl")) + visual(mesh("./a.stl"));
  CHECK(load_hand_model(folder.write("hand.urdf", one_finger(both))).sources.size() == 2);
}

TEST_CASE("a package is found by the option, by ROS_PACKAGE_PATH and above the URDF, in that order") {
  const ScratchFolder folder, elsewhere;
  const std::string reference = "package://my_hand/meshes/a.stl";
  unsetenv("ROS_PACKAGE_PATH");
  check_error([&] { load_with_mesh(folder, reference); }, ErrorCode::file_unreadable,
              {"hand.urdf", "package://my_hand/meshes/a.stl", "ModelLoadOptions::packages"});

  // beside the URDF's folder, then around it
  folder.write("my_hand/meshes/a.stl", ascii_stl());
  CHECK(load_with_mesh(folder, reference, {}, "robots/hand.urdf").sources[1].name == reference);
  CHECK(load_with_mesh(folder, reference, {}, "my_hand/urdf/hand.urdf").links[0].mesh.triangles.size() == 4);

  // a folder of ROS_PACKAGE_PATH holds packages or is one
  elsewhere.write("my_hand/meshes/a.stl", obj());  // not an STL: an error shows that this one was taken
  const std::string holds = elsewhere.path().string();
  for (const std::string& path : {"/nowhere:" + holds, holds + "/my_hand"}) {
    setenv("ROS_PACKAGE_PATH", path.c_str(), 1);
    check_error([&] { load_with_mesh(folder, reference); }, ErrorCode::invalid_mesh, {holds});
  }

  ModelLoadOptions options;
  options.packages = {{"other", holds}, {"my_hand", (folder.path() / "my_hand").string()}};
  CHECK(load_with_mesh(folder, reference, options).links[0].mesh.triangles.size() == 4);
  unsetenv("ROS_PACKAGE_PATH");
}

TEST_CASE("a reference that would need a network is refused") {
  for (const char* reference : {"http://example.org/a.stl", "https://example.org/a.stl"})
    check_load_error(one_finger(visual(mesh(reference))), ErrorCode::file_unreadable,
                     {reference, "not on this machine", "download"});
}

TEST_CASE("a symbolic link that leads to itself") {
  const ScratchFolder folder;
  std::filesystem::create_symlink(folder.path() / "a.stl", folder.path() / "a.stl");
  check_error([&] { load_with_mesh(folder, "a.stl"); }, ErrorCode::file_unreadable, {"a.stl"});
}

TEST_CASE("a mesh outside the folder of the model is refused, unless its package is named or all is allowed") {
  const ScratchFolder folder, elsewhere;
  unsetenv("ROS_PACKAGE_PATH");
  const std::string outside = elsewhere.write("meshes/a.stl", ascii_stl());
  const auto refused = [&](const std::string& reference, const std::string& urdf) {
    check_error([&] { load_with_mesh(folder, reference, {}, urdf); }, ErrorCode::file_unreadable,
                {urdf, "the mesh " + reference + " lies outside", "ModelLoadOptions::packages",
                 "ModelLoadOptions::allow_outside"});
  };
  folder.write("a.stl", ascii_stl());
  folder.write("model/a.stl", ascii_stl());
  std::filesystem::create_symlink(outside, folder.file("model/link.stl"));
  std::filesystem::create_directory_symlink(elsewhere.path(), folder.file("model/linked"));

  // the folder that holds the URDF's folder
  CHECK(load_with_mesh(folder, "../a.stl", {}, "model/urdf/hand.urdf").links[0].mesh.triangles.size() == 4);
  refused("../../a.stl", "model/urdf/hand.urdf");
  refused(outside, "model/urdf/hand.urdf");
  refused("file://" + outside, "model/urdf/hand.urdf");
  refused("../link.stl", "model/urdf/hand.urdf");
  refused("../linked/meshes/a.stl", "model/urdf/hand.urdf");
  refused("../../model/../a.stl", "model/urdf/hand.urdf");
  refused("/etc/passwd", "model/urdf/hand.urdf");

  // with a package.xml, its folder and no more
  refused("../../a.stl", "model/robots/v1/hand.urdf");
  folder.write("model/package.xml", "<package/>");
  CHECK(load_with_mesh(folder, "../../a.stl", {}, "model/robots/v1/hand.urdf").links[0].mesh.triangles.size() == 4);
  refused("../../../a.stl", "model/robots/v1/hand.urdf");
  folder.write("model/robots/package.xml", "<package/>");
  refused("../../a.stl", "model/robots/v1/hand.urdf");

  ModelLoadOptions options;
  options.packages = {{"anything", (elsewhere.path() / "meshes").string()}};
  CHECK(load_with_mesh(folder, outside, options).links[0].mesh.triangles.size() == 4);
  CHECK(load_with_mesh(folder, "linked/meshes/a.stl", options, "model/hand.urdf").links[0].mesh.triangles.size() == 4);
  setenv("ROS_PACKAGE_PATH", elsewhere.path().c_str(), 1);
  CHECK(load_with_mesh(folder, outside).links[0].mesh.triangles.size() == 4);
  unsetenv("ROS_PACKAGE_PATH");
  options = {};
  options.allow_outside = true;
  CHECK(load_with_mesh(folder, outside, options).links[0].mesh.triangles.size() == 4);
}

TEST_CASE("a name that begins like the folder of the model is not in it") {
  const ScratchFolder folder;
  folder.write("model-secret/a.stl", ascii_stl());
  check_error([&] { load_with_mesh(folder, "../../model-secret/a.stl", {}, "model/urdf/hand.urdf"); },
              ErrorCode::file_unreadable, {"lies outside"});
}

TEST_CASE("the buffer of a glTF file may not lie outside either") {
  const ScratchFolder folder;
  folder.write("model/meshes/a.gltf", gltf(R"("uri":"../../buffer.bin")"));
  folder.write("buffer.bin", gltf_buffer());
  check_error([&] { load_with_mesh(folder, "../meshes/a.gltf", {}, "model/urdf/hand.urdf"); }, ErrorCode::invalid_mesh,
              {"a.gltf"});
  ModelLoadOptions anywhere;
  anywhere.allow_outside = true;
  CHECK(load_with_mesh(folder, "../meshes/a.gltf", anywhere, "model/urdf/hand.urdf").links[0].mesh.triangles.size() ==
        4);
}

TEST_CASE("meshes read in a child process are the same meshes and sources") {
  const ScratchFolder folder;
  folder.write("a.stl", binary_stl());
  folder.write("b.gltf", gltf(R"("uri":"b.bin")"));
  folder.write("b.bin", gltf_buffer());
  const std::string urdf = folder.write("hand.urdf", one_finger(visual(mesh("a.stl")) + visual(mesh("b.gltf"))));
  ModelLoadOptions in_child;
  in_child.in_child.emplace();
  const HandModel plain = load_hand_model(urdf), fenced = load_hand_model(urdf, in_child);
  CHECK(plain.sources.size() == 4);
  CHECK(fenced.sources == plain.sources);
  CHECK(fenced.links[0].mesh.triangles == plain.links[0].mesh.triangles);
  REQUIRE(fenced.links[0].mesh.vertices.size() == plain.links[0].mesh.vertices.size());
  for (std::size_t i = 0; i < plain.links[0].mesh.vertices.size(); ++i)
    CHECK(norm(fenced.links[0].mesh.vertices[i] - plain.links[0].mesh.vertices[i]) == 0);
}
