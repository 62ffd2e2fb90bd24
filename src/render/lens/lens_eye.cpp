#include "render/lens/lens_eye.h"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/Geometry>

#include "render/lens/row_raster.h"

namespace synthetic_dataset::render {
namespace {

std::vector<Eigen::Matrix4d> matricesOf(const std::vector<Pose>& poses) {
  std::vector<Eigen::Matrix4d> matrices;
  matrices.reserve(poses.size());
  for (const Pose& pose : poses) matrices.push_back(pose.matrix());
  return matrices;
}

/// Fills in the pixels of a face whose rays see triangles that are not yet known.
/// @param rays  the pixels, in the order of the face's grid
/// @param known  the number of known triangles, which come first in sight.seen
void fillPixels(const std::vector<int>& rays, const std::vector<int>& seen, std::size_t known,
                LensSight& sight) {
  const auto* directions = sight.lens->rays.ptr<cv::Vec3f>();
  auto* items = sight.items.ptr<int>();
  auto* triangles = sight.triangles.ptr<int>();
  auto* distance = sight.distance.ptr<float>();
  const bool in_rows = sight.rows != nullptr;
  std::vector<std::array<Eigen::Vector3d, 3>> corners(1);
  if (!in_rows) {
    corners.clear();
    for (std::size_t i = known; i < sight.seen.size(); ++i) {
      corners.push_back(sight.cornersOf(sight.seen[i]));
    }
  }
  int last = -1;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (seen[i] < static_cast<int>(known)) continue;
    const SeenTriangle& triangle = sight.seen[static_cast<std::size_t>(seen[i])];
    // Each entry of sight.seen is then of one row only, and its pixels are contiguous.
    if (in_rows && seen[i] != last) corners.front() = sight.cornersOf(triangle);
    last = seen[i];
    const auto pixel = static_cast<std::size_t>(rays[i]);
    const Eigen::Vector3d ray = Eigen::Vector3f(directions[pixel].val).cast<double>();
    items[pixel] = triangle.item;
    triangles[pixel] = seen[i];
    distance[pixel] = static_cast<float>(
        distanceTo(corners[in_rows ? 0 : static_cast<std::size_t>(seen[i]) - known], ray));
  }
}

std::shared_ptr<LensSight> copyOf(const LensSight& sight) {
  auto copy = std::make_shared<LensSight>(sight);
  copy->items = sight.items.clone();
  copy->triangles = sight.triangles.clone();
  copy->distance = sight.distance.clone();
  return copy;
}

/// Copies what the rays see from the order of cells to that of rows.
/// @param from  in the order of `cells`
void takeOver(const RaySights& from, const std::vector<RayGrid>& cells,
              const std::vector<RowRayGrid>& rows, RaySights& to) {
  to.seen = from.seen;
  for (std::size_t face = 0; face < cells.size(); ++face) {
    const std::vector<int>& before = cells[face].rays;
    const std::vector<int>& after = rows[face].grid.rays;
    if (before.empty()) continue;
    std::vector<std::size_t> place_of(
        static_cast<std::size_t>(*std::max_element(before.begin(), before.end())) + 1);
    for (std::size_t i = 0; i < before.size(); ++i) {
      place_of[static_cast<std::size_t>(before[i])] = i;
    }
    for (std::size_t i = 0; i < after.size(); ++i) {
      const std::size_t place = place_of[static_cast<std::size_t>(after[i])];
      to.inverse_depths[face][i] = from.inverse_depths[face][place];
      to.triangles[face][i] = from.triangles[face][place];
    }
  }
}

}  // namespace

LensEye::LensEye(const DrawList& draw_list, LensLibrary& lenses, bool keeps)
    : draw_list_(draw_list), lenses_(lenses), keeps_(keeps) {}

void LensEye::forget() {
  surfaces_.reset();
  standing_.clear();
  recent_.forget();
  last_.reset();
  last_in_rows_.reset();
  pyramids_.forgetUnused();
}

const std::shared_ptr<const std::vector<ItemSurface>>& LensEye::surfaces() {
  if (!surfaces_) {
    surfaces_ =
        std::make_shared<const std::vector<ItemSurface>>(itemSurfaces(draw_list_, pyramids_));
  }
  return surfaces_;
}

LensSight LensEye::nothingSeen(const std::shared_ptr<const LensMap>& lens) {
  const cv::Size size = lens->face.size();
  return {lens,
          cv::Mat::zeros(size, CV_32SC1),
          cv::Mat(size, CV_32SC1, cv::Scalar(-1)),
          cv::Mat::zeros(size, CV_32FC1),
          {},
          {},
          surfaces()};
}

