#include "plugins/readback/cloud_from_above.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats {
namespace {

const cv::Scalar kGround = cv::Scalar::all(18);
const cv::Scalar kGridColour = cv::Scalar::all(52);
const cv::Scalar kAxisColour = cv::Scalar::all(84);
const cv::Scalar kCaptionInk = cv::Scalar::all(215);
constexpr int kCaptionFont = cv::FONT_HERSHEY_SIMPLEX;
constexpr double kCaptionSize = 0.45;
constexpr int kFractionBits = 4;

/// The value below which a share of all values lies. @param values  not empty; their order changes
double quantile(std::vector<float>& values, double share) {
  const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + place, values.end());
  return values[static_cast<std::size_t>(place)];
}

/// Maps the scanner's x-y plane to the picture.
class View {
 public:
  View(const LabelledCloud& cloud, int size) : size_(size) {
    constexpr double kShown = 0.99;       // share of points shown, per axis and direction
    constexpr double kMargin = 1.08;      // around these
    constexpr double kSmallest = 1.0;     // half the extent shown [m]
    std::array<double, 2> low{0.0, 0.0};  // the scanner is in the picture
    std::array<double, 2> high{0.0, 0.0};
    for (int axis = 0; axis < 2 && !cloud.points.empty(); ++axis) {
      std::vector<float> values;
      for (const LabelledCloud::Point& each : cloud.points) values.push_back(each.position_S[axis]);
      const auto i = static_cast<std::size_t>(axis);
      low[i] = std::min(0.0, quantile(values, 1.0 - kShown));
      high[i] = std::max(0.0, quantile(values, kShown));
    }
    centre_ = {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1])};
    const double half = 0.5 * std::max(high[0] - low[0], high[1] - low[1]);
    reach_ = kMargin * std::max(half, kSmallest);
    scale_ = 0.5 * size / reach_;
  }

  [[nodiscard]] cv::Point2d pixel(double x, double y) const {
    return {0.5 * size_ - (y - centre_.y) * scale_, 0.5 * size_ - (x - centre_.x) * scale_};
  }
  [[nodiscard]] bool shows(const cv::Point2d& pixel) const {
    return pixel.x >= 0.0 && pixel.y >= 0.0 && pixel.x < size_ - 1 && pixel.y < size_ - 1;
  }
  [[nodiscard]] double reach() const { return reach_; }
  [[nodiscard]] const cv::Point2d& centre() const { return centre_; }

 private:
  int size_ = 0;
  cv::Point2d centre_;
  double reach_ = 1.0;
  double scale_ = 1.0;  // [px/m]
};

cv::Point shifted(const cv::Point2d& p) {
  constexpr double kScale = 1 << kFractionBits;
  return {cvRound(p.x * kScale), cvRound(p.y * kScale)};
}

/// A round grid spacing that yields about ten lines in the picture.
double gridOf(const View& view) {
  const double wanted = 2.0 * view.reach() / 10.0;
  const double decade = std::pow(10.0, std::floor(std::log10(wanted)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * decade >= wanted) return factor * decade;
  }
  return 10.0 * decade;
}

void drawGrid(cv::Mat& picture, const View& view, double grid) {
  const int size = picture.cols;
  const auto line = [&](const cv::Point2d& from, const cv::Point2d& to, bool is_axis) {
    cv::line(picture, shifted(from), shifted(to), is_axis ? kAxisColour : kGridColour, 1,
             cv::LINE_AA, kFractionBits);
  };
  const auto write = [&](const std::string& text, const cv::Point& place) {
    cv::putText(picture, text, place, kCaptionFont, 0.9 * kCaptionSize, cv::Scalar::all(150), 1,
                cv::LINE_AA);
  };
  const auto first = [&](double middle) {
    return std::ceil((middle - view.reach()) / grid) * grid;
  };
  for (double x = first(view.centre().x); x <= view.centre().x + view.reach(); x += grid) {
    const double v = view.pixel(x, 0.0).y;
    line({0.0, v}, {1.0 * size, v}, std::abs(x) < 0.5 * grid);
    if (v > 20 && v < size - 30) write(metresText(x), {4, cvRound(v) - 4});
  }
  for (double y = first(view.centre().y); y <= view.centre().y + view.reach(); y += grid) {
    const double u = view.pixel(0.0, y).x;
    line({u, 0.0}, {u, 1.0 * size}, std::abs(y) < 0.5 * grid);
    if (u > 40 && u < size - 60) write(metresText(y), {cvRound(u) + 4, size - 6});
  }
  write("x [m]", {4, 14});
  write("y [m]", {size - 46, size - 6});
}

void drawPoints(cv::Mat& picture, const View& view, const LabelledCloud& cloud,
                const std::map<std::uint16_t, ClassColour>& colours) {
  constexpr int kWidth = 2;  // [px]
  const auto draw = [&](bool of_objects) {
    for (const LabelledCloud::Point& point : cloud.points) {
      const auto found = colours.find(point.number);
      const bool is_of_object = found != colours.end() && !found->second.is_of_world;
      if (is_of_object != of_objects) continue;
      const cv::Point2d place = view.pixel(point.position_S.x(), point.position_S.y());
      if (!view.shows(place)) continue;
      const cv::Scalar& colour = found == colours.end() ? kUnlabelledColour : found->second.colour;
      cv::rectangle(picture, {static_cast<int>(place.x), static_cast<int>(place.y), kWidth, kWidth},
                    colour, cv::FILLED);
    }
  };
  draw(false);
  draw(true);  // on top of their surroundings
}

