#include "render/light/surface_lighter.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#include <opencv2/core/utility.hpp>

#include "render/parts/surface_drawing.h"
#include "render/pixels/lane_images.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

GeometryImages widened(const GeometryImages& images) {
  return {render::widened(images.items), render::widened(images.depth), {}};
}

SurfaceImages widened(const SurfaceImages& images) {
  return {render::widened(images.base_roughness), render::widened(images.normal_metalness),
          render::widened(images.faces), render::widened(images.glows)};
}

/// The number of pixels of a row for which the lights that reach them are found together.
constexpr int kBlock = 32;

/// Whether none of four pixels is wanted.
bool isNone(const std::uint8_t* wanted) {
  std::uint32_t four = 0;
  static_assert(sizeof four == kLaneCount);
  std::memcpy(&four, wanted, sizeof four);
  return four == 0;
}

/// What `wanted` returns for each of four items: three numbers and one more.
template <class Wanted>
PixelLanes gatherFromItems(const std::vector<ItemLight>& items, const int* four,
                           const Wanted& wanted) {
  std::array<Lanes, kLaneCount> each;
  for (std::size_t i = 0; i < each.size(); ++i) {
    const auto [three, one] = wanted(items[static_cast<std::size_t>(four[i])]);
    each[i] = {three.x(), three.y(), three.z(), one};
  }
  PixelLanes result;
  cv::v_transpose4x4(each[0], each[1], each[2], each[3], result.xyz.x, result.xyz.y, result.xyz.z,
                     result.w);
  return result;
}

}  // namespace

std::vector<ItemLight> itemLights(const std::vector<DrawItem>& items, world::Simulator simulator) {
  std::vector<ItemLight> lights = {ItemLight()};
  for (const DrawItem& item : items) {
    const world::Material& material = *item.material;
    ItemLight light;
    if (simulator == world::Simulator::kClassic) {
      light.classic = classicLight(material);
    } else {
      light.emissive = linearFromSrgb(material.emissive);
      light.reflectance = material.lit ? reflectance(material) : -1.0F;
    }
    lights.push_back(light);
  }
  return lights;
}

/// A row of the images.
struct SurfaceLighter::Row {
  Row(const GeometryImages& geometry, const SurfaceImages& surfaces, int row, cv::Mat& lit)
      : items(geometry.items.ptr<int>(row)),
        depths(geometry.depth.ptr<float>(row)),
        base_roughness(surfaces.base_roughness.ptr<std::uint16_t>(row)),
        normal_metalness(surfaces.normal_metalness.ptr<std::uint16_t>(row)),
        faces(surfaces.faces.empty() ? nullptr : surfaces.faces.ptr<std::uint16_t>(row)),
        glows(surfaces.glows.empty() ? nullptr : surfaces.glows.ptr<std::uint16_t>(row)),
        light(lit.ptr<std::uint16_t>(row)),
        columns(lit.cols) {}

  const int* items;
  const float* depths;
  const std::uint16_t* base_roughness;
  const std::uint16_t* normal_metalness;
  const std::uint16_t* faces;
  const std::uint16_t* glows;
  std::uint16_t* light;
  int columns;
  float slope_y = 0.0F;
  const float* rays = nullptr;  ///< of the first column
  const float* open = nullptr;

  [[nodiscard]] Lanes openAt(int column) const {
    return open == nullptr ? lanes(1.0F) : cv::v_load(open + column);
  }
};

SurfaceLighter::SurfaceLighter(const LightingContext& context, const std::vector<ItemLight>& items,
                               const Intrinsics& intrinsics, const Eigen::Vector3f& nothing,
                               const cv::Mat& rays)
    : items_(items), intrinsics_(intrinsics), nothing_(nothing), rays_(rays) {
  if (context.simulator == world::Simulator::kClassic) {
    classic_.emplace(context);
  } else {
    shading_.emplace(context);
  }
}

