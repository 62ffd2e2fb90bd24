#include "render/labels/silhouette_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <opencv2/core.hpp>

#include "render/parts/surface_drawing.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {

/// A picture of a part of the image's plane, in cells of one or more pixels.
struct SilhouettePainter::Window {
  CameraModel camera;
  double left = 0.0;  ///< the first cell's edge [px]
  double top = 0.0;
  double cell_width = 1.0;  ///< [px]
  double cell_height = 1.0;

  [[nodiscard]] Box cell(int u, int v) const {
    return {left + u * cell_width, top + v * cell_height, left + (u + 1) * cell_width,
            top + (v + 1) * cell_height};
  }

  /// The camera's view of `columns` x `rows` cells, the first of which begins at (left, top).
  [[nodiscard]] static Window make(const CameraModel& camera, double left, double top,
                                   double cell_width, double cell_height, const cv::Size& cells);

  /// The camera's own image.
  [[nodiscard]] static Window image(const CameraModel& camera) {
    return {camera, -0.5, -0.5, 1.0, 1.0};
  }

  [[nodiscard]] cv::Rect cellsWithin(const Box& box) const;
};

SilhouettePainter::Window SilhouettePainter::Window::make(const CameraModel& camera, double left,
                                                          double top, double cell_width,
                                                          double cell_height,
                                                          const cv::Size& cells) {
  const Intrinsics& k = camera.intrinsics();
  const Intrinsics inner{k.fx / cell_width, k.fy / cell_height, (k.cx - left) / cell_width - 0.5,
                         (k.cy - top) / cell_height - 0.5};
  return {CameraModel(cells.width, cells.height, inner, camera.near(), camera.far(),
                      camera.distortion()),
          left, top, cell_width, cell_height};
}

/// The cells that a box touches.
cv::Rect SilhouettePainter::Window::cellsWithin(const Box& box) const {
  const auto cell = [](double place, int count) {
    return static_cast<int>(std::clamp(place, 0.0, static_cast<double>(count)));
  };
  const int width = camera.width();
  const int height = camera.height();
  const cv::Point low(cell(std::floor((box.left - left) / cell_width), width),
                      cell(std::floor((box.top - top) / cell_height), height));
  const cv::Point high(cell(std::ceil((box.right - left) / cell_width), width),
                       cell(std::ceil((box.bottom - top) / cell_height), height));
  return {low, high};
}

namespace {

/// The image, extended by its own size on each side.
Box canvasOf(const CameraModel& camera) {
  const int width = camera.width();
  const int height = camera.height();
  return {-width - 0.5, -height - 0.5, 2 * width - 0.5, 2 * height - 0.5};
}

bool holds(const Box& outer, const Box& inner) {
  return outer.left <= inner.left && outer.top <= inner.top && outer.right >= inner.right &&
         outer.bottom >= inner.bottom;
}

void expand(std::optional<Box>& box, const Box& by) {
  if (!box) {
    box = by;
    return;
  }
  *box = {std::min(box->left, by.left), std::min(box->top, by.top), std::max(box->right, by.right),
          std::max(box->bottom, by.bottom)};
}

double areaOf(const Box& box) { return box.width() * box.height(); }

}  // namespace

/// Where everything is at one time.
struct SilhouettePainter::Instant {
  Pose X_WC;
  const std::vector<Pose>& X_WL;
  double end_row;  ///< rows of the image's plane before it have this time
};

struct SilhouettePainter::Subject {
  const LinkSelection& links;
  std::vector<Instant> instants;  ///< in the order of their rows

  [[nodiscard]] bool has(const DrawItem& item) const {
    return links[item.link] && !item.seen_through_in_labels;
  }
};

/// Sums up what the windows show.
class SilhouettePainter::Tally {
 public:
  /// Adds a window whose cells are single pixels.
  /// @param mask  of the window's cells in `region`
  void addPixels(const Window& window, const cv::Rect& region, const cv::Mat& mask) {
    const cv::Rect covered = maskBounds(mask);
    if (covered.empty()) return;
    area_ += cv::countNonZero(mask);
    const Box first = window.cell(region.x + covered.x, region.y + covered.y);
    const Box last = window.cell(region.x + covered.br().x - 1, region.y + covered.br().y - 1);
    expand(box_, {first.left, first.top, last.right, last.bottom});
  }

  /// Adds a window whose cells have any size, and count by their area.
  /// @param known  the part of the plane that has been counted already
  void addCells(const Window& window, const cv::Rect& region, const cv::Mat& mask,
                const Box& known) {
    for (int v = 0; v < mask.rows; ++v) {
      for (int u = 0; u < mask.cols; ++u) {
        if (mask.at<unsigned char>(v, u) == 0) continue;
        const Box cell = window.cell(region.x + u, region.y + v);
        const auto both = intersection(cell, known);
        const double area = areaOf(cell) - (both ? areaOf(*both) : 0.0);
        if (area <= 0.0) continue;
        area_ += area;
        expand(box_, cell);
      }
    }
  }

