// Meshes and primitives of loaded models.
#include <fcntl.h>
#include <unistd.h>

#include <numbers>

#include "mesh_files.hpp"
#include "model_fixture.hpp"

using namespace uhas;
using namespace uhas::test;

namespace {

/// The palm's mesh of a model whose palm holds `palm_content`; `content` is written to the file `name` beside the URDF.
TriangleMesh palm_mesh(const std::string& name, const std::string& content, const std::string& palm_content) {
  const ScratchFolder folder;
  folder.write(name, content);
  return load_hand_model(folder.write("hand.urdf", one_finger(palm_content))).links[0].mesh;
}

TriangleMesh palm_mesh(const std::string& name, const std::string& content) {
  return palm_mesh(name, content, visual(mesh(name)));
}

void check_tetrahedron(const TriangleMesh& m) {
  CHECK(m.triangles.size() == 4);
  CHECK(signed_volume(m) == doctest::Approx(1.0 / 6));
  check_near(bounds(m).low, {0, 0, 0});
  check_near(bounds(m).high, {1, 1, 1});
}

void check_mesh_error(const std::string& name, const std::string& content, ErrorCode code,
                      const std::vector<std::string>& words) {
  check_error([&] { palm_mesh(name, content); }, code, words);
}

constexpr const char* small_box = R"(<box size="0.2 0.4 0.6"/>)";

}  // namespace

TEST_CASE("every mesh format gives the same triangles") {
  check_tetrahedron(palm_mesh("a.stl", ascii_stl()));
  check_tetrahedron(palm_mesh("b.STL", binary_stl()));
  check_tetrahedron(palm_mesh("c.obj", obj()));
  check_tetrahedron(palm_mesh("d.ply", ascii_ply()));
  check_tetrahedron(palm_mesh("e.ply", binary_ply()));
  check_tetrahedron(palm_mesh("f.dae", dae("Z_UP")));
  check_tetrahedron(palm_mesh("g.glb", glb()));
}

TEST_CASE("glTF reads its buffer, and both files are sources") {
  const ScratchFolder folder;
  folder.write("meshes/a.gltf", gltf(R"("uri":"a.bin")"));
  folder.write("meshes/a.bin", gltf_buffer());
  const HandModel model = load_hand_model(folder.write("hand.urdf", one_finger(visual(mesh("meshes/a.gltf")))));
  check_tetrahedron(model.links[0].mesh);
  REQUIRE(model.sources.size() == 3);
  CHECK(model.sources[1].name == "meshes/a.gltf");
  CHECK(model.sources[2].name == "meshes/a.bin");
}

TEST_CASE("a DAE is not turned, whatever up axis it is marked with") {
  check_tetrahedron(palm_mesh("a.dae", dae("Y_UP")));
  check_tetrahedron(palm_mesh("a.dae", dae("X_UP")));
}

TEST_CASE("a DAE's unit and node transforms are applied") {
  const TriangleMesh m = palm_mesh("a.dae", dae("Z_UP", "0.001", "<translate>1 2 3</translate>"));
  check_near(bounds(m).low, {0.001, 0.002, 0.003});
  check_near(bounds(m).high, {0.002, 0.003, 0.004});
}

TEST_CASE("the node transforms of a GLB are applied, its y axis is not turned up") {
  const TriangleMesh turned =
      palm_mesh("a.glb", glb(R"("rotation":[0,0,0.7071067811865476,0.7071067811865476],"translation":[0,0,5])"));
  check_near(bounds(turned).low, {-1, 0, 5});
  check_near(bounds(turned).high, {0, 1, 6});
  CHECK(palm_mesh("a.glb", glb(R"("scale":[-1,1,1])")).triangles.size() == 4);
}

TEST_CASE("normals stay outward under mirroring nodes and scales") {
  CHECK(signed_volume(palm_mesh("a.glb", glb(R"("scale":[-1,1,1])"))) == doctest::Approx(1.0 / 6));
  for (const char* scale : {"-1 1 1", "1 -1 1", "-1 -1 -1"})
    CHECK(
        signed_volume(palm_mesh("a.stl", ascii_stl(), visual(mesh("a.stl", "scale=\"" + std::string(scale) + "\"")))) ==
        doctest::Approx(1.0 / 6));
}