cv::Mat SurfaceLighter::light(const GeometryImages& geometry, const SurfaceImages& surfaces,
                              const cv::Rect& place, const std::vector<cv::Rect>& regions,
                              const cv::Mat& wanted, const cv::Mat& open) const {
  const GeometryImages what = widened(geometry);
  const SurfaceImages how = widened(surfaces);
  const cv::Mat which = render::widened(wanted);
  const cv::Mat how_open = render::widened(open);
  const cv::Mat along = rays_.empty() ? rays_ : render::widened(rays_(place));
  cv::Mat light(what.items.size(), CV_16UC4);
  for (const cv::Rect& region : regions) {
    const cv::Rect pixels = region - place.tl();
    const auto lightRows = [&](const cv::Range& rows) {
      std::vector<std::size_t> lights = arriving().all();
      for (int v = rows.start; v < rows.end; ++v) {
        Row row(what, how, v, light);
        row.slope_y = static_cast<float>((place.y + v - intrinsics_.cy) / intrinsics_.fy);
        if (!along.empty()) row.rays = along.ptr<float>(v);
        if (!how_open.empty()) row.open = how_open.ptr<float>(v);
        int known_until = pixels.x;
        for (int u = pixels.x; u < pixels.x + pixels.width; u += kLaneCount) {
          // Some pixels may be lit twice, or may be outside the region.
          const int first = firstLane(u, light.cols);
          if (isNone(which.ptr<std::uint8_t>(v, first))) continue;
          if (arriving().areMany() && u >= known_until) {
            known_until = std::min(u + kBlock, pixels.x + pixels.width);
            findReaching(row, {first, known_until}, place.x, lights);
          }
          lightFour(row, first, static_cast<float>(place.x + first), lights);
        }
      }
    };
    cv::parallel_for_(cv::Range(pixels.y, pixels.y + pixels.height), lightRows);
  }
  return light.colRange(0, geometry.items.cols);
}

const ArrivingLights& SurfaceLighter::arriving() const {
  return classic_ ? classic_->lights() : shading_->lights();
}

/// Finds the lights that reach some pixels of a row.
/// @param left  the column in the picture of the images' first column
void SurfaceLighter::findReaching(const Row& row, const cv::Range& columns, int left,
                                  std::vector<std::size_t>& lights) const {
  const Lanes far = lanes(std::numeric_limits<float>::max());
  const Lanes zero = lanes(0.0F);
  Lanes3 low{far, far, far};
  Lanes3 high{zero - far, zero - far, zero - far};
  const int last = firstLane(columns.end - 1, row.columns);
  for (int u = columns.start; u <= last; u += kLaneCount) {
    const int column = std::min(u, last);
    const Lanes is_nothing =
        cv::v_reinterpret_as_f32(cv::v_load(row.items + column) == cv::v_setzero_s32());
    const Lanes3 at = positionsAt(row, column, static_cast<float>(left + column));
    low = select(is_nothing, low,
                 {cv::v_min(low.x, at.x), cv::v_min(low.y, at.y), cv::v_min(low.z, at.z)});
    high = select(is_nothing, high,
                  {cv::v_max(high.x, at.x), cv::v_max(high.y, at.y), cv::v_max(high.z, at.z)});
  }
  arriving().reaching(
      {cv::v_reduce_min(low.x), cv::v_reduce_min(low.y), cv::v_reduce_min(low.z)},
      {cv::v_reduce_max(high.x), cv::v_reduce_max(high.y), cv::v_reduce_max(high.z)}, lights);
}

/// @param column  the first pixel's, in the images
/// @param u  the same pixel's, in the picture
/// @param lights  the indices of the lights that reach the pixels
void SurfaceLighter::lightFour(const Row& row, int column, float u,
                               const std::vector<std::size_t>& lights) const {
  const cv::v_int32x4 items = cv::v_load(row.items + column);
  const cv::v_int32x4 is_nothing = items == cv::v_setzero_s32();
  std::uint16_t* to = row.light + 4 * column;
  const Lanes3 nothing = lanes(nothing_);
  if (cv::v_check_all(is_nothing)) {
    storeHalves(to, nothing);
    return;
  }
  const Lanes3 seen = classic_ ? classic_->seen(classicAt(row, column, u), lights)
                               : shading_->seen(surfacesAt(row, column, u), lights);
  storeHalves(to, select(cv::v_reinterpret_as_f32(is_nothing), nothing, seen));
}

