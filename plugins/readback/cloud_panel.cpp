#include "plugins/readback/cloud_panel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "plugins/readback/cloud_colours.h"
#include "plugins/readback/cloud_from_above.h"
#include "plugins/readback/range_image.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats {
namespace {

constexpr int kPanelWidth = 1200;  // [px]
constexpr int kFromAbove = 840;    // [px]
constexpr int kStrip = 160;        // height of a range image [px]
constexpr int kTitle = 26;         // above each view [px]
constexpr int kTicks = 22;         // below the lower range image [px]
constexpr int kLine = 24;          // of the legend [px]
constexpr int kPanelFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kPaper = cv::Scalar::all(30);
const cv::Scalar kInk = cv::Scalar::all(232);
const cv::Scalar kFaint = cv::Scalar::all(165);

constexpr double kDegrees = 180.0 / 3.14159265358979323846;

int widthOf(const std::string& text, double size) {
  int baseline = 0;
  return cv::getTextSize(text, kPanelFont, size, 1, &baseline).width;
}

void write(cv::Mat& picture, const std::string& text, const cv::Point& place, double size,
           const cv::Scalar& colour) {
  cv::putText(picture, text, place, kPanelFont, size, colour, 1, cv::LINE_AA);
}

/// Groups thousands: 12,345.
std::string grouped(std::int64_t number) {
  std::string text = std::to_string(number);
  for (auto at = static_cast<std::ptrdiff_t>(text.size()) - 3; at > 0; at -= 3) {
    text.insert(static_cast<std::size_t>(at), ",");
  }
  return text;
}

std::string percent(std::int64_t part, std::int64_t whole) {
  const double share =
      whole > 0 ? 100.0 * static_cast<double>(part) / static_cast<double>(whole) : 0.0;
  return fixed(share, share < 10.0 ? 1 : 0) + " %";
}

/// A list of what is in a cloud, beside the view from above.
class Legend {
 public:
  explicit Legend(cv::Mat picture) : picture_(std::move(picture)) {}

  void write(const std::string& text, double size, const cv::Scalar& colour) {
    formats::write(picture_, text, {kLeft, y_}, size, colour);
    y_ += kLine;
  }

  void skip() { y_ += kLine / 2; }

  /// Writes a row with a coloured mark, a name and a number.
  void row(const cv::Scalar& colour, bool is_hollow, std::string name, const std::string& number) {
    constexpr double kSize = 0.48;
    const int right = picture_.cols - 12;
    const int number_left = right - widthOf(number, kSize);
    constexpr int kText = kLeft + 22;
    while (name.size() > 1 && widthOf(name, kSize) > number_left - kText - 10) name.pop_back();
    cv::rectangle(picture_, cv::Rect(kLeft, y_ - 11, 13, 13), colour, is_hollow ? 1 : cv::FILLED);
    formats::write(picture_, name, {kText, y_}, kSize, kInk);
    formats::write(picture_, number, {number_left, y_}, kSize, kInk);
    y_ += kLine;
  }

  /// How many more lines fit.
  [[nodiscard]] int room() const { return (picture_.rows - y_) / kLine; }

 private:
  static constexpr int kLeft = 14;