TEST_CASE("the scale is applied in the mesh's frame, before the origin of the visual") {
  const TriangleMesh m =
      palm_mesh("a.stl", ascii_stl(),
                visual(mesh("a.stl", R"(scale="1 2 3")"), R"(<origin xyz="0 0 1" rpy="0 0 1.5707963267948966"/>)"));
  check_near(bounds(m).low, {-2, 0, 1});
  check_near(bounds(m).high, {0, 1, 4});
}

TEST_CASE("lines, degenerate triangles and vertices without triangle are dropped, polygons are cut") {
  const TriangleMesh m = palm_mesh("a.obj", obj("v 9 9 9\nv 8 8 8\nl 5 6\nf 1 1 2\nf 5 6 5\n"));
  check_tetrahedron(m);
  CHECK(palm_mesh("b.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n").triangles.size() == 2);
}

TEST_CASE("inertial elements that urdfdom would refuse cost no geometry, and nothing is printed") {
  const ScratchFolder folder;
  const std::string urdf = folder.write(
      "hand.urdf", one_finger("<inertial><mass value=\"1\"/></inertial><!-- no inertia -->" +
                              ("<visual><geometry>" + std::string(small_box) + "</geometry><material/></visual>")));
  const std::string printed = (folder.path() / "printed").string();
  const int capture = open(printed.c_str(), O_CREAT | O_WRONLY, 0600);
  const int standard_error = dup(2), standard_output = dup(1);
  dup2(capture, 2), dup2(capture, 1);
  const HandModel model = load_hand_model(urdf);
  dup2(standard_error, 2), dup2(standard_output, 1);
  for (const int file : {capture, standard_error, standard_output}) close(file);
  CHECK(model.links[0].mesh.triangles.size() == 12);
  CHECK(std::filesystem::file_size(printed) == 0);
}

TEST_CASE("primitives are closed, their normals outward, their sizes right") {
  const auto palm = [](const std::string& shape) { return load(one_finger(visual(shape))).links[0].mesh; };
  using std::numbers::pi;

  const TriangleMesh box = palm(small_box);
  CHECK(signed_volume(box) == doctest::Approx(0.048));
  check_near(bounds(box).high, {0.1, 0.2, 0.3});

  const TriangleMesh cylinder = palm(R"(<cylinder radius="0.1" length="0.4"/>)");
  CHECK(signed_volume(cylinder) == doctest::Approx(pi * 0.01 * 0.4).epsilon(0.01));
  check_near(bounds(cylinder).low, {-0.1, -0.1, -0.2});

  const TriangleMesh sphere = palm(R"(<sphere radius="0.1"/>)");
  CHECK(signed_volume(sphere) == doctest::Approx(pi * 4 / 3 * 0.001).epsilon(0.02));
  check_near(bounds(sphere).high, {0.1, 0.1, 0.1});

  const TriangleMesh capsule = palm(R"(<capsule radius="0.1" length="0.4"/>)");
  CHECK(signed_volume(capsule) == doctest::Approx(pi * 4 / 3 * 0.001 + pi * 0.01 * 0.4).epsilon(0.02));
  check_near(bounds(capsule).high, {0.1, 0.1, 0.3});
}

TEST_CASE("every edge of a primitive is shared by two triangles that run along it in opposite directions") {
  for (const char* shape : {R"(<cylinder radius="1" length="2"/>)", R"(<sphere radius="1"/>)",
                            R"(<capsule radius="1" length="2"/>)", small_box}) {
    const TriangleMesh m = load(one_finger(visual(shape))).links[0].mesh;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> edges;
    for (const auto& t : m.triangles)
      for (std::size_t i = 0; i < 3; ++i) edges.emplace_back(t[i], t[(i + 1) % 3]);
    std::ranges::sort(edges);
    CHECK(std::ranges::adjacent_find(edges) == edges.end());
    for (const auto& [from, to] : edges) CHECK(std::ranges::binary_search(edges, std::pair(to, from)));
  }
}

