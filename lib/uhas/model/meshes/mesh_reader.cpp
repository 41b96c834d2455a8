#include "uhas/model/meshes/mesh_reader.hpp"

#include <assimp/BaseImporter.h>
#include <assimp/MemoryIOWrapper.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <algorithm>
#include <array>
#include <assimp/IOSystem.hpp>
#include <assimp/Importer.hpp>
#include <exception>
#include <map>
#include <memory>
#include <new>
#include <sstream>
#include <string_view>

#include "uhas/base/errors.hpp"
#include "uhas/fence/child_process.hpp"
#include "uhas/files/file_bytes.hpp"
#include "uhas/model/meshes/collada_bounds.hpp"
#include "uhas/model/meshes/gltf_bounds.hpp"
#include "uhas/model/meshes/mesh_bounds.hpp"
#include "uhas/model/meshes/mesh_bytes.hpp"
#include "uhas/model/meshes/ply_reader.hpp"
#include "uhas/model/urdf/xml_bounds.hpp"

namespace uhas {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 6> known_extensions{"stl", "obj", "dae", "ply", "glb", "gltf"};

std::string lower_case_extension(const fs::path& path) {
  std::string extension = path.extension().string();
  if (!extension.empty()) extension.erase(0, 1);
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

/// All that assimp sees of the file system: the mesh file, and the buffers beside a glTF file. Materials and textures
/// do not exist, so that they are neither needed nor read.
class MeshFiles : public Assimp::IOSystem {
 public:
  MeshFiles(fs::path mesh, std::string reference, const ModelLoadOptions& options, const MeshFolders& folders,
            SourceLog& sources)
      : mesh_(std::move(mesh)),
        reference_(std::move(reference)),
        options_(options),
        folders_(folders),
        sources_(sources) {}

  const std::vector<std::byte>& mesh_bytes() { return content(mesh_); }

  bool Exists(const char* file) const override {
    std::error_code ignored;
    return allowed(file) && fs::is_regular_file(file, ignored);
  }
  char getOsSeparator() const override { return '/'; }
  Assimp::IOStream* Open(const char* file, const char*) override {
    if (!Exists(file)) return nullptr;
    const std::vector<std::byte>& bytes = content(file);
    return new Assimp::MemoryIOStream(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
  }
  void Close(Assimp::IOStream* stream) override { delete stream; }

 private:
  bool allowed(const fs::path& file) const {
    return file == mesh_ ||
           (lower_case_extension(mesh_) == "gltf" && lower_case_extension(file) == "bin" && folders_.hold(file));
  }

  const std::vector<std::byte>& content(const fs::path& file) {
    const auto [entry, is_new] = contents_.try_emplace(file);
    if (is_new) {
      entry->second =
          read_file(file, options_.max_mesh_bytes, "simplify the mesh or raise ModelLoadOptions::max_mesh_bytes");
      const fs::path beside = fs::path(reference_).parent_path() / file.lexically_relative(mesh_.parent_path());
      sources_.add(file, file == mesh_ ? reference_ : beside.generic_string(), entry->second);
    }
    return entry->second;
  }

  fs::path mesh_;
  std::string reference_;
  const ModelLoadOptions& options_;
  const MeshFolders& folders_;
  SourceLog& sources_;
  std::map<fs::path, std::vector<std::byte>> contents_;
};

/// Leaves in `importer` only the readers of that file extension.
void restrict_to(const std::string& extension, Assimp::Importer& importer) {
  for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
    std::istringstream list(importer.GetImporterInfo(i)->mFileExtensions);
    bool wanted = false;
    for (std::string known; list >> known;) wanted |= known == extension;
    if (wanted) continue;
    const std::unique_ptr<Assimp::BaseImporter> unwanted(importer.GetImporter(i));
    importer.UnregisterLoader(unwanted.get());
  }
}

/// An affine map in double precision; nodes may scale and mirror.
struct Affine {
  std::array<Vector3d, 3> rows{Vector3d{1, 0, 0}, Vector3d{0, 1, 0}, Vector3d{0, 0, 1}};
  Vector3d translation;

  Vector3d linear(Vector3d v) const { return {dot(rows[0], v), dot(rows[1], v), dot(rows[2], v)}; }
  Vector3d operator()(Vector3d p) const { return linear(p) + translation; }
  bool mirrors() const { return dot(cross(rows[0], rows[1]), rows[2]) < 0; }

  friend Affine operator*(const Affine& a, const Affine& b) {
    Affine c;
    for (std::size_t i = 0; i < 3; ++i)
      c.rows[i] = a.rows[i].x * b.rows[0] + a.rows[i].y * b.rows[1] + a.rows[i].z * b.rows[2];
    c.translation = a(b.translation);
    return c;
  }
};

Affine to_affine(const aiMatrix4x4& m) {
  return {{Vector3d{m.a1, m.a2, m.a3}, Vector3d{m.b1, m.b2, m.b3}, Vector3d{m.c1, m.c2, m.c3}}, {m.a4, m.b4, m.c4}};
}

class SceneFlattener {
 public:
  SceneFlattener(const aiScene& scene, std::string file, std::uint64_t max_triangles)
      : scene_(scene), file_(std::move(file)), max_triangles_(max_triangles) {}

  TriangleMesh flatten() {
    append(*scene_.mRootNode, Affine{}, 0);
    return std::move(mesh_);
  }

 private:
  static constexpr int max_depth = 200;

  [[noreturn]] void fail(const std::string& problem) const {
    throw Error(ErrorCode::invalid_mesh, file_, problem, "export the mesh again");
  }

  void append(const aiNode& node, const Affine& T_file_parent, int depth) {
    if (depth > max_depth) fail("the nodes of the file are nested too deep");
    const Affine T_file_node = T_file_parent * to_affine(node.mTransformation);
    for (unsigned i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) fail("a node names a mesh that does not exist");
      append(*scene_.mMeshes[node.mMeshes[i]], T_file_node);
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) append(*node.mChildren[i], T_file_node, depth + 1);
  }

  void append(const aiMesh& part, const Affine& T_file_part) {
    require_within_bounds(mesh_.triangles.size() + part.mNumFaces, mesh_.vertices.size() + part.mNumVertices,
                          max_triangles_, "the mesh has", file_);
    const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
    for (unsigned v = 0; v < part.mNumVertices; ++v) {
      const aiVector3D& p = part.mVertices[v];
      mesh_.vertices.push_back(T_file_part(Vector3d{p.x, p.y, p.z}));
      if (!is_finite(mesh_.vertices.back())) fail("the mesh has a vertex that is not finite");
    }
    const bool mirrored = T_file_part.mirrors();
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      if (face.mNumIndices != 3) continue;
      std::array<std::uint32_t, 3> triangle{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        if (face.mIndices[corner] >= part.mNumVertices) fail("a triangle names a vertex that does not exist");
        triangle[corner] = first + face.mIndices[corner];
      }
      if (mirrored) std::swap(triangle[1], triangle[2]);
      mesh_.triangles.push_back(triangle);
    }
  }

