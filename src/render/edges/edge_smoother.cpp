#include "render/edges/edge_smoother.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "render/edges/edge_pixels.h"
#include "render/edges/sample_raster.h"
#include "render/pixels/half.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

constexpr int kSide = 3;  ///< [px] of the square of pixels around one that is considered
constexpr std::size_t kMiddle = kSide / 2;

/// Numbers for the pixels around one: each element is a row of the square, with its last lane
/// unused.
using Square = std::array<Lanes, kSide>;

/// What the centres of the pixels around one see.
class Neighbourhood {
 public:
  Neighbourhood(const PictureSamples& seen, const cv::Point& pixel)
      : seen_(seen),
        first_(pixel - seen.place.tl() - cv::Point(kMiddle, kMiddle)),
        columns_(lanes(static_cast<float>(pixel.x - 1)) + Lanes(0.0F, 1.0F, 2.0F, 3.0F)),
        first_row_(static_cast<float>(pixel.y - 1)) {}

  /// How much each pixel of a row differs from a face.
  [[nodiscard]] Lanes unlikeness(const SeenFace* face, std::size_t number) const {
    const Row row = rowAt(static_cast<int>(number));
    const cv::v_int32x4 item = cv::v_setall_s32(face == nullptr ? 0 : face->item);
    const Lanes is_same = cv::v_reinterpret_as_f32(row.items == item);
    if (face == nullptr) return cv::v_select(is_same, lanes(0.0F), lanes(likeness::kUnlike));
    // The vertices' normals may point inwards, consistently for a whole mesh.
    const Lanes turned = lanes(1.0F) - cv::v_abs(dot(row.normals, lanes(face->normal)));
    const Lanes down = lanes(first_row_ + static_cast<float>(number));
    const Lanes expected = lanes(face->origin.z()) +
                           lanes(face->slope.x()) * (columns_ - lanes(face->origin.x())) +
                           lanes(face->slope.y()) * (down - lanes(face->origin.y()));
    const Lanes off = cv::v_abs(expected * row.depths - lanes(1.0F));
    return cv::v_select(is_same, turned + lanes(likeness::kDepth) * off, lanes(likeness::kUnlike));
  }

 private:
  struct Row {
    cv::v_int32x4 items;  ///< -1 outside the image
    Lanes depths;
    Lanes3 normals;
  };

  [[nodiscard]] Row rowAt(int number) const {
    const GeometryImages& images = seen_.geometry;
    const cv::Point from(first_.x, first_.y + number);
    const bool is_inside = from.y >= 0 && from.y < seen_.place.height;
    if (is_inside && from.x >= 0 && from.x + kLaneCount <= seen_.place.width) {
      return {cv::v_load(images.items.ptr<int>(from.y, from.x)),
              cv::v_load(images.depth.ptr<float>(from.y, from.x)),
              loadHalves(images.normals.ptr<std::uint16_t>(from.y, from.x)).xyz};
    }
    std::array<int, kLaneCount> items{};
    std::array<float, kLaneCount> depths{};
    std::array<std::uint16_t, std::size_t{4} * kLaneCount> normals{};
    items.fill(-1);
    const int left = std::max(-from.x, 0);  // columns outside the image, which have no surface
    const int count = std::min(kSide - left, seen_.place.width - from.x - left);
    if (is_inside) {
      std::copy_n(images.items.ptr<int>(from.y, from.x + left), count, items.begin() + left);
      std::copy_n(images.depth.ptr<float>(from.y, from.x + left), count, depths.begin() + left);
      std::copy_n(images.normals.ptr<std::uint16_t>(from.y, from.x + left), 4 * count,
                  normals.begin() + std::ptrdiff_t{4} * left);
    }
    return {cv::v_load(items.data()), cv::v_load(depths.data()), loadHalves(normals.data()).xyz};
  }

  const PictureSamples& seen_;
  cv::Point first_;  ///< the first of the pixels, in the images
  Lanes columns_;
  float first_row_;
};

/// A sample's distances from a row of the pixels around its own, weighted as unlikeness.
std::array<float, kLaneCount> distancesFrom(std::size_t sample, int row) {
  std::array<float, kLaneCount> distances{};
  distances.fill(likeness::kUnlike);  // so that the last lane is never chosen
  for (int column = 0; column < kSide; ++column) {
    const float x = static_cast<float>(column - 1) - kSampleColumns.at(sample);
    const float y = static_cast<float>(row - 1) - kSampleRows.at(sample);
    distances.at(static_cast<std::size_t>(column)) = likeness::kAway * (x * x + y * y);
  }
  return distances;
}