TEST_CASE("a shape of size zero is no geometry, a negative size is an error") {
  CHECK(load(one_finger(visual(R"(<sphere radius="0"/>)"))).links[0].mesh.triangles.empty());
  CHECK(load(one_finger(visual(R"(<box size="0 0 0"/>)"))).links[0].mesh.vertices.empty());
  check_load_error(one_finger(visual(R"(<sphere radius="-1"/>)")), ErrorCode::invalid_model,
                   {"link 'palm'", "negative"});
}

TEST_CASE("visual falls back to collision, collision to visual; both merges them") {
  const std::string v = visual(small_box), c = collision(R"(<sphere radius="0.1"/>)");
  const auto triangles = [](const std::string& palm, GeometrySource geometry) {
    ModelLoadOptions options;
    options.geometry = geometry;
    return load(one_finger(palm), options).links[0].mesh.triangles.size();
  };
  using enum GeometrySource;
  const std::size_t box = 12, sphere = triangles(c, collision);
  CHECK(sphere > 100);
  CHECK(triangles(v + c, visual) == box);
  CHECK(triangles(v + c, collision) == sphere);
  CHECK(triangles(v + c, both) == box + sphere);
  CHECK(triangles(c, visual) == sphere);
  CHECK(triangles(v, collision) == box);
  CHECK(triangles(v, both) == box);
  CHECK(triangles("", visual) == 0);
  CHECK(triangles("<visual/><collision><geometry/></collision>", visual) == 0);
}

TEST_CASE("several visuals of a link are merged") {
  CHECK(load(one_finger(visual(small_box) + visual(small_box, R"(<origin xyz="1 0 0"/>)")))
            .links[0]
            .mesh.triangles.size() == 24);
}

TEST_CASE("a mesh in millimetres is a warning that names it and the remedy") {
  const ScratchFolder folder;
  folder.write("big.stl", ascii_stl());
  const auto warnings = [&](const std::string& scale) {
    return load_hand_model(folder.write("hand.urdf", one_finger(visual(mesh("big.stl", "scale=\"" + scale + "\"")))))
        .warnings;
  };
  CHECK(warnings("1 1 1").empty());
  REQUIRE(warnings("1000 1000 1000").size() == 1);
  CHECK(warnings("1000 1000 1000")[0].find("big.stl") != std::string::npos);
  CHECK(warnings("1000 1000 1000")[0].find("millimetres? then give it scale=\"0.001 0.001 0.001\"") !=
        std::string::npos);
  REQUIRE(warnings("0.0001 0.0001 0.0001").size() == 1);
  CHECK(warnings("0.0001 0.0001 0.0001")[0].find("remove its scale") != std::string::npos);
}

TEST_CASE("meshes that are missing, empty, corrupt or of another format") {
  check_load_error(one_finger(visual(mesh("gone.stl"))), ErrorCode::file_unreadable, {"gone.stl", "does not exist"});
  check_mesh_error("a.step", "x", ErrorCode::invalid_mesh, {"'.step' cannot be read", "convert"});
  check_mesh_error("a.md5mesh", "MD5Version 10", ErrorCode::invalid_mesh, {"cannot be read"});
  for (const char* extension : {"stl", "obj", "dae", "ply", "glb", "gltf"}) {
    const std::string name = std::string("bad.") + extension;
    check_mesh_error(name, "", ErrorCode::invalid_mesh, {name});
    check_mesh_error(name, "This is no mesh.", ErrorCode::invalid_mesh, {name});
  }
  check_mesh_error("a.obj", "v 0 0 0\nv 1 0 0\nl 1 2\n", ErrorCode::invalid_mesh, {"a.obj"});
  check_mesh_error("a.ply", binary_ply().substr(0, 220), ErrorCode::invalid_mesh, {"a.ply"});
  check_mesh_error("a.glb", glb().substr(0, 300), ErrorCode::invalid_mesh, {"a.glb"});
  check_mesh_error("a.stl", binary_stl().substr(0, 200), ErrorCode::invalid_mesh, {"a.stl"});
}

TEST_CASE("a vertex that is not finite") {
  check_mesh_error(
      "a.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
      ErrorCode::invalid_mesh, {"a.ply", "not finite"});
}

