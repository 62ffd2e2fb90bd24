#include "render/lens/lens_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>
#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace {

/// The surface that a pixel sees, as in surface.glsl.
struct LensSurface {
  Eigen::Vector3f face;
  Eigen::Vector3f normal;
  Eigen::Vector3f base;
  Eigen::Vector3f glow{1.0F, 1.0F, 1.0F};
  float roughness = 0.0F;
  float metalness = 0.0F;
};

/// A triangle that several neighbouring pixels see.
struct SeenByPixels {
  SeenByPixels(const LensSight& sight, int triangle)
      : index(triangle),
        is_front(sight.seen[static_cast<std::size_t>(triangle)].is_front),
        surface(&(*sight.surfaces)[itemOf(sight, triangle)]),
        R_CV(sight.poseOf(sight.seen[static_cast<std::size_t>(triangle)]).linear().cast<float>()),
        triangle_C(sight.triangleAt(triangle)) {}

  static std::size_t itemOf(const LensSight& sight, int triangle) {
    return static_cast<std::size_t>(sight.seen[static_cast<std::size_t>(triangle)].item);
  }

  int index;
  bool is_front;
  const ItemSurface* surface;
  Eigen::Matrix3f R_CV;
  FacedTriangle triangle_C;
};

/// The normal as bent by the normal map, as in material.glsl.
Eigen::Vector3f bentNormal(const SeenByPixels& seen, const Eigen::Vector3f& normal,
                           const FacedTriangle::TexturePlace& on) {
  const auto& corners = seen.triangle_C.corners();
  const Eigen::Vector3f along_x = corners[1] - corners[0];
  const Eigen::Vector3f along_y = corners[2] - corners[0];
  const Eigen::Vector2f start = seen.triangle_C.coordinates(0);
  const Eigen::Vector2f texture_x = seen.triangle_C.coordinates(1) - start;
  const Eigen::Vector2f texture_y = seen.triangle_C.coordinates(2) - start;
  const Eigen::Vector3f across_y = along_y.cross(normal);
  const Eigen::Vector3f across_x = normal.cross(along_x);
  const float along = along_x.dot(across_y);
  const float turn = along > 0.0F ? 1.0F : along < 0.0F ? -1.0F : 0.0F;
  const Eigen::Vector3f u_axis = turn * (across_y * texture_x.x() + across_x * texture_y.x());
  const Eigen::Vector3f v_axis = turn * (across_y * texture_x.y() + across_x * texture_y.y());
  const float longest = std::max(u_axis.squaredNorm(), v_axis.squaredNorm());
  if (!(longest > 0.0F)) return normal;  // no texture coordinates
  const Eigen::Vector3f bend =
      2.0F * seen.surface->normals->sample(on.place, on.across, on.along).head<3>() -
      Eigen::Vector3f::Ones();
  return ((bend.x() * u_axis - bend.y() * v_axis) / std::sqrt(longest) + bend.z() * normal)
      .normalized();
}

/// Knows which pixels show the same surfaces as StandingSurfaces, and copies those.
class KnownPixels {
 public:
  KnownPixels(const LensSight& sight, const StandingSurfaces& standing) : known_(standing) {
    if (known_.sight == nullptr) return;
    const LensSight& alone = *known_.sight;
    for (std::size_t item = 0; item < alone.X_CV.size(); ++item) {
      are_there_.push_back(alone.X_CV[item].matrix() == sight.X_CV.at(item).matrix());
    }
  }

  /// Whether a pixel sees the same triangle as with only the items that never move.
  [[nodiscard]] bool has(const LensSight& sight, int u, int v) const {
    if (known_.sight == nullptr) return false;
    const LensSight& alone = *known_.sight;
    const int triangle = sight.triangles.at<int>(v, u);
    if (triangle != alone.triangles.at<int>(v, u)) return false;
    const SeenTriangle& here = sight.seen[static_cast<std::size_t>(triangle)];
    const SeenTriangle& there = alone.seen[static_cast<std::size_t>(triangle)];
    return here.item == there.item && here.first == there.first && here.row == there.row &&
           are_there_[static_cast<std::size_t>(here.item)];
  }

  /// Copies what is known of a pixel.
  /// @param pixel  in the images
  void copy(int u, int v, const cv::Point& pixel, const SurfaceImages& images) const {
    const auto copyOne = [&](const cv::Mat& from, cv::Mat to) {
      if (!to.empty()) to.at<cv::Vec4w>(pixel) = from.at<cv::Vec4w>(v, u);
    };
    copyOne(known_.images.base_roughness, images.base_roughness);
    copyOne(known_.images.normal_metalness, images.normal_metalness);
    copyOne(known_.images.faces, images.faces);
    copyOne(known_.images.glows, images.glows);
  }

 private:
  const StandingSurfaces& known_;
  std::vector<bool> are_there_;  ///< for each item: whether its pose is unchanged
};

/// How surfaces of a picture are looked up.
struct SurfaceLookup {
  bool is_classic;
  bool is_pinhole;
};