/// The pose of each item, by its number.
std::vector<Pose> LensEye::posesOfItems(const Pose& X_CW, const std::vector<Pose>& X_WL) const {
  std::vector<Pose> X_CV = {Pose::Identity()};
  for (const DrawItem& item : draw_list_.items())
    X_CV.push_back(X_CW * X_WL[item.link] * item.X_LV);
  return X_CV;
}

/// Keeps looks from several recurring views, as long as there is room, and from the last one of the
/// other views.
void LensEye::makeRoomFor(const View& view, bool comes_back) {
  constexpr std::size_t kPixelBytes = 20;  // without triangles
  const auto pixels = static_cast<std::size_t>(view.camera.width() * view.camera.height());
  const std::size_t most = RecentViews::maxKept(kPixelBytes * pixels);
  const auto isLeftOver = [&](const Standing& each) {
    return !comes_back && !each.comes_back && each.X_WC != view.X_WC.matrix();
  };
  standing_.erase(std::remove_if(standing_.begin(), standing_.end(), isLeftOver), standing_.end());
  while (standing_.size() >= most) standing_.pop_back();
}

const LensEye::Standing& LensEye::standing(const View& view, const std::vector<Pose>& X_WL,
                                           const LinkSelection& drawn) {
  const auto lens = lenses_.get(view.camera);
  LinkSelection links = draw_list_.standing(drawn);
  const auto known = std::find_if(standing_.begin(), standing_.end(), [&](const Standing& each) {
    return each.lens == lens && each.X_WC == view.X_WC.matrix() && each.drawn == links;
  });
  if (keeps_ && known != standing_.end()) {
    std::rotate(standing_.begin(), known, known + 1);
    return standing_.front();
  }
  if (!keeps_) standing_.clear();
  const bool comes_back = recent_.comesBack(view);
  makeRoomFor(view, comes_back);
  const Pose X_CW = view.X_WC.inverse();
  Standing seen{lens,       view.X_WC.matrix(),     std::move(links),
                comes_back, RaySights(lens->grids), nothingSeen(lens)};
  seen.sight.X_CV = posesOfItems(X_CW, X_WL);
  const RayRaster::IsHole is_hole = holesIn(draw_list_, surfaces());
  const RayRaster raster(view, *lens, lens->grids, is_hole);
  for (const DrawItem* item : draw_list_.solidItems(X_CW, X_WL, drawn, true)) {
    raster.draw(*item, static_cast<int>(draw_list_.numberOf(*item)), X_WL[item->link], seen.sights);
  }
  seen.sight.seen = seen.sights.seen;
  for (std::size_t face = 0; face < lens->grids.size(); ++face) {
    fillPixels(lens->grids[face].rays, seen.sights.triangles[face], 0, seen.sight);
  }
  standing_.push_front(std::move(seen));
  return standing_.front();
}

std::shared_ptr<const LensSight> LensEye::look(const View& view, const std::vector<Pose>& X_WL,
                                               const LinkSelection& drawn, Glass glass) {
  if (glass == Glass::kSeen && !draw_list_.hasGlassInLabels(drawn)) glass = Glass::kSeenThrough;
  Last now{view.X_WC.matrix(), matricesOf(X_WL), drawn, glass, nullptr};
  const auto lens = lenses_.get(view.camera);
  if (keeps_ && last_ && last_->sight->lens == lens && last_->X_WC == now.X_WC &&
      last_->X_WL == now.X_WL && last_->drawn == drawn && last_->glass == glass) {
    return last_->sight;
  }
  const Standing& before = standing(view, X_WL, drawn);
  RaySights sights = before.sights;
  const std::size_t known = sights.seen.size();
  const RayRaster::IsHole is_hole = holesIn(draw_list_, surfaces());
  const RayRaster raster(view, *lens, lens->grids, is_hole);
  const Pose X_CW = view.X_WC.inverse();
  const auto draw = [&](const DrawItem* item) {
    raster.draw(*item, static_cast<int>(draw_list_.numberOf(*item)), X_WL[item->link], sights);
  };
  for (const DrawItem* item : draw_list_.solidItems(X_CW, X_WL, drawn, false)) draw(item);
  if (glass == Glass::kSeen) {
    for (const DrawItem* item : draw_list_.transparentItems(X_CW, X_WL, drawn)) {
      if (!item->seen_through_in_labels) draw(item);
    }
  }
  const std::shared_ptr<LensSight> sight = copyOf(before.sight);
  sight->X_CV = posesOfItems(X_CW, X_WL);
  sight->seen = std::move(sights.seen);
  for (std::size_t face = 0; face < lens->grids.size(); ++face) {
    fillPixels(lens->grids[face].rays, sights.triangles[face], known, *sight);
  }
  now.sight = sight;
  last_ = std::move(now);
  return sight;
}

