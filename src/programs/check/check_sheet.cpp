#include "programs/check/check_sheet.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <opencv2/imgproc.hpp>

#include "programs/drawing/scene_picture.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

constexpr int kCellWidth = 640;    // [px]
constexpr int kSceneCaption = 24;  // [px]
constexpr double kSceneFont = 0.5;

cv::Mat cellOf(const run::FinishedScene& finished) {
  const Scene& scene = finished.scene;
  cv::Mat picture = pictureWithLabels(scene);
  if (picture.cols > kCellWidth) {
    const int height = std::max(1, picture.rows * kCellWidth / picture.cols);
    cv::resize(picture, picture, {kCellWidth, height}, 0, 0, cv::INTER_AREA);
  }
  cv::Mat cell(picture.rows + kSceneCaption, picture.cols, CV_8UC3, cv::Scalar::all(30));
  picture.copyTo(cell.rowRange(kSceneCaption, cell.rows));
  cv::putText(cell, scene.name + ", " + fixed(toSeconds(scene.stamp), 3) + " s", {6, 17},
              cv::FONT_HERSHEY_SIMPLEX, kSceneFont, cv::Scalar::all(240), 1, cv::LINE_AA);
  return cell;
}

}  // namespace

cv::Mat checkSheet(const std::vector<run::FinishedScene>& scenes) {
  std::vector<cv::Mat> cells;
  cv::Size size;
  for (const run::FinishedScene& each : scenes) {
    cells.push_back(cellOf(each));
    size.width = std::max(size.width, cells.back().cols);
    size.height = std::max(size.height, cells.back().rows);
  }
  const auto count = static_cast<int>(cells.size());
  const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(count))));
  const int rows = (count + columns - 1) / columns;
  cv::Mat sheet(rows * size.height, columns * size.width, CV_8UC3, cv::Scalar::all(30));
  for (int i = 0; i < count; ++i) {
    const cv::Mat& cell = cells[static_cast<std::size_t>(i)];
    const cv::Point corner(i % columns * size.width, i / columns * size.height);
    cell.copyTo(sheet(cv::Rect(corner, cell.size())));
  }
  return sheet;
}

}  // namespace synthetic_dataset::programs
