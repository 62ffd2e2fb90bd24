#include "render/edges/sample_raster.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <opencv2/core/fast_math.hpp>

namespace synthetic_dataset::render {
namespace {

/// Surfaces whose depths differ by a smaller share than this coincide: which item is seen there
/// depends on their order.
constexpr float kSame = 1e-5F;
constexpr int kNotStored = -1;

/// Twice the signed area of a triangle: positive if its corners are in right-handed order in the
/// image (where v points down).
float doubleArea(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y());
}

/// A side of a triangle whose corners are in right-handed order in the image.
class Side {
 public:
  Side(const Eigen::Vector3f& from, const Eigen::Vector3f& to)
      : u_(lanes(from.x())),
        v_(lanes(from.y())),
        along_u_(lanes(to.x() - from.x())),
        along_v_(lanes(to.y() - from.y())) {}

  /// Whether places are on the inner side of this side, or on it.
  [[nodiscard]] Lanes inside(const Lanes& u, const Lanes& v) const {
    return along_u_ * (v - v_) >= (u - u_) * along_v_;
  }

 private:
  Lanes u_, v_, along_u_, along_v_;
};

/// A triangle whose corners are in right-handed order in the image.
class Triangle {
 public:
  Triangle(const Eigen::Vector3f& a, const Eigen::Vector3f& b, const Eigen::Vector3f& c)
      : sides_{Side(a, b), Side(b, c), Side(c, a)} {}

  [[nodiscard]] Lanes covered(const Lanes& u, const Lanes& v) const {
    return sides_[0].inside(u, v) & sides_[1].inside(u, v) & sides_[2].inside(u, v);
  }

 private:
  std::array<Side, 3> sides_;
};

}  // namespace

SampleRaster::SampleRaster(const View& view, const EdgePixels& edges, const cv::Mat& items,
                           const cv::Rect& place)
    : view_(view),
      edges_(edges),
      seen_items_(items),
      place_(place),
      fx_(static_cast<float>(view.camera.intrinsics().fx)),
      fy_(static_cast<float>(view.camera.intrinsics().fy)),
      cx_(static_cast<float>(view.camera.intrinsics().cx)),
      cy_(static_cast<float>(view.camera.intrinsics().cy)),
      near_(static_cast<float>(view.camera.near())),
      farthest_(static_cast<float>(1.0 / view.camera.far())),
      samples_(edges.pixels().size()) {}

void SampleRaster::draw(const DrawItem& item, int number, const Pose& X_WL) {
  const Pose X_CV = view_.X_WC.inverse() * X_WL * item.X_LV;
  if (!mayBeSeen(item, X_CV)) return;
  number_ = number;
  double_sided_ = item.double_sided;
  stands_still_ = item.stands_still;
  has_holes_ = item.has_holes;
  const Eigen::Affine3f to_camera = X_CV.cast<float>();
  const world::Mesh& mesh = *item.shape;
  corners_.clear();
  for (const Eigen::Vector3f& position : mesh.positions) {
    corners_.push_back(corner(to_camera * position));
  }
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const Corner& a = corners_[mesh.indices[i]];
    const Corner& b = corners_[mesh.indices[i + 1]];
    const Corner& c = corners_[mesh.indices[i + 2]];
    if (a.point_C.z() >= near_ && b.point_C.z() >= near_ && c.point_C.z() >= near_) {
      drawTriangle(a, b, c);
    } else {
      drawClipped({a.point_C, b.point_C, c.point_C});
    }
  }
}

SampleRaster::Corner SampleRaster::corner(const Eigen::Vector3f& point_C) const {
  const float inverse = 1.0F / point_C.z();
  return {point_C, {fx_ * point_C.x() * inverse + cx_, fy_ * point_C.y() * inverse + cy_, inverse}};
}

bool SampleRaster::mayBeSeen(const DrawItem& item, const Pose& X_CV) const {
  if (item.bounds_V.isEmpty()) return false;
  std::vector<Eigen::Vector3d> corners_C;
  for (const Eigen::Vector3d& point : cornersOf(item.bounds_V)) corners_C.push_back(X_CV * point);
  const auto box = view_.camera.projectedBounds(corners_C);
  if (!box) return false;
  const auto whole = [](double place) { return static_cast<int>(std::clamp(place, -1e6, 1e6)); };
  const cv::Rect pixels(
      cv::Point(whole(std::floor(box->left)), whole(std::floor(box->top))),
      cv::Point(whole(std::ceil(box->right)) + 1, whole(std::ceil(box->bottom)) + 1));
  bool found = false;
  edges_.visit(pixels, [&](std::size_t) { found = true; });
  return found;
}

/// Draws the part of a triangle beyond the near plane.
void SampleRaster::drawClipped(const std::array<Eigen::Vector3f, 3>& points_C) {
  std::array<Eigen::Vector3f, 4> kept;
  std::size_t count = 0;
  for (std::size_t i = 0; i < points_C.size(); ++i) {
    const Eigen::Vector3f& from = points_C.at(i);
    const Eigen::Vector3f& to = points_C.at((i + 1) % points_C.size());
    const bool from_kept = from.z() >= near_;
    if (from_kept) kept.at(count++) = from;
    if (from_kept != (to.z() >= near_)) {
      kept.at(count++) = from + (near_ - from.z()) / (to.z() - from.z()) * (to - from);
    }
  }
  for (std::size_t i = 2; i < count; ++i) {
    drawTriangle(corner(kept[0]), corner(kept.at(i - 1)), corner(kept.at(i)));
  }
}

