#include "uhas/correspondences/rays/ray_caster.hpp"

#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <limits>
#include <string>
#include <type_traits>

#include "uhas/base/errors.hpp"

namespace uhas {
namespace {

struct ReleaseDevice {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using Scene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

/// Embree keeps the first error since the last question; a null device asks about the making of devices.
void check(RTCDevice device) {
  const RTCError error = rtcGetDeviceError(device);
  if (error == RTC_ERROR_NONE) return;
  const std::string reason =
      error == RTC_ERROR_OUT_OF_MEMORY ? "out of memory" : "Embree error " + std::to_string(error);
  throw Error(ErrorCode::invalid_mesh, "", "the meshes cannot be prepared for ray casting: " + reason,
              "use simpler meshes, for example those of GeometrySource::collision");
}

/// Three numbers an element, owned by the geometry.
template <class Number>
Number* new_buffer(RTCDevice device, RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::size_t count) {
  void* buffer = rtcSetNewGeometryBuffer(geometry, type, 0, format, 3 * sizeof(Number), count);
  check(device);
  return static_cast<Number*>(buffer);
}

Geometry new_geometry(RTCDevice device, const PosedMesh& posed) {
  const TriangleMesh& mesh = *posed.mesh;
  // the vertices, where the mesh stands
  Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
  check(device);
  float* xyz =
      new_buffer<float>(device, geometry.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, mesh.vertices.size());
  for (const Vector3d& p_mesh : mesh.vertices) {
    const Vector3d p = posed.T_world_mesh * p_mesh;
    *xyz++ = static_cast<float>(p.x);
    *xyz++ = static_cast<float>(p.y);
    *xyz++ = static_cast<float>(p.z);
  }

  // the triangles
  unsigned* corner =
      new_buffer<unsigned>(device, geometry.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) corner = std::copy(triangle.begin(), triangle.end(), corner);
  rtcCommitGeometry(geometry.get());
  check(device);
  return geometry;
}

}  // namespace

struct RayCaster::Embree {
  Device device;
  Scene scene;
};

RayCaster::RayCaster(std::span<const PosedMesh> meshes) : embree_(std::make_unique<Embree>()) {
  // one build thread: the tree, and with it the choice between triangles that share an edge, never depends on the
  // machine's number of cores
  embree_->device.reset(rtcNewDevice("threads=1"));
  check(embree_->device.get());

  // a scene whose meshes keep their indices; an empty one has none
  const RTCDevice device = embree_->device.get();
  embree_->scene.reset(rtcNewScene(device));
  check(device);
  const RTCScene scene = embree_->scene.get();
  rtcSetSceneFlags(scene, RTC_SCENE_FLAG_ROBUST);         // no ray slips between two triangles
  rtcSetSceneBuildQuality(scene, RTC_BUILD_QUALITY_LOW);  // thousands of rays against up to millions of triangles
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i].mesh->triangles.empty()) continue;
    rtcAttachGeometryByID(scene, new_geometry(device, meshes[i]).get(), static_cast<unsigned>(i));
    check(device);
  }
  rtcCommitScene(scene);
  check(device);
}

RayCaster::~RayCaster() = default;

std::optional<TriangleHit> RayCaster::first_hit(Vector3d origin, Vector3d direction) const {
  RTCRayHit query{};
  query.ray.org_x = static_cast<float>(origin.x);
  query.ray.org_y = static_cast<float>(origin.y);
  query.ray.org_z = static_cast<float>(origin.z);
  query.ray.dir_x = static_cast<float>(direction.x);
  query.ray.dir_y = static_cast<float>(direction.y);
  query.ray.dir_z = static_cast<float>(direction.z);
  query.ray.tfar = std::numeric_limits<float>::infinity();
  query.ray.mask = ~0u;
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
  rtcIntersect1(embree_->scene.get(), &query);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(embree_->scene.get(), &context, &query);
#endif
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  return TriangleHit{query.hit.geomID, query.hit.primID};
}

}  // namespace uhas