Lanes3 SurfaceLighter::positionsAt(const Row& row, int column, float u) const {
  const Lanes depth = cv::v_load(row.depths + column);
  if (row.rays != nullptr) {
    Lanes3 ray;
    cv::v_load_deinterleave(row.rays + std::ptrdiff_t{3} * column, ray.x, ray.y, ray.z);
    return ray * depth;
  }
  const Lanes columns = lanes(u) + Lanes(0.0F, 1.0F, 2.0F, 3.0F);
  const Lanes slope_x = (columns - lanes(static_cast<float>(intrinsics_.cx))) *
                        lanes(static_cast<float>(1.0 / intrinsics_.fx));
  return {slope_x * depth, lanes(row.slope_y) * depth, depth};
}

SurfaceLanes SurfaceLighter::surfacesAt(const Row& row, int column, float u) const {
  const PixelLanes base = loadHalves(row.base_roughness + 4 * column);
  const PixelLanes normal = loadHalves(row.normal_metalness + 4 * column);
  const PixelLanes item = gatherFromItems(items_, row.items + column, [](const ItemLight& light) {
    return std::pair<const Eigen::Vector3f&, float>(light.emissive, light.reflectance);
  });
  SurfaceLanes surface;
  surface.position_C = positionsAt(row, column, u);
  surface.normal = normalized(normal.xyz);
  surface.face =
      row.faces == nullptr ? surface.normal : normalized(loadHalves(row.faces + 4 * column).xyz);
  surface.base = base.xyz;
  surface.roughness = base.w;
  surface.metalness = normal.w;
  surface.reflectance = item.w;
  surface.ambient_visibility = row.openAt(column);
  surface.is_lit = item.w >= lanes(0.0F);
  surface.glow = item.xyz;
  if (row.glows != nullptr) surface.glow = surface.glow * loadHalves(row.glows + 4 * column).xyz;
  return surface;
}

ClassicLanes SurfaceLighter::classicAt(const Row& row, int column, float u) const {
  const int* const items = row.items + column;
  const auto of = [&](const auto& wanted) { return gatherFromItems(items_, items, wanted); };
  using Four = std::pair<const Eigen::Vector3f&, float>;
  const PixelLanes ambient =
      of([](const ItemLight& light) { return Four(light.classic.ambient, 0.0F); });
  const PixelLanes emissive =
      of([](const ItemLight& light) { return Four(light.classic.emissive, 0.0F); });
  const PixelLanes diffuse =
      of([](const ItemLight& light) { return Four(light.classic.diffuse, 0.0F); });
  const PixelLanes specular = of(
      [](const ItemLight& light) { return Four(light.classic.specular, light.classic.shininess); });
  ClassicLanes surface;
  surface.position_C = positionsAt(row, column, u);
  surface.normal = normalized(loadHalves(row.normal_metalness + 4 * column).xyz);
  surface.face =
      row.faces == nullptr ? surface.normal : normalized(loadHalves(row.faces + 4 * column).xyz);
  surface.albedo = loadHalves(row.base_roughness + 4 * column).xyz;
  surface.ambient = ambient.xyz;
  surface.ambient_visibility = row.openAt(column);
  surface.emissive = emissive.xyz;
  surface.diffuse = diffuse.xyz;
  surface.specular = specular.xyz;
  surface.shininess = specular.w;
  surface.glow = lanes(0.0F, 0.0F, 0.0F);
  if (row.glows == nullptr) return surface;
  const PixelLanes glow = of([](const ItemLight& light) { return Four(light.classic.glow, 0.0F); });
  surface.glow = glow.xyz * loadHalves(row.glows + 4 * column).xyz;
  return surface;
}

}  // namespace synthetic_dataset::render