void SampleRaster::drawTriangle(const Corner& first, const Corner& second, const Corner& third) {
  // Seen from outside, corners are in counter-clockwise order, which in the image, where v points
  // down, gives a negative area.
  const float area = doubleArea(first.pixel, second.pixel, third.pixel);
  if (area == 0.0F || (area > 0.0F && !double_sided_)) return;
  const Eigen::Vector3f& a = first.pixel;
  const Eigen::Vector3f& b = area > 0.0F ? second.pixel : third.pixel;
  const Eigen::Vector3f& c = area > 0.0F ? third.pixel : second.pixel;
  std::optional<Triangle> triangle;  // made when needed: most have no edge pixels nearby
  int number = kNotStored;
  edges_.visit(pixelsAround(a, b, c), [&](std::size_t pixel) {
    const cv::Point& at = edges_.pixels()[pixel];
    const Lanes u = lanes(static_cast<float>(at.x)) + cv::v_load(kSampleColumns.data());
    const Lanes v = lanes(static_cast<float>(at.y)) + cv::v_load(kSampleRows.data());
    if (!triangle) triangle.emplace(a, b, c);
    const Lanes covered = triangle->covered(u, v);
    if (!cv::v_check_any(covered)) return;
    // Holes are known at the pixels' centres only.
    if (has_holes_ && seen_items_.at<int>(at - place_.tl()) != number_) return;
    if (number == kNotStored) {
      number = static_cast<int>(faces_.size());
      faces_.push_back(makeFace(first, second, third));
    }
    see(covered, u, v, number, samples_[pixel]);
  });
}

/// How far points at a depth of 1 m are, measured as NearLimit::reach is.
Lanes SampleRaster::reachOfUnitDepth(const Lanes& u, const Lanes& v, const NearLimit& limit) const {
  const Lanes one = lanes(1.0F);
  const Lanes3 ray{(u - lanes(cx_)) * lanes(1.0F / fx_), (v - lanes(cy_)) * lanes(1.0F / fy_), one};
  if (limit.axis_C.isZero()) return length(ray);
  return dot(ray, lanes(Eigen::Vector3f(limit.axis_C.cast<float>())));
}

/// Makes samples see a face where it is the nearest so far.
void SampleRaster::see(const Lanes& covered, const Lanes& u, const Lanes& v, int number,
                       PixelSamples& samples) const {
  const SeenFace& face = faces_[static_cast<std::size_t>(number)];
  const Lanes on_plane = lanes(face.origin.z()) +
                         lanes(face.slope.x()) * (u - lanes(face.origin.x())) +
                         lanes(face.slope.y()) * (v - lanes(face.origin.y()));
  // Between those of the corners, however steep a sliver is.
  const Lanes inverse_depth = clamped(on_plane, face.origin.z(), face.nearest);
  const Lanes before = cv::v_load(samples.inverse_depth.data());
  const Lanes least = before * lanes(stands_still_ ? 1.0F - kSame : 1.0F + kSame);
  Lanes nearer = covered & (inverse_depth >= lanes(farthest_)) & (inverse_depth >= least);
  if (view_.near_limit) {
    nearer = nearer & (inverse_depth * lanes(static_cast<float>(view_.near_limit->reach)) <=
                       reachOfUnitDepth(u, v, *view_.near_limit));
  }
  cv::v_store(samples.inverse_depth.data(), cv::v_select(nearer, inverse_depth, before));
  cv::v_store(samples.face.data(),
              cv::v_select(cv::v_reinterpret_as_s32(nearer), cv::v_setall_s32(number),
                           cv::v_load(samples.face.data())));
}

/// The pixels that a triangle's bounds touch; a pixel extends half a pixel from its centre.
cv::Rect SampleRaster::pixelsAround(const Eigen::Vector3f& a, const Eigen::Vector3f& b,
                                    const Eigen::Vector3f& c) const {
  const auto whole = [](float at, int low, int size) {
    const auto end = static_cast<float>(low + size);
    return cvFloor(std::clamp(at + 0.5F, static_cast<float>(low - 1), end));
  };
  const Eigen::Vector2f low = a.head<2>().cwiseMin(b.head<2>()).cwiseMin(c.head<2>());
  const Eigen::Vector2f high = a.head<2>().cwiseMax(b.head<2>()).cwiseMax(c.head<2>());
  return {
      cv::Point(whole(low.x(), place_.x, place_.width), whole(low.y(), place_.y, place_.height)),
      cv::Point(whole(high.x(), place_.x, place_.width) + 1,
                whole(high.y(), place_.y, place_.height) + 1)};
}

SeenFace SampleRaster::makeFace(const Corner& first, const Corner& second,
                                const Corner& third) const {
  const Eigen::Vector3f& a = first.pixel;
  const Eigen::Vector3f b = second.pixel - a;
  const Eigen::Vector3f c = third.pixel - a;
  const float area = b.x() * c.y() - c.x() * b.y();
  SeenFace face;
  face.item = number_;
  face.slope = {(b.z() * c.y() - c.z() * b.y()) / area, (c.z() * b.x() - b.z() * c.x()) / area};
  const auto farther = [](const Eigen::Vector3f& p, const Eigen::Vector3f& q) {
    return p.z() < q.z();
  };
  // The smaller a float, the finer its resolution.
  face.origin = std::min({a, second.pixel, third.pixel}, farther);
  face.nearest = std::max({a.z(), second.pixel.z(), third.pixel.z()});
  face.normal = (second.point_C - first.point_C).cross(third.point_C - first.point_C).normalized();
  if (face.normal.dot(first.point_C) > 0.0F) face.normal = -face.normal;
  return face;
}

}  // namespace synthetic_dataset::render