TEST_CASE("an index beyond the vertices") {
  std::string bytes = binary_ply();
  bytes[bytes.size() - 4] = 100;
  check_mesh_error("a.ply", bytes, ErrorCode::invalid_mesh, {"a.ply"});
}

TEST_CASE("bounds on the bytes of a mesh and on the triangles of a hand") {
  const ScratchFolder folder;
  folder.write("a.stl", ascii_stl());
  const std::string urdf = folder.write("hand.urdf", one_finger(visual(mesh("a.stl")) + visual(mesh("a.stl"))));
  ModelLoadOptions options;
  options.max_triangles = 8;
  CHECK(load_hand_model(urdf, options).links[0].mesh.triangles.size() == 8);
  options.max_triangles = 7;
  check_error([&] { load_hand_model(urdf, options); }, ErrorCode::limit_exceeded, {"bound of 7"});
  options.max_triangles = 3;
  check_error([&] { load_hand_model(urdf, options); }, ErrorCode::limit_exceeded, {"a.stl", "bound of 3"});
  options = {};
  options.max_mesh_bytes = 100;
  check_error([&] { load_hand_model(urdf, options); }, ErrorCode::limit_exceeded, {"a.stl", "bound of 100"});
}

TEST_CASE("few triangles and very many vertices") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 13\nproperty uchar x\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  std::string points;
  for (int i = 0; i < 9; ++i) points += "p 1 2 3 4\n";
  const std::vector<std::pair<std::string, std::string>> meshes{
      {"a.ply", header + std::string("0 0 0 0 0 0 0 0 0 0 0 0 0 ") + "3 0 1 2\n"}, {"a.obj", obj(points)}};
  for (const auto& file : meshes) {
    const std::string& name = file.first;
    CAPTURE(name);
    const ScratchFolder folder;
    folder.write(name, file.second);
    const std::string urdf = folder.write("hand.urdf", one_finger(visual(mesh(name))));
    ModelLoadOptions options;
    options.max_triangles = 4;
    check_error([&] { load_hand_model(urdf, options); }, ErrorCode::limit_exceeded,
                {name, "raise ModelLoadOptions::max_triangles"});
  }
}

TEST_CASE("vertices that no triangle uses count toward the bound of a hand") {
  const std::string header =
      "ply\nformat ascii 1.0\nelement vertex 10\nproperty uchar x\nproperty uchar y\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const ScratchFolder folder;
  folder.write("a.ply", header + "0 0  1 0  0 1  0 0  0 0  0 0  0 0  0 0  0 0  0 0  3 0 1 2\n");
  const std::string twice = folder.write("hand.urdf", one_finger(visual(mesh("a.ply")) + visual(mesh("a.ply"))));
  ModelLoadOptions options;
  options.max_triangles = 7;
  CHECK(load_hand_model(twice, options).links[0].mesh.vertices.size() == 6);
  options.max_triangles = 6;
  check_error([&] { load_hand_model(twice, options); }, ErrorCode::limit_exceeded,
              {"hand.urdf: the meshes have more vertices than the bound of 18"});
}

TEST_CASE("a scale that is zero, of two numbers, or no number") {
  for (const char* scale : {"0 1 1", "1 1", "a b c", "nan 1 1"})
    check_load_error(one_finger(visual(mesh("a.stl", "scale=\"" + std::string(scale) + "\""))),
                     ErrorCode::invalid_model, {"palm", "cale"});
}

TEST_CASE("an unknown shape is an error, not a link without geometry") {
  check_load_error(one_finger(visual("<plane/>")), ErrorCode::invalid_model, {"plane", "palm"});
}

TEST_CASE("a GLB that claims a billion vertices is refused before they are allocated") {
  check_mesh_error("a.glb", glb("", "1000000000"), ErrorCode::limit_exceeded, {"a.glb", "claims far more"});
  check_mesh_error("a.glb", glb("", "-1"), ErrorCode::limit_exceeded, {"a.glb"});
  check_mesh_error("a.glb", glb("", "\"four\""), ErrorCode::invalid_mesh, {"a.glb", "glTF"});
}