  cv::Mat picture_;
  int y_ = 30;
};

/// The numbers with their counts, the greatest count first.
std::vector<std::pair<std::uint16_t, std::int64_t>> byCount(
    const std::map<std::uint16_t, std::int64_t>& counts) {
  std::vector<std::pair<std::uint16_t, std::int64_t>> order(counts.begin(), counts.end());
  std::stable_sort(order.begin(), order.end(),
                   [](const auto& a, const auto& b) { return a.second > b.second; });
  return order;
}

void listClasses(Legend& legend, const LabelledCloud& cloud,
                 const std::map<std::uint16_t, ClassColour>& colours) {
  const auto count = static_cast<std::int64_t>(cloud.points.size());
  const auto order = byCount(pointsOfClasses(cloud));
  const int most = std::max(1, legend.room() / 2 - 1);
  int listed = 0;
  for (const auto& [number, points] : order) {
    if (listed == most && static_cast<int>(order.size()) > most + 1) {
      legend.write("and " + std::to_string(static_cast<int>(order.size()) - listed) + " more", 0.45,
                   kFaint);
      return;
    }
    const auto name = cloud.classes.find(number);
    const auto colour = colours.find(number);
    const bool is_known = name != cloud.classes.end() && colour != colours.end();
    const std::string other = number == 0 ? "of no class" : "class " + std::to_string(number);
    legend.row(is_known ? colour->second.colour : kUnlabelledColour, false,
               is_known ? name->second : other, grouped(points) + "   " + percent(points, count));
    ++listed;
  }
}

void listObjects(Legend& legend, const LabelledCloud& cloud,
                 const std::map<std::uint16_t, ClassColour>& colours) {
  if (cloud.objects.empty()) return;
  legend.skip();
  legend.write("objects, points of each", 0.48, kFaint);
  const auto order = byCount(pointsOfObjects(cloud));
  int left = static_cast<int>(order.size());
  for (const auto& [number, points] : order) {
    if (legend.room() <= 1 && left > 1) {
      legend.write("and " + std::to_string(left) + " more with fewer", 0.45, kFaint);
      return;
    }
    const LabelledCloud::Object& object = cloud.objects.at(number);
    cv::Scalar colour = kUnlabelledColour;
    for (const auto& [of, class_name] : cloud.classes) {
      if (class_name == object.class_name) colour = colours.at(of).colour;
    }
    legend.row(colour, true, object.caption, grouped(points));
    --left;
  }
}

void drawLegend(const cv::Mat& picture, const LabelledCloud& cloud,
                const std::map<std::uint16_t, ClassColour>& colours, double grid) {
  Legend legend(picture);
  const auto count = static_cast<std::int64_t>(cloud.points.size());
  legend.write(cloud.lidar.empty() ? "cloud" : cloud.lidar, 0.7, kInk);
  legend.write(
      grouped(count) + " points" +
          (cloud.rays ? ", " + percent(count, *cloud.rays) + " of " + grouped(*cloud.rays) + " rays"
                      : ""),
      0.5, kInk);
  legend.write("from above, ahead is up; grid of " + metresText(grid) + " m", 0.45, kFaint);
  if (!cloud.has_labels) legend.write("no labels in the files: points in boxes", 0.45, kFaint);
  legend.skip();
  listClasses(legend, cloud, colours);
  listObjects(legend, cloud, colours);
}

/// Draws angle ticks below a range image, from the left edge to the right.
void drawAngles(cv::Mat picture, const RangeImages& images) {
  const double left = images.left * kDegrees;
  const double right = images.right * kDegrees;
  if (left - right < 1e-3) return;
  double step = 1.0;
  for (const double each : {2.0, 5.0, 10.0, 15.0, 30.0, 45.0}) {
    if ((left - right) / step > 10.0) step = each;
  }
  for (double angle = std::floor(left / step) * step; angle >= right - 1e-6; angle -= step) {
    const int u = cvRound((left - angle) / (left - right) * (picture.cols - 1));
    cv::line(picture, {u, 0}, {u, 4}, kFaint, 1);
    const std::string text = std::abs(angle) < 1e-6
                                 ? "ahead"
                                 : fixed(std::abs(angle), 0) + (angle > 0 ? " left" : " right");
    const int width = widthOf(text, 0.42);
    formats::write(picture, text, {std::clamp(u - width / 2, 2, picture.cols - width - 2), 18},
                   0.42, kFaint);
  }
}

void drawStrips(cv::Mat picture, const LabelledCloud& cloud,
                const std::map<std::uint16_t, ClassColour>& colours) {
  const RangeImages images = rangeImages(cloud, colours, {kPanelWidth, kStrip});
  const std::string rows = cloud.has_rings ? "rows by ring" : "rows by elevation";
  write(picture, "range [m], columns by azimuth [deg], " + rows, {14, 18}, 0.48, kInk);
  const cv::Rect scale(kPanelWidth - 260, 6, 180, 14);
  rangeScale(scale.size()).copyTo(picture(scale));
  const std::string nearest = fixed(images.nearest, 1);
  write(picture, nearest, {scale.x - 8 - widthOf(nearest, 0.45), 18}, 0.45, kInk);
  write(picture, fixed(images.farthest, 1), {scale.br().x + 8, 18}, 0.45, kInk);
  images.ranges.copyTo(picture(cv::Rect(0, kTitle, kPanelWidth, kStrip)));
  const int second = kTitle + kStrip;
  write(picture, "classes", {14, second + 18}, 0.48, kInk);
  images.labels.copyTo(picture(cv::Rect(0, second + kTitle, kPanelWidth, kStrip)));
  const int below = second + kTitle + kStrip;
  drawAngles(picture(cv::Rect(0, below, kPanelWidth, kTicks)), images);
}

}  // namespace

cv::Mat drawCloud(LabelledCloud cloud, const std::vector<std::string>& object_classes) {
  const auto isNoNumber = [](const LabelledCloud::Point& point) {
    return !point.position_S.allFinite();
  };
  cloud.points.erase(std::remove_if(cloud.points.begin(), cloud.points.end(), isNoNumber),
                     cloud.points.end());
  const std::map<std::uint16_t, ClassColour> colours = classColours(cloud, object_classes);
  constexpr int kStrips = 2 * (kTitle + kStrip) + kTicks;
  cv::Mat panel(kFromAbove + kStrips, kPanelWidth, CV_8UC3, kPaper);
  const CloudFromAbove above = cloudFromAbove(cloud, colours, kFromAbove);
  above.picture.copyTo(panel(cv::Rect(0, 0, kFromAbove, kFromAbove)));
  drawLegend(panel(cv::Rect(kFromAbove, 0, kPanelWidth - kFromAbove, kFromAbove)), cloud, colours,
             above.grid);
  drawStrips(panel(cv::Rect(0, kFromAbove, kPanelWidth, kStrips)), cloud, colours);
  return panel;
}

}  // namespace synthetic_dataset::formats