/// Draws an arrow that points ahead.
void drawScanner(cv::Mat& picture, const View& view) {
  const cv::Point2d at = view.pixel(0.0, 0.0);
  const std::vector<cv::Point> arrow = {
      shifted({at.x, at.y - 11.0}), shifted({at.x + 7.0, at.y + 8.0}), shifted({at.x, at.y + 4.0}),
      shifted({at.x - 7.0, at.y + 8.0})};
  cv::fillPoly(picture, std::vector<std::vector<cv::Point>>{arrow}, cv::Scalar::all(255),
               cv::LINE_AA, kFractionBits);
  cv::polylines(picture, arrow, true, cv::Scalar::all(0), 1, cv::LINE_AA, kFractionBits);
}

/// The outline from above of an object's box or, without one, of its points; empty if it has
/// neither.
std::vector<cv::Point2f> outlineOf(std::uint16_t number, const LabelledCloud::Object& object,
                                   const LabelledCloud& cloud, const View& view) {
  std::vector<cv::Point2f> outline;
  if (object.corners_S) {
    std::vector<cv::Point2f> corners;
    for (const Eigen::Vector3d& corner : *object.corners_S) {
      corners.emplace_back(view.pixel(corner.x(), corner.y()));
    }
    cv::convexHull(corners, outline);
    return outline;
  }
  std::optional<cv::Rect2d> bounds;
  for (const LabelledCloud::Point& point : cloud.points) {
    if (point.object != number) continue;
    const cv::Point2d place = view.pixel(point.position_S.x(), point.position_S.y());
    const cv::Rect2d pixel(place.x, place.y, 2.0, 2.0);
    bounds = bounds ? *bounds | pixel : pixel;
  }
  if (!bounds) return outline;
  const cv::Point2d margin(2.0, 2.0);
  const cv::Point2f low = bounds->tl() - margin;
  const cv::Point2f high = bounds->br() + margin;
  return {low, {high.x, low.y}, high, {low.x, high.y}};
}

/// Writes captions beside outlines without overlap.
class Captions {
 public:
  explicit Captions(cv::Mat& picture) : picture_(picture) {}

  void keepFree(const cv::Rect& place) { taken_.push_back(place); }

  /// Leaves out a caption for which there is no room.
  void write(const std::string& text, const cv::Rect& beside, const cv::Scalar& colour) {
    constexpr int kGap = 5;
    int baseline = 0;
    const cv::Size size =
        cv::getTextSize(text, kCaptionFont, kCaptionSize, 1, &baseline) + cv::Size(6, 8);
    const int middle = beside.y + beside.height / 2 - size.height / 2;
    const int left = beside.x + beside.width / 2 - size.width / 2;
    for (const cv::Point& corner :
         {cv::Point(left, beside.y - kGap - size.height), cv::Point(left, beside.br().y + kGap),
          cv::Point(beside.br().x + kGap, middle),
          cv::Point(beside.x - kGap - size.width, middle)}) {
      const cv::Rect place(corner, size);
      const cv::Rect all({0, 0}, picture_.size());
      const bool is_free = (place & all) == place &&
                           std::none_of(taken_.begin(), taken_.end(), [&](const cv::Rect& each) {
                             return (each & place).area() > 0;
                           });
      if (!is_free) continue;
      cv::rectangle(picture_, place, kGround, cv::FILLED);
      cv::rectangle(picture_, place, colour, 1);
      cv::putText(picture_, text, {place.x + 3, place.br().y - 5}, kCaptionFont, kCaptionSize,
                  kCaptionInk, 1, cv::LINE_AA);
      taken_.push_back(place);
      return;
    }
  }

 private:
  cv::Mat& picture_;
  std::vector<cv::Rect> taken_;
};

void drawObjects(cv::Mat& picture, const View& view, const LabelledCloud& cloud,
                 const std::map<std::uint16_t, ClassColour>& colours) {
  std::map<std::string, cv::Scalar> by_name;
  for (const auto& [number, name] : cloud.classes) by_name[name] = colours.at(number).colour;
  std::map<std::uint16_t, cv::Rect> places;
  Captions captions(picture);
  for (const auto& [number, object] : cloud.objects) {
    const std::vector<cv::Point2f> outline = outlineOf(number, object, cloud, view);
    if (outline.empty()) continue;
    std::vector<cv::Point> corners;
    for (const cv::Point2f& each : outline) corners.push_back(shifted(each));
    cv::polylines(picture, corners, true, by_name[object.class_name], 1, cv::LINE_AA,
                  kFractionBits);
    const cv::Rect place = cv::boundingRect(outline);
    if ((place & cv::Rect({0, 0}, picture.size())).area() == 0) continue;
    places[number] = place;
    captions.keepFree(place);
  }
  const std::map<std::uint16_t, std::int64_t> counts = pointsOfObjects(cloud);
  for (const auto& [number, place] : places) {
    const LabelledCloud::Object& object = cloud.objects.at(number);
    captions.write(object.caption + ": " + std::to_string(counts.at(number)), place,
                   by_name[object.class_name]);
  }
}

}  // namespace

std::string metresText(double metres) {
  constexpr int kDecimals = 3;
  std::string text = fixed(metres, kDecimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

CloudFromAbove cloudFromAbove(const LabelledCloud& cloud,
                              const std::map<std::uint16_t, ClassColour>& colours, int size) {
  const View view(cloud, size);
  CloudFromAbove made{cv::Mat(size, size, CV_8UC3, kGround), gridOf(view)};
  drawGrid(made.picture, view, made.grid);
  drawPoints(made.picture, view, cloud, colours);
  drawScanner(made.picture, view);
  drawObjects(made.picture, view, cloud, colours);
  return made;
}

}  // namespace synthetic_dataset::formats
