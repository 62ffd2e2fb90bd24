#include "programs/drawing/label_sheets.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "plugins/readback/format.h"
#include "plugins/readback/label_overlay.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

namespace {

constexpr int kPanelCaption = 24;
const cv::Scalar kSheetColour = cv::Scalar::all(30);

}  // namespace

LabelSheets::LabelSheets(const std::string& folder, const std::optional<std::string>& writer,
                         std::function<void(const std::string&)> warn)
    : dataset_(folder),
      is_one_(writer.has_value()),
      writers_(dataset_.writers()),
      warn_(std::move(warn)) {
  if (writers_.empty()) throw Error("'" + folder + "': its manifest lists no writers");
  if (!writer) return;
  const std::string names = writerNames();
  const auto found =
      std::find_if(writers_.begin(), writers_.end(),
                   [&](const output::WrittenWriter& each) { return each.name == *writer; });
  if (found == writers_.end()) {
    throw Error("WRITER: found '" + *writer + "'; the dataset has " + names);
  }
  if (formats::formatOf(found->type) == nullptr) {
    throw Error("WRITER: '" + found->name + "' is of type " + found->type +
                ", whose files this tool does not draw");
  }
  writers_ = {*found};
}

std::string LabelSheets::writerNames() const {
  std::string names;
  for (const output::WrittenWriter& each : writers_) {
    names += (names.empty() ? "" : ", ") + each.name;
  }
  return names;
}

/// Without an image where the writer made nothing of the scene that can be read.
formats::LabelledPicture LabelSheets::labelsOf(const output::WrittenWriter& writer,
                                               std::int64_t scene) const {
  const formats::Format* format = formats::formatOf(writer.type);
  if (format == nullptr) return {};
  const output::WrittenSceneRow row = dataset_.scene(scene);
  const formats::WrittenScene written{
      writer.folder, row.name,       row.camera_index, row.stamp, dataset_.files(writer, scene),
      kept_,         writer.settings};
  if (written.files.empty()) return {};
  return format->read(written);
}

std::optional<cv::Mat> LabelSheets::image(std::int64_t scene) const {
  for (const output::WrittenWriter& writer : writers_) {
    try {
      const cv::Mat image = labelsOf(writer, scene).image;
      if (!image.empty()) return image;
    } catch (const Error&) {  // another one has it, too
    }
  }
  return std::nullopt;
}

std::vector<LabelSheets::Panel> LabelSheets::panelsOf(std::int64_t scene) {
  std::vector<Panel> panels;
  for (const output::WrittenWriter& writer : writers_) {
    panels.push_back({writer.name + "  (" + writer.type + ")", {}});
    try {
      const formats::LabelledPicture labels = labelsOf(writer, scene);
      if (!labels.image.empty()) panels.back().picture = formats::drawLabels(labels);
    } catch (const std::exception& error) {
      if (is_one_) throw;
      // After a run that was stopped, formats with files of the whole dataset cannot be read.
      const std::string message = "left out '" + writer.name + "': " + error.what();
      if (warned_.insert(message).second) warn_(message);
    }
  }
  return panels;
}

std::optional<cv::Mat> LabelSheets::sheet(std::int64_t scene) {
  std::vector<Panel> panels = panelsOf(scene);
  panels.erase(std::remove_if(panels.begin(), panels.end(),
                              [](const Panel& panel) { return panel.picture.empty(); }),
               panels.end());
  return sheetOf(panels);
}

std::optional<cv::Mat> LabelSheets::regularSheet(std::int64_t scene) {
  std::vector<Panel> panels = panelsOf(scene);
  for (std::size_t i = panels.size(); i-- > 0;) {
    if (!dataset_.hasPictures(writers_[i])) panels.erase(panels.begin() + static_cast<int>(i));
  }
  return sheetOf(panels);
}

/// The panels in rows that make a sheet about as wide as high.
std::optional<cv::Mat> LabelSheets::sheetOf(const std::vector<Panel>& panels) {
  cv::Size cell;
  for (const Panel& panel : panels) {
    cell.width = std::max(cell.width, panel.picture.cols);
    cell.height = std::max(cell.height, panel.picture.rows);
  }
  if (cell.empty()) return std::nullopt;
  if (panels.size() == 1) return panels.front().picture;
  const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(panels.size()))));
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  cell.height += kPanelCaption;
  cv::Mat sheet(rows * cell.height, columns * cell.width, CV_8UC3, kSheetColour);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const cv::Point corner(static_cast<int>(i) % columns * cell.width,
                           static_cast<int>(i) / columns * cell.height);
    cv::putText(sheet, panels[i].caption, corner + cv::Point(6, 17), cv::FONT_HERSHEY_SIMPLEX, 0.5,
                cv::Scalar::all(240), 1, cv::LINE_AA);
    const cv::Mat& picture = panels[i].picture;
    if (picture.empty()) continue;
    picture.copyTo(sheet(cv::Rect(corner + cv::Point(0, kPanelCaption), picture.size())));
  }
  return sheet;
}

}  // namespace synthetic_dataset::programs
