#include "programs/check/check_report.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <system_error>
#include <vector>

#include <opencv2/core/mat.hpp>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "programs/check/world_map.h"
#include "programs/drawing/scene_picture.h"
#include "run/check/run_check.h"
#include "run/scene_sink.h"
#include "synthetic_dataset/errors.h"
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

/// Some scenes side by side with all labels drawn in: masks, boxes with captions, cuboids,
/// keypoints; above each its name and time. CV_8UC3.
/// @param scenes  at least one, with visible masks and silhouettes
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

namespace fs = std::filesystem;

void write(const fs::path& file, const cv::Mat& picture, std::ostream& out) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(file.string(), picture);
  } catch (const cv::Exception&) {  // its message says no more than the one below
  }
  if (!is_written) throw Error("--out: '" + file.string() + "' cannot be written");
  out << "wrote " << file.string() << '\n';
}

void writePictures(const run::RunCheck& check, const fs::path& folder, std::ostream& out) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!check.scenes.empty()) write(folder / "check.png", checkSheet(check.scenes), out);
  for (const run::MotionSetup& motion : check.setup.motions) {
    const bool is_only = check.setup.motions.size() == 1;
    const std::string name =
        is_only ? "map.png" : "map_" + safeFileName(motion.entry.name) + ".png";
    write(folder / name, worldMap(motion, is_only, check.scenes), out);
  }
}

}  // namespace

bool checkAndPrint(const Value& settings, const fs::path& folder, std::ostream& out) {
  run::WarningList warnings;
  const run::RunCheck check = run::checkRun(settings, warnings);
  for (const std::string& line : run::planLines(check.setup, check.figures)) out << line << '\n';
  if (!check.splits.empty()) out << run::splitLine(check.setup, check.splits) << '\n';
  if (check.variety) out << run::varietyLine(*check.variety) << '\n';
  for (const std::string& note : check.setup.diagnostics.messages(base::Severity::kNote)) {
    out << "note: " << note << '\n';
  }
  for (const run::Finding& finding : check.findings) out << "odd: " << finding.message() << '\n';
  for (const std::string& warning : warnings.messages) out << "odd: " << warning << '\n';
  writePictures(check, folder, out);
  const std::size_t odd = check.findings.size() + warnings.messages.size();
  out << check.scenes.size() << " scenes were made to look at: "
      << (odd == 0 ? "nothing is odd"
                   : std::to_string(odd) + (odd == 1 ? " thing is" : " things are") + " odd")
      << '\n';
  return odd == 0;
}

}  // namespace synthetic_dataset::programs
