#include "lidar/ray_bodies.h"

#include <array>
#include <cmath>
#include <deque>
#include <utility>

#if SYNTHETIC_DATASET_EMBREE >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include "lidar/lidar_options.h"
#include "lidar/surface_look.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::lidar {
namespace {

#if SYNTHETIC_DATASET_EMBREE >= 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

struct DeviceRelease {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, DeviceRelease>;

struct SceneRelease {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using BodyScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, SceneRelease>;

/// A surface, with its mesh's corners in its body's frame; Embree refers to both.
struct HeldSurface {
  const RaySurface* surface = nullptr;
  std::size_t index = 0;
  std::vector<Eigen::Vector3f> corners_B;

  [[nodiscard]] std::array<Eigen::Vector3d, 3> triangle(std::size_t number) const {
    const std::uint32_t* corners = &surface->mesh->indices[3 * number];
    return {corners_B[corners[0]].cast<double>(), corners_B[corners[1]].cast<double>(),
            corners_B[corners[2]].cast<double>()};
  }
};

/// What the filter needs to know about a ray beyond what Embree passes to it; the context has to be
/// the first member.
struct Query {
  QueryContext context;
  const Paint* paint;
};

/// Embree's filter function: rejects hits on the backs of surfaces, and in holes.
void filter(const RTCFilterFunctionNArguments* arguments) {
  if (arguments->valid[0] == 0) return;
  const auto& held = *static_cast<const HeldSurface*>(arguments->geometryUserPtr);
  const std::size_t triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
  const auto [a, b, c] = held.triangle(triangle);
  if (!held.surface->material->double_sided) {
    const Eigen::Vector3d direction(RTCRayN_dir_x(arguments->ray, arguments->N, 0),
                                    RTCRayN_dir_y(arguments->ray, arguments->N, 0),
                                    RTCRayN_dir_z(arguments->ray, arguments->N, 0));
    if ((b - a).cross(c - a).dot(direction) >= 0.0) {
      arguments->valid[0] = 0;
      return;
    }
  }
  if (!held.surface->has_holes) return;
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): Embree hands on what it was given
  const Paint& paint = *reinterpret_cast<const Query*>(arguments->context)->paint;
  const SurfacePlace place{triangle, RTCHitN_u(arguments->hit, arguments->N, 0),
                           RTCHitN_v(arguments->hit, arguments->N, 0)};
  if (isHole(*held.surface->mesh, *paint[held.index], place)) arguments->valid[0] = 0;
}

/// Where a ray meets the plane of a triangle (Moeller and Trumbore 1997).
void refine(const std::array<Eigen::Vector3d, 3>& triangle, const Eigen::Vector3d& origin,
            const Eigen::Vector3d& direction, RayHit& hit) {
  const Eigen::Vector3d edge1 = triangle[1] - triangle[0];
  const Eigen::Vector3d edge2 = triangle[2] - triangle[0];
  const Eigen::Vector3d across = direction.cross(edge2);
  const double determinant = edge1.dot(across);
  if (determinant == 0.0) return;  // a grazing ray: keeps Embree's result
  const Eigen::Vector3d from_corner = origin - triangle[0];
  const Eigen::Vector3d normal = from_corner.cross(edge1);
  hit.distance = edge2.dot(normal) / determinant;
  hit.b1 = from_corner.dot(across) / determinant;
  hit.b2 = direction.dot(normal) / determinant;
}

}  // namespace

struct RayBodies::Impl {
  // The same instructions on every processor, and one thread, which builds the same tree each time.
  Device device{rtcNewDevice("isa=sse2,threads=1,set_affinity=0")};
  std::vector<RaySurface> surfaces;
  std::deque<HeldSurface> held;  ///< of all surfaces
  std::vector<BodyScene> bodies;
  std::vector<std::vector<const HeldSurface*>> by_geometry;  ///< of each body