/// Finds the light of what a pixel's samples see, by taking it from pixels whose centres see the
/// same surface.
class Resolver {
 public:
  Resolver(const PictureSamples& seen, const SampleRaster& raster) : seen_(seen), raster_(raster) {
    for (std::size_t sample = 0; sample < kSampleCount; ++sample) {
      for (int row = 0; row < kSide; ++row) {
        away_[sample][static_cast<std::size_t>(row)] =
            cv::v_load(distancesFrom(sample, row).data());
      }
    }
  }

  /// The mean of the samples' light.
  /// @param number  the pixel's index in the raster
  [[nodiscard]] Eigen::Vector3f light(const cv::Point& pixel, std::size_t number) const {
    const Neighbourhood neighbours(seen_, pixel);
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    const SeenFace* last = nullptr;
    Square unlike;
    bool is_alike = false;  // to the pixel's own centre, which is then taken
    bool is_whole = false;  // whether all rows of the square are known
    for (std::size_t sample = 0; sample < kSampleCount; ++sample) {
      const SeenFace* face = raster_.at(number, sample);
      if (sample == 0 || face != last) {
        unlike[kMiddle] = neighbours.unlikeness(face, kMiddle);
        is_alike = isAlike(unlike[kMiddle]);
        is_whole = false;
      }
      last = face;
      if (!is_alike && !is_whole) {
        for (const std::size_t row : {kMiddle - 1, kMiddle + 1}) {
          unlike[row] = neighbours.unlikeness(face, row);
        }
        is_whole = true;
      }
      sum += lightAt(is_alike ? pixel : pixel + nearest(unlike, sample));
    }
    return sum / static_cast<float>(kSampleCount);
  }

 private:
  static bool isAlike(const Lanes& middle) {
    std::array<float, kLaneCount> unlike{};
    cv::v_store(unlike.data(), middle);
    return unlike[kMiddle] < likeness::kAlike;
  }

  [[nodiscard]] cv::Point nearest(const Square& unlike, std::size_t sample) const {
    float least = likeness::kUnlike;
    cv::Point best(0, 0);
    for (std::size_t row = 0; row < unlike.size(); ++row) {
      const Lanes sum = unlike[row] + away_[sample][row];
      const float least_here = cv::v_reduce_min(sum);
      if (!(least_here < least)) continue;
      least = least_here;
      const int is_least = cv::v_signmask(sum <= lanes(least_here));
      best = {__builtin_ctz(static_cast<unsigned>(is_least)) - 1, static_cast<int>(row) - 1};
    }
    return best;
  }

  [[nodiscard]] Eigen::Vector3f lightAt(const cv::Point& pixel) const {
    const cv::Point at = pixel - seen_.place.tl();
    const auto* bits = seen_.light.ptr<std::uint16_t>(at.y, at.x);
    return {fromHalf(bits[0]), fromHalf(bits[1]), fromHalf(bits[2])};
  }

  const PictureSamples& seen_;
  const SampleRaster& raster_;
  std::array<Square, kSampleCount> away_;
};

}  // namespace

void EdgeSmoother::smooth(const EdgeScene& scene, const PictureSamples& seen,
                          const std::vector<cv::Rect>& regions, const cv::Mat& wanted,
                          cv::Mat& picture) const {
  const EdgePixels edges(seen.geometry, seen.place, regions, wanted,
                         scene.view.camera.intrinsics());
  if (edges.pixels().empty()) return;
  SampleRaster raster(scene.view, edges, seen.geometry.items, seen.place);
  const Pose X_CW = scene.view.X_WC.inverse();
  for (const bool stand_still : {true, false}) {
    for (const DrawItem* item : draw_list_.solidItems(X_CW, scene.X_WL, scene.drawn, stand_still)) {
      raster.draw(*item, static_cast<int>(draw_list_.numberOf(*item)), scene.X_WL[item->link]);
    }
  }
  const Resolver resolver(seen, raster);
  for (std::size_t i = 0; i < edges.pixels().size(); ++i) {
    const cv::Point& pixel = edges.pixels()[i];
    const Eigen::Vector3f light = resolver.light(pixel, i);
    picture.at<cv::Vec3b>(pixel) = {render::srgbFromLinear(light.z()),
                                    render::srgbFromLinear(light.y()),
                                    render::srgbFromLinear(light.x())};
  }
}

}  // namespace synthetic_dataset::render