const std::vector<RowRayGrid>& LensEye::rowGrids(const std::shared_ptr<const LensMap>& lens) {
  if (row_grids_.lens == lens) return row_grids_.grids;
  row_grids_ = {lens, {}};
  const int width = lens->face.cols;
  for (const RayGrid& grid : lens->grids) {
    std::vector<PlacedRay> rays;
    for (std::size_t i = 0; i < grid.count(); ++i) {
      rays.push_back({grid.columns[i], grid.rows[i], grid.rays[i]});
    }
    row_grids_.grids.push_back(makeRowRayGrid(grid.intrinsics, grid.cells, rays, lens->face.rows,
                                              [&](int ray) { return ray / width; }));
  }
  return row_grids_.grids;
}

std::shared_ptr<const LensSight> LensEye::look(const RollingView& rolling,
                                               const LinkSelection& drawn, Glass glass) {
  if (glass == Glass::kSeen && !draw_list_.hasGlassInLabels(drawn)) glass = Glass::kSeenThrough;
  const auto lens = lenses_.get(rolling.camera);
  LastInRows now{lens, {}, {}, drawn, glass, nullptr};
  for (const RollingMoment& moment : rolling.moments) {
    now.rows.push_back(moment.row);
    now.poses.emplace_back(moment.X_WC.matrix());
    for (const Pose& X_WL : moment.X_WL) now.poses.emplace_back(X_WL.matrix());
  }
  if (keeps_ && last_in_rows_ && last_in_rows_->isAs(now)) return last_in_rows_->sight;
  const auto rows = std::make_shared<const RowPoses>(rolling, draw_list_, drawn);
  const RollingMoment middle = rolling.middle();
  const View view{rolling.camera, middle.X_WC};
  const std::vector<RowRayGrid>& grids = rowGrids(lens);
  const Standing* before = rows->cameraStands() ? &standing(view, middle.X_WL, drawn) : nullptr;
  const std::shared_ptr<LensSight> sight =
      copyOf(before != nullptr ? before->sight : nothingSeen(lens));
  RaySights sights(grids);
  std::size_t known = 0;
  if (before != nullptr) {
    takeOver(before->sights, lens->grids, grids, sights);
    known = sights.seen.size();
  }
  const RayRaster::IsHole is_hole = holesIn(draw_list_, surfaces());
  const RowRaster raster(*rows, *lens, grids, is_hole);
  const Pose X_CW = view.X_WC.inverse();
  const auto draw = [&](const DrawItem* item) {
    raster.draw(*item, static_cast<int>(draw_list_.numberOf(*item)), sights);
  };
  for (const bool stand_still : {true, false}) {
    if (stand_still && before != nullptr) continue;
    const auto items = draw_list_.solidItems(X_CW, middle.X_WL, drawn, stand_still);
    std::for_each(items.begin(), items.end(), draw);
  }
  if (glass == Glass::kSeen) {
    for (const DrawItem* item : draw_list_.transparentItems(X_CW, middle.X_WL, drawn)) {
      if (!item->seen_through_in_labels) draw(item);
    }
  }
  sight->X_CV = posesOfItems(X_CW, middle.X_WL);
  sight->rows = rows;
  sight->seen = std::move(sights.seen);
  for (std::size_t face = 0; face < grids.size(); ++face) {
    fillPixels(grids[face].grid.rays, sights.triangles[face], known, *sight);
  }
  now.sight = sight;
  last_in_rows_ = std::move(now);
  return sight;
}

cv::Mat LensEye::covered(const View& view, const std::vector<Pose>& X_WL,
                         const std::vector<const DrawItem*>& covering) {
  const auto lens = lenses_.get(view.camera);
  cv::Mat mask = cv::Mat::zeros(lens->face.size(), CV_8UC1);
  auto* pixels = mask.ptr<std::uint8_t>();
  const RayRaster::IsHole is_hole = holesIn(draw_list_, surfaces());
  const RayRaster raster(view, *lens, lens->grids, is_hole);
  for (const DrawItem* item : covering) {
    raster.visitCovered(*item, X_WL[item->link], [&](int ray) { pixels[ray] = 255; });
  }
  return mask;
}

cv::Mat LensEye::covered(const RollingView& rows, const RowPoses& poses,
                         const std::vector<const DrawItem*>& covering) {
  const auto lens = lenses_.get(rows.camera);
  cv::Mat mask = cv::Mat::zeros(lens->face.size(), CV_8UC1);
  auto* pixels = mask.ptr<std::uint8_t>();
  const RayRaster::IsHole is_hole = holesIn(draw_list_, surfaces());
  const RowRaster raster(poses, *lens, rowGrids(lens), is_hole);
  for (const DrawItem* item : covering) {
    raster.visitCovered(*item, static_cast<int>(draw_list_.numberOf(*item)),
                        [&](int ray) { pixels[ray] = 255; });
  }
  return mask;
}

}  // namespace synthetic_dataset::render