LensSurface lensSurfaceAt(const SeenByPixels& seen, const SurfaceLookup& lookup,
                          const Eigen::Vector3f& ray, const Eigen::Vector3f& across,
                          const Eigen::Vector3f& along) {
  const ItemSurface& item = *seen.surface;
  const Eigen::Vector3f weights = seen.triangle_C.weights(ray);
  const Eigen::Vector3f shares = weights / weights.sum();
  LensSurface surface;
  surface.face = (seen.R_CV * seen.triangle_C.mixed(item.shape->normals, shares)).normalized();
  surface.normal = surface.face;
  surface.base = item.diffuse.head<3>();
  surface.roughness = item.roughness;
  surface.metalness = item.metalness;
  if (item.tints != nullptr) {
    surface.base = surface.base.cwiseProduct(seen.triangle_C.tint(shares).head<3>());
  }
  if (item.colours || item.normals || item.roughnesses || item.metalnesses || item.glows) {
    const auto on = seen.triangle_C.onTexture(ray, across, along);
    const auto mean = [&](const PicturePyramid& picture) {
      return lookup.is_pinhole ? picture.sample(on.place, on.across, on.along)
                               : picture.mean(on.place, on.across, on.along);
    };
    if (item.colours) surface.base = surface.base.cwiseProduct(mean(*item.colours).head<3>());
    if (item.roughnesses) surface.roughness *= mean(*item.roughnesses).y();
    if (item.metalnesses) surface.metalness *= mean(*item.metalnesses).z();
    if (item.glows) surface.glow = mean(*item.glows).head<3>();
    if (item.normals) surface.normal = bentNormal(seen, surface.face, on);
  }
  if (!seen.is_front) {
    surface.face = -surface.face;
    if (!lookup.is_classic) surface.normal = -surface.normal;
  }
  return surface;
}

/// A row of an image with four numbers per pixel, which is stored with 16 bits per number.
class HalfRow {
 public:
  /// @param image  CV_16UC4, or empty if it is not wanted
  explicit HalfRow(const cv::Mat& image) : image_(image) {
    if (!image.empty()) numbers_ = cv::Mat::zeros(1, image.cols, CV_32FC4);
  }

  void set(int column, const Eigen::Vector3f& three, float one) {
    if (image_.empty()) return;
    numbers_.at<cv::Vec4f>(column) = {three.x(), three.y(), three.z(), one};
  }

  void store(int row, int first, int end) {
    if (image_.empty() || first >= end) return;
    cv::Mat halves;
    numbers_.colRange(first, end).convertTo(halves, CV_16F);
    std::copy_n(halves.ptr<std::uint16_t>(), std::ptrdiff_t{4} * (end - first),
                image_.ptr<std::uint16_t>(row, first));
  }

 private:
  cv::Mat image_;
  cv::Mat numbers_;
};

/// The difference from a pixel's ray to the next one or, at the rim, from the previous one to it.
Eigen::Vector3f rayStepOf(const LensMap& lens, int u, int v, int du, int dv) {
  const cv::Rect image(cv::Point(), lens.face.size());
  const Eigen::Vector3f here(lens.rays.at<cv::Vec3f>(v, u).val);
  for (const int side : {1, -1}) {
    const cv::Point neighbour(u + side * du, v + side * dv);
    if (!image.contains(neighbour) || lens.face.at<std::int16_t>(neighbour) < 0) continue;
    const Eigen::Vector3f there(lens.rays.at<cv::Vec3f>(neighbour).val);
    return static_cast<float>(side) * (there - here);
  }
  return Eigen::Vector3f::Zero();
}

/// Computes some rows of surfacesOf().
void findRows(const LensSight& sight, bool is_classic, const cv::Rect& place, const cv::Mat& wanted,
              const KnownPixels& known, const cv::Range& rows, const SurfaceImages& images) {
  HalfRow base_roughness(images.base_roughness);
  HalfRow normal_metalness(images.normal_metalness);
  HalfRow faces(images.faces);
  HalfRow glows(images.glows);
  const LensMap& lens = *sight.lens;
  const SurfaceLookup lookup{is_classic, lens.is_pinhole};
  std::optional<SeenByPixels> seen;
  std::vector<int> known_columns;
  for (int row = rows.start; row < rows.end; ++row) {
    const int v = place.y + row;
    const auto* is_wanted = wanted.ptr<std::uint8_t>(v, place.x);
    const int* triangles = sight.triangles.ptr<int>(v, place.x);
    int first = place.width;
    int end = 0;
    known_columns.clear();
    for (int column = 0; column < place.width; ++column) {
      if (is_wanted[column] == 0 || triangles[column] < 0) continue;
      const int u = place.x + column;
      if (known.has(sight, u, v)) {
        known_columns.push_back(column);
        continue;
      }
      if (!seen || seen->index != triangles[column]) seen.emplace(sight, triangles[column]);
      const Eigen::Vector3f ray(lens.rays.at<cv::Vec3f>(v, u).val);
      const LensSurface surface = lensSurfaceAt(*seen, lookup, ray, rayStepOf(lens, u, v, 1, 0),
                                                rayStepOf(lens, u, v, 0, 1));
      base_roughness.set(column, surface.base, surface.roughness);
      normal_metalness.set(column, surface.normal, surface.metalness);
      faces.set(column, surface.face, 0.0F);
      glows.set(column, surface.glow, 0.0F);
      first = std::min(first, column);
      end = column + 1;
    }
    for (HalfRow* each : {&base_roughness, &normal_metalness, &faces, &glows}) {
      each->store(row, first, end);
    }
    for (const int column : known_columns) known.copy(place.x + column, v, {column, row}, images);
  }
}

}  // namespace

SurfaceImages surfacesOf(const LensSight& sight, const GeometryPlanes& planes, bool is_classic,
                         const cv::Rect& place, const cv::Mat& wanted,
                         const StandingSurfaces& standing) {
  const auto image = [&](bool is_wanted) {
    return is_wanted ? cv::Mat(place.size(), CV_16UC4) : cv::Mat();
  };
  SurfaceImages images{image(true), image(true), image(planes.faces), image(planes.glows)};
  const KnownPixels known(sight, standing);
  cv::parallel_for_(cv::Range(0, place.height), [&](const cv::Range& rows) {
    findRows(sight, is_classic, place, wanted, known, rows, images);
  });
  return images;
}

}  // namespace synthetic_dataset::render
