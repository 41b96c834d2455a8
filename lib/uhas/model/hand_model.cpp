#include "uhas/model/hand_model.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <map>
#include <span>
#include <string_view>

#include "uhas/base/errors.hpp"
#include "uhas/fence/child_process.hpp"
#include "uhas/files/file_bytes.hpp"
#include "uhas/model/meshes/mesh_bounds.hpp"
#include "uhas/model/meshes/mesh_folders.hpp"
#include "uhas/model/meshes/mesh_path.hpp"
#include "uhas/model/meshes/mesh_reader.hpp"
#include "uhas/model/meshes/primitives.hpp"
#include "uhas/model/meshes/source_file.hpp"
#include "uhas/model/urdf/link_order.hpp"
#include "uhas/model/urdf/urdf_reader.hpp"

namespace uhas {
namespace {

namespace fs = std::filesystem;

// A part of a hand in its true unit is between 1/100 of the skeleton and a few times it; one in millimetres is a
// thousand times larger. The bounds lie between.
constexpr double suspiciously_large = 20;
constexpr double suspiciously_small = 1e-3;

// Twice the area below which a triangle has no usable normal, relative to the square of its longest edge.
constexpr double degenerate_area = 1e-9;

bool is_degenerate(Vector3d a, Vector3d b, Vector3d c) {
  const double longest = std::max({norm(b - a), norm(c - b), norm(a - c)});
  return !(norm(cross(b - a, c - a)) > degenerate_area * longest * longest);
}

/// Length of the diagonal of the bounding box.
double extent(const TriangleMesh& mesh, Vector3d scale) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vector3d low{infinity, infinity, infinity}, high = -low;
  for (const Vector3d& p : mesh.vertices) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vector3d size = high - low;
  return norm(Vector3d{size.x * scale.x, size.y * scale.y, size.z * scale.z});
}

/// Length of the longest chain of joint origins.
double skeleton_extent(const Urdf& urdf, const std::vector<OrderedLink>& order) {
  std::vector<double> reach(order.size());
  for (std::size_t i = 1; i < order.size(); ++i)
    reach[i] = reach[order[i].parent] + norm(urdf.joints[order[i].joint].joint.T_parent_joint.translation);
  return *std::ranges::max_element(reach);
}

/// The surfaces of links: mesh files are read first, all together, then placed with the other shapes.
class GeometryLoader {
 public:
  GeometryLoader(std::string urdf_file, const ModelLoadOptions& options, SourceLog& sources)
      : urdf_file_(std::move(urdf_file)), options_(options), folders_(urdf_file_, options), sources_(sources) {}

  /// @param skeleton  extent of the hand's skeleton (m), which tells meshes in other units
  void read_mesh_files(std::span<const UrdfLink* const> links, double skeleton, std::vector<std::string>& warnings) {
    std::vector<MeshFile> files;
    std::vector<const UrdfShape*> first_users;
    std::map<fs::path, std::size_t> known;  // hands use one file for several links; each is read once
    for (const UrdfLink* link : links)
      for (const UrdfShape* shape : shapes_of(*link)) {
        if (shape->kind != UrdfShape::Kind::mesh) continue;
        const fs::path folder = fs::path(urdf_file_).parent_path();
        const fs::path path = find_mesh(shape->mesh_reference, folder, options_.packages, urdf_file_);
        const auto [entry, is_new] = known.try_emplace(path.lexically_normal(), files.size());
        mesh_of_shape_[shape] = entry->second;
        if (!is_new) continue;
        folders_.require(path, shape->mesh_reference);
        files.push_back({path, shape->mesh_reference});
        first_users.push_back(shape);
      }
    meshes_ = read_meshes(files, options_, folders_, sources_);
    for (std::size_t i = 0; i < files.size(); ++i)
      warn_about_units(files[i].reference, extent(meshes_[i], first_users[i]->mesh_scale), skeleton, warnings);
  }

  TriangleMesh surface_of(const UrdfLink& link) {
    TriangleMesh result;
    for (const UrdfShape* shape : shapes_of(link)) append(*shape, result);
    return result;
  }