  const aiScene& scene_;
  std::string file_;
  std::uint64_t max_triangles_;
  TriangleMesh mesh_;
};

/// What fails for want of memory is no fault of the file, which assimp would blame.
void rethrow_want_of_memory(const std::exception_ptr& exception) {
  try {
    std::rethrow_exception(exception);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {
  }
}

TriangleMesh read_with_assimp(const fs::path& path, const std::string& extension, std::unique_ptr<MeshFiles> files,
                              std::uint64_t max_triangles) {
  Assimp::Importer importer;
  restrict_to(extension, importer);
  importer.SetIOHandler(files.release());  // the importer owns it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  importer.SetPropertyBool(AI_CONFIG_IMPORT_NO_SKELETON_MESHES, true);
  const aiScene* scene = importer.ReadFile(path.string(), aiProcess_Triangulate);
  if (importer.GetException()) rethrow_want_of_memory(importer.GetException());
  if (scene == nullptr || scene->mRootNode == nullptr)
    throw Error(ErrorCode::invalid_mesh, path,
                std::string("the mesh cannot be read (") + importer.GetErrorString() + ")", "export the mesh again");
  return SceneFlattener(*scene, path, max_triangles).flatten();
}

TriangleMesh read_mesh(const MeshFile& file, const ModelLoadOptions& options, const MeshFolders& folders,
                       SourceLog& sources) {
  const auto& [path, reference] = file;
  const std::string extension = lower_case_extension(path);
  if (std::ranges::find(known_extensions, extension) == known_extensions.end())
    throw Error(ErrorCode::invalid_mesh, path, "meshes of the type '." + extension + "' cannot be read",
                "convert it to STL, OBJ, DAE, PLY, GLB or glTF");

  auto files = std::make_unique<MeshFiles>(path, reference, options, folders, sources);
  const std::vector<std::byte>& bytes = files->mesh_bytes();
  if (bytes.empty()) throw Error(ErrorCode::invalid_mesh, path, "the mesh file is empty", "export the mesh again");
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  if (extension == "dae") check_xml_bounds(text, path), check_collada_bounds(text, path);
  if (extension == "glb" || extension == "gltf") check_gltf_bounds(text, path);
  TriangleMesh mesh = extension == "ply" ? read_ply(bytes, path, options.max_triangles)
                                         : read_with_assimp(path, extension, std::move(files), options.max_triangles);
  if (mesh.triangles.empty())
    throw Error(ErrorCode::invalid_mesh, path, "the mesh has no triangle", "export the mesh again");
  return mesh;
}

}  // namespace

std::vector<TriangleMesh> read_meshes(std::span<const MeshFile> files, const ModelLoadOptions& options,
                                      const MeshFolders& folders, SourceLog& sources) {
  std::vector<TriangleMesh> meshes;
  std::uint64_t triangles = 0, vertices = 0;
  const auto read = [&](const MeshFile& file) {
    TriangleMesh mesh = read_mesh(file, options, folders, sources);
    triangles += mesh.triangles.size();
    vertices += mesh.vertices.size();
    require_within_bounds(triangles, vertices, options.max_triangles, "with the meshes before it, the mesh has",
                          file.path);
    return mesh;
  };
  if (!options.in_child) {
    for (const MeshFile& file : files) meshes.push_back(read(file));
    return meshes;
  }
  if (files.empty()) return meshes;
  ChildProcess child(*options.in_child, ErrorCode::invalid_mesh, files.front().path, files.size(), [&](std::size_t i) {
    TriangleMesh mesh = read(files[i]);
    return to_bytes({std::move(mesh), sources.files()});
  });
  for (const MeshFile& file : files) {
    ReadMesh answer = read_mesh_from_bytes(child.next(file.path), file.path);
    meshes.push_back(std::move(answer.mesh));
    sources.replace(std::move(answer.sources));
  }
  return meshes;
}

}  // namespace uhas