  void attach(RTCScene scene, HeldSurface& surface) const {
    const RTCGeometry geometry = rtcNewGeometry(device.get(), RTC_GEOMETRY_TYPE_TRIANGLE);
    // Embree reads 16 bytes per corner: the buffer has one more corner after the last.
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                               surface.corners_B.data(), 0, sizeof(Eigen::Vector3f),
                               surface.corners_B.size() - 1);
    const std::vector<std::uint32_t>& indices = surface.surface->mesh->indices;
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices.data(),
                               0, 3 * sizeof(std::uint32_t), indices.size() / 3);
    rtcSetGeometryUserData(geometry, &surface);
    if (!surface.surface->material->double_sided || surface.surface->has_holes) {
      rtcSetGeometryIntersectFilterFunction(geometry, filter);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
  }
};

bool canCastRays() { return true; }

std::string howToCastRays() { return ""; }

std::string rayCasterVersion() { return RTC_VERSION_STRING; }

RayBodies::RayBodies() : impl_(std::make_unique<Impl>()) {
  if (!impl_->device) throw Error("Embree, which casts the lidars' rays, cannot be started");
}

RayBodies::~RayBodies() = default;

const std::vector<RaySurface>& RayBodies::surfaces() const { return impl_->surfaces; }

std::size_t RayBodies::add(std::vector<RaySurface> surfaces) {
  Impl& impl = *impl_;
  BodyScene scene(rtcNewScene(impl.device.get()));
  rtcSetSceneFlags(scene.get(), RTC_SCENE_FLAG_ROBUST);
  std::vector<const HeldSurface*>& held_here = impl.by_geometry.emplace_back();
  for (RaySurface& surface : surfaces) {
    HeldSurface& held = impl.held.emplace_back();
    held.index = impl.surfaces.size();
    for (const Eigen::Vector3f& p_V : surface.mesh->positions) {
      held.corners_B.emplace_back((surface.X_BV * p_V.cast<double>()).cast<float>());
    }
    held.corners_B.emplace_back(0.0F, 0.0F, 0.0F);
    impl.surfaces.push_back(std::move(surface));
    held_here.push_back(&held);
  }
  // Only now are the addresses of the surfaces stable.
  for (HeldSurface& held : impl.held) held.surface = &impl.surfaces[held.index];
  for (const HeldSurface* held : held_here) impl.attach(scene.get(), impl.held[held->index]);
  rtcCommitScene(scene.get());
  if (rtcGetDeviceError(impl.device.get()) != RTC_ERROR_NONE) {
    throw Error("Embree, which casts the lidars' rays, cannot take the world's meshes");
  }
  impl.bodies.push_back(std::move(scene));
  return impl.bodies.size() - 1;
}

std::optional<RayHit> RayBodies::meet(std::size_t body, const Eigen::Vector3d& origin_B,
                                      const Eigen::Vector3d& direction_B, double near, double far,
                                      const Paint& paint) const {
  const Eigen::Vector3f origin = origin_B.cast<float>();
  const Eigen::Vector3f direction = direction_B.cast<float>();
  RTCRayHit ray{};
  ray.ray.org_x = origin.x();
  ray.ray.org_y = origin.y();
  ray.ray.org_z = origin.z();
  ray.ray.dir_x = direction.x();
  ray.ray.dir_y = direction.y();
  ray.ray.dir_z = direction.z();
  ray.ray.tnear = static_cast<float>(near);
  ray.ray.tfar = static_cast<float>(far);
  ray.ray.mask = ~0U;
  ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  Query query{};
  query.paint = &paint;
  const RTCScene scene = impl_->bodies[body].get();
#if SYNTHETIC_DATASET_EMBREE >= 4
  rtcInitRayQueryContext(&query.context);
  RTCIntersectArguments arguments;
  rtcInitIntersectArguments(&arguments);
  arguments.context = &query.context;
  rtcIntersect1(scene, &ray, &arguments);
#else
  rtcInitIntersectContext(&query.context);
  rtcIntersect1(scene, &query.context, &ray);
#endif
  if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  const HeldSurface& held = *impl_->by_geometry[body][ray.hit.geomID];
  RayHit hit{held.index, ray.hit.primID, ray.ray.tfar, ray.hit.u, ray.hit.v};
  refine(held.triangle(hit.triangle), origin_B, direction_B, hit);
  return hit;
}

}  // namespace synthetic_dataset::lidar