TEST_CASE("nodes of a glTF that form no trees are refused before they are copied") {
  const auto with_nodes = [](const std::string& nodes, const std::string& scene = "[0]") {
    std::string text = gltf(R"("uri":"a.bin")");
    text.replace(text.find(R"([{"mesh":0}])"), std::string(R"([{"mesh":0}])").size(), nodes);
    return text.replace(text.find("[0]"), 3, scene);
  };
  std::string doubling = "[";
  for (int i = 1; i <= 60; ++i) {  // 2^60 ways lead to the last node
    const std::string next = std::to_string(i);
    doubling += R"({"children":[)" + next + "," + next + "]},";
  }
  const std::vector<std::string> word{"a.gltf", "no tree"};
  check_mesh_error("a.gltf", with_nodes(doubling + R"({"mesh":0}])"), ErrorCode::invalid_mesh, word);
  check_mesh_error("a.gltf", with_nodes(R"([{"children":[1]},{"children":[0],"mesh":0}])"), ErrorCode::invalid_mesh,
                   word);
  check_mesh_error("a.gltf", with_nodes(R"([{"mesh":0}])", "[0,0]"), ErrorCode::invalid_mesh, word);
  check_mesh_error("a.gltf", with_nodes(R"([{"children":[1]},{"mesh":0}])", "[0,1]"), ErrorCode::invalid_mesh, word);
  check_mesh_error("a.gltf", with_nodes(R"([{"children":[2],"mesh":0}])"), ErrorCode::invalid_mesh,
                   {"a node that does not exist"});
}