 private:
  std::vector<const UrdfShape*> shapes_of(const UrdfLink& link) const {
    const bool wants_visual = options_.geometry != GeometrySource::collision;
    const bool wants_collision = options_.geometry != GeometrySource::visual;
    std::vector<const UrdfShape*> shapes;
    if (wants_visual || link.collision.empty())
      for (const UrdfShape& shape : link.visual) shapes.push_back(&shape);
    if (wants_collision || link.visual.empty())
      for (const UrdfShape& shape : link.collision) shapes.push_back(&shape);
    return shapes;
  }

  void append(const UrdfShape& shape, TriangleMesh& result) {
    switch (shape.kind) {
      case UrdfShape::Kind::box: return append(tessellate_box(shape.box_size), shape, result);
      case UrdfShape::Kind::cylinder: return append(tessellate_cylinder(shape.radius, shape.length), shape, result);
      case UrdfShape::Kind::capsule: return append(tessellate_capsule(shape.radius, shape.length), shape, result);
      case UrdfShape::Kind::sphere: return append(tessellate_sphere(shape.radius), shape, result);
      case UrdfShape::Kind::mesh: return append(meshes_[mesh_of_shape_.at(&shape)], shape, result);
    }
  }

  // Scales and places `source`; vertices that no triangle uses are left behind.
  void append(const TriangleMesh& source, const UrdfShape& shape, TriangleMesh& result) {
    triangle_count_ += source.triangles.size();
    vertex_count_ += source.vertices.size();
    require_within_bounds(triangle_count_, vertex_count_, options_.max_triangles, "the meshes have", urdf_file_);

    // a negative scale turns the mesh inside out, so its triangles run the other way
    const Vector3d scale = shape.mesh_scale;
    const bool mirrored = scale.x * scale.y * scale.z < 0;
    constexpr auto unused = std::numeric_limits<std::uint32_t>::max();
    std::vector<std::uint32_t> index_in_result(source.vertices.size(), unused);
    const auto place = [&](std::uint32_t vertex) {
      const Vector3d p = source.vertices[vertex];
      return shape.T_link_shape * Vector3d{scale.x * p.x, scale.y * p.y, scale.z * p.z};
    };
    for (std::array<std::uint32_t, 3> triangle : source.triangles) {
      if (mirrored) std::swap(triangle[1], triangle[2]);
      if (is_degenerate(place(triangle[0]), place(triangle[1]), place(triangle[2]))) continue;
      for (std::uint32_t& vertex : triangle) {
        std::uint32_t& index = index_in_result[vertex];
        if (index == unused) {
          index = static_cast<std::uint32_t>(result.vertices.size());
          result.vertices.push_back(place(vertex));
        }
        vertex = index;
      }
      result.triangles.push_back(triangle);
    }
  }

  static void warn_about_units(const std::string& reference, double mesh, double skeleton,
                               std::vector<std::string>& warnings) {
    if (skeleton > 0 && mesh > suspiciously_large * skeleton)
      warnings.push_back("mesh " + reference + " is " + std::to_string(mesh) + " m across on a skeleton of " +
                         std::to_string(skeleton) +
                         " m; is it in millimetres? then give it scale=\"0.001 0.001 0.001\" in the URDF");
    if (mesh < suspiciously_small * skeleton)
      warnings.push_back("mesh " + reference + " is " + std::to_string(1000 * mesh) + " mm across on a skeleton of " +
                         std::to_string(skeleton) +
                         " m; is it in metres, but scaled as if in millimetres? then remove its scale in the URDF");
  }