  [[nodiscard]] std::int64_t pixels() const { return std::llround(area_); }
  [[nodiscard]] const std::optional<Box>& box() const { return box_; }

 private:
  double area_ = 0.0;
  std::optional<Box> box_;
};

SilhouettePainter::SilhouettePainter(const GlFunctions& gl, const DrawList& draw_list, LensEye& eye)
    : gl_(gl),
      draw_list_(draw_list),
      eye_(eye),
      programs_(gl, shaders::kMeshVertex, shaders::kSilhouetteFragment,
                feature::kHoles | feature::kNearLimit) {}

/// A box outside which the subject has no pixels.
std::optional<Box> SilhouettePainter::boundsOf(const Subject& subject,
                                               const CameraModel& camera) const {
  // Bounds through a lens are expensive: they are computed for all items together, which never
  // gives a smaller box.
  const bool together = hasDistortion(camera);
  std::optional<Box> bounds;
  std::vector<Eigen::Vector3d> corners_C;
  const auto add = [&] {
    if (corners_C.empty()) return;
    if (const auto box = camera.projectedBounds(corners_C)) expand(bounds, *box);
    corners_C.clear();
  };
  for (const Instant& instant : subject.instants) {
    const Pose X_CW = instant.X_WC.inverse();
    for (const DrawItem& item : draw_list_.items()) {
      if (!subject.has(item) || item.bounds_V.isEmpty()) continue;
      const Pose X_CV = X_CW * instant.X_WL[item.link] * item.X_LV;
      for (const Eigen::Vector3d& corner : cornersOf(item.bounds_V)) {
        corners_C.push_back(X_CV * corner);
      }
      if (!together) add();
    }
  }
  add();
  if (!bounds) return std::nullopt;
  constexpr double kSlack = 1.0;  // [px] as drawing is in single precision
  return Box{bounds->left - kSlack, bounds->top - kSlack, bounds->right + kSlack,
             bounds->bottom + kSlack};
}

cv::Mat SilhouettePainter::drawPinhole(const Subject& subject, const View& view,
                                       const std::vector<Pose>& X_WL, const cv::Rect& region) {
  const cv::Size size(view.camera.width(), view.camera.height());
  const Framebuffer& target = framebufferFor(gl_, size, {GL_R8}, GL_NONE, target_);
  target.bind(size, region);
  target.clear(0, {});
  for (const DrawItem& item : draw_list_.items()) {
    if (!subject.has(item)) continue;
    drawSurface(gl_, programs_.get(item.features | featuresOf(view)), item, view, X_WL[item.link]);
  }
  return target.read(0, region);
}

/// Draws the cells `region` of a window's camera: CV_8UC1, of the region's size.
cv::Mat SilhouettePainter::drawAt(const Instant& instant, const Subject& subject,
                                  const CameraModel& camera, const cv::Rect& region) {
  const View view{camera, instant.X_WC};
  if (!hasDistortion(camera)) return drawPinhole(subject, view, instant.X_WL, region);
  std::vector<const DrawItem*> items;
  for (const DrawItem& item : draw_list_.items()) {
    if (subject.has(item)) items.push_back(&item);
  }
  return eye_.covered(view, instant.X_WL, items)(region).clone();
}

/// Draws the cells `region` of a window, each row as it is at its time.
cv::Mat SilhouettePainter::draw(const Subject& subject, const Window& window,
                                const cv::Rect& region) {
  if (subject.instants.size() == 1) {
    return drawAt(subject.instants.front(), subject, window.camera, region);
  }
  cv::Mat mask(region.size(), CV_8UC1);
  int first = region.y;
  for (const Instant& instant : subject.instants) {
    int end = first;
    const auto isOfInstant = [&](int row) {
      return window.top + (row + 0.5) * window.cell_height < instant.end_row;
    };
    while (end < region.br().y && isOfInstant(end)) ++end;
    if (end == first) continue;
    const cv::Rect rows(region.x, first, region.width, end - first);
    drawAt(instant, subject, window.camera, rows)
        .copyTo(mask.rowRange(first - region.y, end - region.y));
    first = end;
  }
  return mask;
}

/// Adds what lies around the image up to the canvas's edge, in pictures of the image's size.
void SilhouettePainter::addBesideTheImage(const Subject& subject, const CameraModel& camera,
                                          const Box& bounds, Tally& tally) {
  const cv::Size size(camera.width(), camera.height());
  for (int row = -1; row <= 1; ++row) {
    for (int column = -1; column <= 1; ++column) {
      if (row == 0 && column == 0) continue;
      const Window window =
          Window::make(camera, column * size.width - 0.5, row * size.height - 0.5, 1.0, 1.0, size);
      const cv::Rect region = window.cellsWithin(bounds);
      if (region.empty()) continue;
      tally.addPixels(window, region, draw(subject, window, region));
    }
  }
}

