#include "render/lens/lens_eye.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>

namespace synthetic_dataset::render {
namespace {

LinkSelection standingLinks(const DrawList& parts, const LinkSelection& links) {
  LinkSelection selected(links.size(), false);
  for (const Part& part : parts.parts()) {
    if (part.stands_still) selected[part.link] = links[part.link];
  }
  return selected;
}

std::vector<Eigen::Matrix4d> matricesOf(const std::vector<Pose>& poses) {
  std::vector<Eigen::Matrix4d> matrices;
  matrices.reserve(poses.size());
  for (const Pose& pose : poses) matrices.push_back(pose.matrix());
  return matrices;
}

/// Puts what the rays see beyond the triangles that are known into pixels.
/// @param known  the number of these triangles
void fillPixels(const RaySights& sights, std::size_t known, LensSight& sight) {
  const LensMap& lens = *sight.lens;
  const auto first = static_cast<int>(known);
  std::vector<std::array<Eigen::Vector3d, 3>> corners;
  for (std::size_t i = known; i < sight.seen.size(); ++i) {
    const SeenTriangle& triangle = sight.seen[i];
    const auto part = static_cast<std::size_t>(triangle.part);
    corners.push_back(cornersOf(triangle, *(*sight.surfaces)[part].shape, sight.X_CV[part]));
  }
  const auto* rays = lens.rays.ptr<cv::Vec3f>();
  auto* parts = sight.parts.ptr<int>();
  auto* triangles = sight.triangles.ptr<int>();
  auto* distance = sight.distance.ptr<float>();
  for (std::size_t face = 0; face < lens.grids.size(); ++face) {
    const RayGrid& grid = lens.grids[face];
    const std::vector<int>& seen = sights.triangles[face];
    for (std::size_t i = 0; i < grid.count(); ++i) {
      if (seen[i] < first) continue;
      const auto pixel = static_cast<std::size_t>(grid.rays[i]);
      const auto triangle = static_cast<std::size_t>(seen[i]);
      const Eigen::Vector3d ray = Eigen::Vector3f(rays[pixel].val).cast<double>();
      parts[pixel] = sight.seen[triangle].part;
      triangles[pixel] = seen[i];
      distance[pixel] = static_cast<float>(distanceTo(corners[triangle - known], ray));
    }
  }
}

}  // namespace

LensEye::LensEye(const DrawList& parts, LensLibrary& lenses, bool keeps)
    : parts_(parts), lenses_(lenses), keeps_(keeps) {}

void LensEye::forget() {
  surfaces_.reset();
  standing_.clear();
  last_.reset();
  pyramids_.forgetUnused();
}

const std::shared_ptr<const std::vector<PartSurface>>& LensEye::surfaces() {
  if (!surfaces_) {
    surfaces_ = std::make_shared<const std::vector<PartSurface>>(partSurfaces(parts_, pyramids_));
  }
  return surfaces_;
}

const LensEye::Standing& LensEye::standing(const View& view, const std::vector<Pose>& X_WL,
                                           const LinkSelection& drawn) {
  constexpr std::size_t kMost = 8;
  const auto lens = lenses_.get(view.camera);
  LinkSelection links = standingLinks(parts_, drawn);
  const auto known = std::find_if(standing_.begin(), standing_.end(), [&](const Standing& each) {
    return each.lens == lens && each.X_WC == view.X_WC.matrix() && each.drawn == links;
  });
  if (keeps_ && known != standing_.end()) {
    std::rotate(standing_.begin(), known, known + 1);
    return standing_.front();
  }
  if (!keeps_) standing_.clear();
  if (standing_.size() == kMost) standing_.pop_back();
  Standing seen{lens, view.X_WC.matrix(), std::move(links), RaySights(lens->grids), {}};
  const cv::Size size = lens->face.size();
  seen.sight = {lens,
                cv::Mat::zeros(size, CV_32SC1),
                cv::Mat(size, CV_32SC1, cv::Scalar(-1)),
                cv::Mat::zeros(size, CV_32FC1),
                {},
                {Pose::Identity()},
                surfaces()};
  const Pose X_CW = view.X_WC.inverse();
  for (const Part& part : parts_.parts()) {
    seen.sight.X_CV.push_back(X_CW * X_WL[part.link] * part.X_LV);
  }
  const RayRaster::IsHole is_hole = holesIn(parts_, surfaces());
  const RayRaster raster(view, *lens, lens->grids, is_hole);
  for (const Part* part : parts_.solidParts(X_CW, X_WL, drawn, true)) {
    raster.draw(*part, static_cast<int>(parts_.numberOf(*part)), X_WL[part->link], seen.sights);
  }
  seen.sight.seen = seen.sights.seen;
  fillPixels(seen.sights, 0, seen.sight);
  standing_.push_front(std::move(seen));
  return standing_.front();
}

std::shared_ptr<const LensSight> LensEye::look(const View& view, const std::vector<Pose>& X_WL,
                                               const LinkSelection& drawn, Glass glass) {
  if (glass == Glass::kSeen && !parts_.hasGlassInLabels(drawn)) glass = Glass::kSeenThrough;
  Last now{view.X_WC.matrix(), matricesOf(X_WL), drawn, glass, nullptr};
  const auto lens = lenses_.get(view.camera);
  if (keeps_ && last_ && last_->sight->lens == lens && last_->X_WC == now.X_WC &&
      last_->X_WL == now.X_WL && last_->drawn == drawn && last_->glass == glass) {
    return last_->sight;
  }
  const Standing& before = standing(view, X_WL, drawn);
  RaySights sights = before.sights;
  const std::size_t known = sights.seen.size();
  const RayRaster::IsHole is_hole = holesIn(parts_, surfaces());
  const RayRaster raster(view, *lens, lens->grids, is_hole);
  const Pose X_CW = view.X_WC.inverse();
  const auto draw = [&](const Part* part) {
    raster.draw(*part, static_cast<int>(parts_.numberOf(*part)), X_WL[part->link], sights);
  };
  for (const Part* part : parts_.solidParts(X_CW, X_WL, drawn, false)) draw(part);
  if (glass == Glass::kSeen) {
    for (const Part* part : parts_.transparentParts(X_CW, X_WL, drawn)) {
      if (!part->seen_through_in_labels) draw(part);
    }
  }
  auto sight = std::make_shared<LensSight>(before.sight);
  sight->parts = before.sight.parts.clone();
  sight->triangles = before.sight.triangles.clone();
  sight->distance = before.sight.distance.clone();
  sight->X_CV = {Pose::Identity()};
  for (const Part& part : parts_.parts()) {
    sight->X_CV.push_back(X_CW * X_WL[part.link] * part.X_LV);
  }
  sight->seen = std::move(sights.seen);
  fillPixels(sights, known, *sight);
  now.sight = sight;
  last_ = std::move(now);
  return sight;
}

cv::Mat LensEye::covered(const View& view, const std::vector<Pose>& X_WL,
                         const std::vector<const Part*>& covering) {
  const auto lens = lenses_.get(view.camera);
  cv::Mat mask = cv::Mat::zeros(lens->face.size(), CV_8UC1);
  auto* pixels = mask.ptr<std::uint8_t>();
  const RayRaster::IsHole is_hole = holesIn(parts_, surfaces());
  const RayRaster raster(view, *lens, lens->grids, is_hole);
  for (const Part* part : covering) {
    raster.visitCovered(*part, X_WL[part->link], [&](int ray) { pixels[ray] = 255; });
  }
  return mask;
}

}  // namespace synthetic_dataset::render