  std::string urdf_file_;
  const ModelLoadOptions& options_;
  MeshFolders folders_;
  SourceLog& sources_;
  std::map<const UrdfShape*, std::size_t> mesh_of_shape_;  // into `meshes_`
  std::vector<TriangleMesh> meshes_;
  std::uint64_t triangle_count_ = 0, vertex_count_ = 0;  // of all shapes, those that are left behind too
};

/// Folds fixed joints: `links` get their carrying joint, `tree` the movable joints in the order of their child links.
void build_tree(const Urdf& urdf, const std::vector<OrderedLink>& order, const std::vector<FlatMimic>& mimics,
                HandModel& model) {
  // a link hangs on its parent's joint by a fixed transform, or on a movable joint of its own
  std::vector<int> index_in_tree(urdf.joints.size(), -1);
  std::vector<int> index_in_urdf;
  for (const OrderedLink& ordered : order) {
    ModelLink link{urdf.links[ordered.link].name, ordered.parent, -1, {}, {}};
    if (ordered.parent >= 0) {
      const ModelLink& parent = model.links[ordered.parent];
      const UrdfJoint& above = urdf.joints[ordered.joint];
      link.joint = parent.joint;
      link.T_joint_link = parent.T_joint_link * above.joint.T_parent_joint;
      if (!above.fixed) {
        Joint joint = above.joint;
        joint.parent = parent.joint;
        joint.T_parent_joint = link.T_joint_link;
        link.joint = static_cast<int>(model.tree.joints.size());
        link.T_joint_link = {};
        index_in_tree[ordered.joint] = link.joint;
        index_in_urdf.push_back(ordered.joint);
        model.tree.joints.push_back(std::move(joint));
      }
    }
    model.links.push_back(std::move(link));
  }

  // masters by their index in the tree
  for (std::size_t j = 0; j < model.tree.joints.size(); ++j) {
    const FlatMimic& mimic = mimics[index_in_urdf[j]];
    if (mimic.master < 0) continue;
    Joint& joint = model.tree.joints[j];
    joint.mimic_master = index_in_tree[mimic.master];
    joint.mimic_multiplier = mimic.multiplier;
    joint.mimic_offset = mimic.offset;
  }
}

}  // namespace

std::vector<std::byte> read_urdf_file(const std::string& urdf_path, const ModelLoadOptions& options) {
  return read_file(urdf_path, options.max_urdf_bytes,
                   "cut the hand out of its robot or raise ModelLoadOptions::max_urdf_bytes");
}

HandModel load_hand_model(const std::string& urdf_path, const ModelLoadOptions& options) {
  if (urdf_path.ends_with(".xacro"))
    throw Error(ErrorCode::syntax, urdf_path, "this is a xacro file, not a URDF",
                "expand it first: xacro " + urdf_path + " > hand.urdf");

  // the URDF
  const std::vector<std::byte> bytes = read_urdf_file(urdf_path, options);
  const std::string text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  const auto read = [&] { return read_urdf(text, urdf_path, options.max_links); };
  if (options.in_child)  // a rehearsal: this process reads the same bytes in the same state
    in_child(*options.in_child, ErrorCode::invalid_model, urdf_path, [&] { return read(), std::vector<std::byte>(); });
  const Urdf urdf = read();
  const std::vector<OrderedLink> order = order_links(urdf, urdf_path);

  // its links and joints
  HandModel model;
  model.name = urdf.name;
  build_tree(urdf, order, flatten_mimics(urdf, urdf_path), model);
  if (model.tree.joints.empty())
    throw Error(ErrorCode::invalid_model, urdf_path, "the model has no movable joint", "name the URDF of a hand");
  for (const Joint& joint : model.tree.joints)
    if (joint.lower == joint.upper)
      model.warnings.push_back("joint '" + joint.name + "' cannot move: its lower and upper limits are equal");

  // their surfaces, and the files that these were read from
  SourceLog sources(fs::path(urdf_path).parent_path());
  sources.add(urdf_path, urdf_path, bytes);
  if (options.load_meshes) {
    std::vector<const UrdfLink*> links;
    for (const OrderedLink& ordered : order) links.push_back(&urdf.links[ordered.link]);
    GeometryLoader loader(urdf_path, options, sources);
    loader.read_mesh_files(links, skeleton_extent(urdf, order), model.warnings);
    for (std::size_t i = 0; i < links.size(); ++i) model.links[i].mesh = loader.surface_of(*links[i]);
  }
  for (const LoggedFile& file : sources.files()) {
    model.sources.push_back(file.source);
    model.source_paths.push_back(file.path);
  }
  return model;
}

}  // namespace uhas