/// Adds what lies beyond the canvas, in enough cells to reach the bounds.
void SilhouettePainter::addFarAway(const Subject& subject, const CameraModel& camera,
                                   const Box& bounds, Tally& tally) {
  const auto edgeBefore = [](double place) { return std::floor(place + 0.5) - 0.5; };
  const double left = edgeBefore(bounds.left);
  const double top = edgeBefore(bounds.top);
  const double cell_width = std::ceil((bounds.right - left) / kCoarseCells);
  const double cell_height = std::ceil((bounds.bottom - top) / kCoarseCells);
  const cv::Size count(static_cast<int>(std::ceil((bounds.right - left) / cell_width)),
                       static_cast<int>(std::ceil((bounds.bottom - top) / cell_height)));
  const Window window = Window::make(camera, left, top, cell_width, cell_height, count);
  const cv::Rect region({0, 0}, count);
  tally.addCells(window, region, draw(subject, window, region), canvasOf(camera));
}

void SilhouettePainter::addBesideTheLens(const Subject& subject, const CameraModel& camera,
                                         const Box& bounds, Tally& tally) {
  constexpr double kMostCells = 4.2e6;  // a lens map takes some 50 bytes per cell, and time to make
  constexpr double kLongestSide = 16384.0;
  const Box canvas = canvasOf(camera);
  const double longest = std::max(canvas.width(), canvas.height());
  const double cell =
      std::ceil(std::max(std::sqrt(areaOf(canvas) / kMostCells), longest / kLongestSide));
  const cv::Size count(static_cast<int>(std::ceil(canvas.width() / cell)),
                       static_cast<int>(std::ceil(canvas.height() / cell)));
  const Window window = Window::make(camera, canvas.left, canvas.top, cell, cell, count);
  const cv::Rect region = window.cellsWithin(bounds);
  if (region.empty()) return;
  tally.addCells(window, region, draw(subject, window, region), camera.imageBounds());
}

Silhouette SilhouettePainter::paint(const View& view, const std::vector<Pose>& X_WL,
                                    const LinkSelection& links,
                                    const std::optional<CoveredPixels>& in_image) {
  constexpr double kAllRows = std::numeric_limits<double>::infinity();
  return paint({links, {{view.X_WC, X_WL, kAllRows}}}, view.camera, in_image);
}

Silhouette SilhouettePainter::paint(const RollingView& rows, const LinkSelection& links) {
  Subject subject{links, {}};
  for (std::size_t i = 0; i < rows.moments.size(); ++i) {
    const RollingMoment& moment = rows.moments[i];
    const bool is_last = i + 1 == rows.moments.size();
    subject.instants.push_back({moment.X_WC, moment.X_WL,
                                is_last ? std::numeric_limits<double>::infinity()
                                        : 0.5 * (moment.row + rows.moments[i + 1].row)});
  }
  std::vector<const DrawItem*> items;
  for (const DrawItem& item : draw_list_.items()) {
    if (subject.has(item)) items.push_back(&item);
  }
  const cv::Rect image(0, 0, rows.camera.width(), rows.camera.height());
  return paint(subject, rows.camera,
               CoveredPixels{image, eye_.covered(rows, RowPoses(rows, draw_list_, links), items)});
}

Silhouette SilhouettePainter::paint(const Subject& subject, const CameraModel& camera,
                                    const std::optional<CoveredPixels>& in_image) {
  Silhouette silhouette;
  const cv::Size image_size(camera.width(), camera.height());
  silhouette.mask = Mask(image_size);
  const std::optional<Box> bounds = boundsOf(subject, camera);
  if (!bounds) return silhouette;
  Tally tally;
  const Window image = Window::image(camera);
  const cv::Rect region = in_image ? in_image->place : image.cellsWithin(*bounds);
  if (!region.empty()) {
    const cv::Mat covered = in_image ? in_image->mask : draw(subject, image, region);
    silhouette.mask = Mask(covered, region.tl(), image_size);
    tally.addPixels(image, region, covered);
    silhouette.pixels_in_image = tally.pixels();
  }
  if (!holds(camera.imageBounds(), *bounds)) {
    if (hasDistortion(camera)) {
      addBesideTheLens(subject, camera, *bounds, tally);
    } else {
      addBesideTheImage(subject, camera, *bounds, tally);
      if (!holds(canvasOf(camera), *bounds)) addFarAway(subject, camera, *bounds, tally);
    }
  }
  silhouette.pixels = tally.pixels();
  silhouette.box = tally.box();
  return silhouette;
}

}  // namespace synthetic_dataset::render