TEST_CASE("nodes of a DAE that stand for others, and without end in a child process") {
  // the tetrahedron of `dae` in a library, and a scene that stands for the node `first` of it
  const auto with_library = [](const std::string& nodes) {
    std::string text = dae("Z_UP");
    const std::string scenes = "<library_visual_scenes>";
    text.insert(text.find(scenes), "<library_nodes>" + nodes + "</library_nodes>");
    const std::string geometry = R"(<instance_geometry url="#g"/>)";
    return text.replace(text.rfind(geometry), geometry.size(), R"(<instance_node url="#first"/>)");
  };
  const auto node = [](const std::string& id, const std::string& content) {
    return "<node id=\"" + id + "\" name=\"last\">" + content + "</node>";
  };
  const auto stand_for = [](const std::string& id) { return "<instance_node url=\"#" + id + "\"/>"; };
  const std::string last = node("last", R"(<instance_geometry url="#g"/>)");

  const ScratchFolder folder;
  folder.write("a.dae", with_library(node("first", stand_for("last") + stand_for("last")) + last));
  const std::string urdf = folder.write("hand.urdf", one_finger(visual(mesh("a.dae"))));
  CHECK(load_hand_model(urdf).links[0].mesh.triangles.size() == 8);

  std::string doubling = node("first", stand_for("n0") + stand_for("n0"));
  for (int i = 0; i < 60; ++i) {
    const std::string next = i < 59 ? "n" + std::to_string(i + 1) : "last";
    doubling += node("n" + std::to_string(i), stand_for(next) + stand_for(next));
  }
  ModelLoadOptions options;
  options.in_child = {.max_memory_bytes = 256u << 20, .max_seconds = 5};
  for (const std::string& nodes :
       {doubling + last, node("first", stand_for("second")) + node("second", stand_for("first"))}) {
    folder.write("a.dae", with_library(nodes));
    try {
      load_hand_model(urdf, options);
      FAIL("a scene without end was read");
    } catch (const Error& error) {
      CHECK(std::string(error.what()).find("a.dae") != std::string::npos);
    }
  }
}

TEST_CASE("glTF and DAE nested beyond any real file") {
  check_mesh_error("a.gltf", std::string(1'000'000, '['), ErrorCode::limit_exceeded, {"a.gltf", "nested"});
  std::string nodes;
  for (int i = 0; i < 100'000; ++i) nodes += "<node>";
  check_mesh_error("a.dae", dae("Z_UP", "1", nodes), ErrorCode::limit_exceeded, {"a.dae:1", "nested"});
}

TEST_CASE("a DAE whose indices are no numbers, or which counts more than it can hold") {
  const auto changed = [](const std::string& from, const std::string& to) {
    std::string text = dae("Z_UP");
    return text.replace(text.find(from), from.size(), to);
  };
  for (const char* indices :
       {"<p>0 z 1", "<p><![CDATA[z]]>0 2 1", "<p><!-- --> z 2 1", "<p><x/>z 2 1", "<p>0 &#122; 1"})
    check_mesh_error("a.dae", changed("<p>0 2 1", indices), ErrorCode::invalid_mesh, {"a.dae:1", "list of indices"});
  for (const char* count : {"4000000000", "-1", "0x10", "&#57;999", ""})
    check_mesh_error("a.dae", changed("<triangles count=\"4\"", "<triangles count = '" + std::string(count) + "'"),
                     ErrorCode::limit_exceeded, {"a.dae:1", "count='" + std::string(count) + "'"});
  CHECK(palm_mesh("a.dae", changed("<p>0 2 1", "<p a='>'><!-- z -->\n0\t2 1")).triangles.size() == 4);
}

TEST_CASE("a mesh that brings assimp down is an error where a child process reads it") {
  const ScratchFolder folder;
  std::string text = dae("Z_UP");
  text.replace(text.find("stride=\"3\""), 10, "stride=\"900000000\"");
  folder.write("a.dae", text);
  folder.write("good.stl", binary_stl());
  const std::string urdf = folder.write("hand.urdf", one_finger(visual(mesh("good.stl")) + visual(mesh("a.dae"))));
  ModelLoadOptions options;
  options.in_child.emplace();
  check_error([&] { load_hand_model(urdf, options); }, ErrorCode::invalid_mesh, {"a.dae: ", "was brought down"});
}

TEST_CASE("a chain of glTF nodes beyond any real file") {
  const auto chain_of = [](int nodes) {
    std::string chain;
    for (int i = 1; i < nodes; ++i) chain += (i > 1 ? ",{" : "") + ("\"children\":[" + std::to_string(i)) + "]}";
    return glb(chain + R"(,{"name":"last")");
  };
  check_tetrahedron(palm_mesh("a.glb", chain_of(150)));
  check_mesh_error("a.glb", chain_of(250), ErrorCode::invalid_mesh,
                   {"a.glb: the nodes of the file are nested too deep"});
}

TEST_CASE("a PLY cut short or damaged at any byte gives a mesh or an error") {
  const std::string whole = binary_ply();
  int errors = 0;
  const auto try_to_read = [&](const std::string& bytes) {
    try {
      palm_mesh("a.ply", bytes);
    } catch (const Error&) {
      ++errors;
    }
  };
  for (std::size_t i = 0; i < whole.size(); ++i) {
    try_to_read(whole.substr(0, i));
    for (const char byte : {'\0', '\x7f', '\xff'}) {
      std::string damaged = whole;
      damaged[i] = byte;
      try_to_read(damaged);
    }
  }
  CHECK(errors > static_cast<int>(whole.size()));
}

TEST_CASE("a big-endian PLY with other elements, double coordinates and a quadrangle") {
  std::string bytes =
      "ply\r\nformat binary_big_endian 1.0\r\ncomment made by a test\r\nelement camera 1\r\nproperty list uchar short "
      "x\r\n"
      "element vertex 4\r\nproperty double x\r\nproperty double y\r\nproperty double z\r\nproperty uchar red\r\n"
      "element face 1\r\nproperty list uchar ushort vertex_index\r\nend_header\r\n";
  const auto append_big_endian = [&](auto value) {
    std::string raw;
    append_bytes(raw, value);
    bytes.append(raw.rbegin(), raw.rend());
  };
  bytes += std::string("\x02", 1) + std::string(4, '\x01');
  for (const auto& [x, y] : {std::pair{0.0, 0.0}, {2.0, 0.0}, {2.0, 3.0}, {0.0, 3.0}}) {
    for (const double c : {x, y, 0.0}) append_big_endian(c);
    bytes += '\xff';
  }
  bytes += '\x04';
  for (std::uint16_t v = 0; v < 4; ++v) append_big_endian(v);
  const TriangleMesh m = palm_mesh("a.ply", bytes);
  CHECK(m.triangles.size() == 2);
  check_near(bounds(m).high, {2, 3, 0});
}
