#include "programs/drawing/label_sheets.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <opencv2/imgproc.hpp>

#include "plugins/readback/cloud_panel.h"
#include "plugins/readback/format.h"
#include "plugins/readback/label_overlay.h"
#include "programs/drawing/lidar_rays.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {

namespace {

constexpr int kPanelCaption = 24;  // [px]
constexpr int kGap = 8;            // between parts of a panel [px]
const cv::Scalar kSheetColour = cv::Scalar::all(30);

}  // namespace

LabelSheets::LabelSheets(const std::string& folder, const std::optional<std::string>& writer,
                         std::function<void(const std::string&)> warn)
    : dataset_(folder),
      has_single_writer_(writer.has_value()),
      writers_(dataset_.writers()),
      warn_(std::move(warn)) {
  if (writers_.empty()) throw Error("'" + folder + "': its manifest lists no writers");
  const output::RunDescription& run = dataset_.content().run;
  for (const auto& each : run.classes) classes_.push_back(each.name);
  rays_ = raysOfLidars(run);
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

formats::WrittenScene LabelSheets::written(const output::WrittenWriter& writer,
                                           std::int64_t scene) const {
  const output::WrittenSceneRow row = dataset_.scene(scene);
  return {writer.folder, row.name,       row.camera_index, row.stamp, dataset_.files(writer, scene),
          kept_,         writer.settings};
}

/// Returns no image if the writer made nothing of the scene that can be read.
formats::LabelledPicture LabelSheets::labelsOf(const output::WrittenWriter& writer,
                                               std::int64_t scene) const {
  const formats::Format* format = formats::formatOf(writer.type);
  if (format == nullptr) return {};
  const formats::WrittenScene files = written(writer, scene);
  if (files.files.empty()) return {};
  formats::LabelledPicture picture = format->read(files);
  if (format->clouds == nullptr) return picture;
  for (formats::DrawnLabel& label : picture.labels) {  // the same colours as in pictures of clouds
    if (label.colour || label.class_names.size() != 1) continue;
    const auto found = std::find(classes_.begin(), classes_.end(), label.class_names.front());
    if (found != classes_.end()) label.colour = static_cast<std::size_t>(found - classes_.begin());
  }
  return picture;
}

std::vector<formats::LabelledCloud> LabelSheets::cloudsOf(const output::WrittenWriter& writer,
                                                          std::int64_t scene) const {
  const formats::Format* format = formats::formatOf(writer.type);
  if (format == nullptr || format->clouds == nullptr) return {};
  const formats::WrittenScene files = written(writer, scene);
  if (files.files.empty()) return {};
  std::vector<formats::LabelledCloud> clouds = format->clouds(files);
  for (formats::LabelledCloud& cloud : clouds) {
    if (cloud.lidar.empty() && rays_.size() == 1) cloud.lidar = rays_.begin()->first;
    const auto rays = rays_.find(cloud.lidar);
    if (!cloud.rays && rays != rays_.end()) cloud.rays = rays->second;
  }
  return clouds;
}

std::vector<LabelSheets::Sweep> LabelSheets::sweeps(std::int64_t scene) {
  const auto knowledge = [](const formats::LabelledCloud& cloud) {
    const bool has_boxes = std::any_of(cloud.objects.begin(), cloud.objects.end(),
                                       [](const auto& each) { return each.second.corners_S; });
    return 2 * static_cast<int>(cloud.has_labels) + static_cast<int>(has_boxes);
  };
  std::map<std::string, Sweep> best;  // by the lidar's name
  for (const output::WrittenWriter& writer : writers_) {
    reading(writer, [&] {
      for (formats::LabelledCloud& cloud : cloudsOf(writer, scene)) {
        const auto found = best.find(cloud.lidar);
        if (found != best.end() && knowledge(found->second.cloud) >= knowledge(cloud)) continue;
        const std::string lidar = cloud.lidar;
        best[lidar] = {writer.name, std::move(cloud)};
      }
    });
  }
  std::vector<Sweep> sweeps;
  for (auto& [lidar, sweep] : best) sweeps.push_back(std::move(sweep));
  return sweeps;
}

cv::Mat LabelSheets::drawn(const Sweep& sweep) const {
  return formats::drawCloud(sweep.cloud, classes_);
}

void LabelSheets::reading(const output::WrittenWriter& writer, const std::function<void()>& read) {
  try {
    read();
  } catch (const std::exception& error) {
    if (has_single_writer_) throw;
    // After a run that was stopped, formats with files for the whole dataset cannot be read.
    const std::string message = "left out '" + writer.name + "': " + error.what();
    if (warned_.insert(message).second) warn_(message);
  }
}

/// The image with its labels, and the clouds beside it; empty if the writer made none of them.
cv::Mat LabelSheets::pictureOf(const output::WrittenWriter& writer, std::int64_t scene) const {
  std::vector<cv::Mat> parts;
  const formats::LabelledPicture labels = labelsOf(writer, scene);
  if (!labels.image.empty()) parts.push_back(formats::drawLabels(labels));
  for (const formats::LabelledCloud& cloud : cloudsOf(writer, scene)) {
    parts.push_back(formats::drawCloud(cloud, classes_));
  }
  if (parts.size() <= 1) return parts.empty() ? cv::Mat() : parts.front();
  cv::Size size(-kGap, 0);
  for (const cv::Mat& part : parts) {
    size.width += part.cols + kGap;
    size.height = std::max(size.height, part.rows);
  }
  cv::Mat picture(size, CV_8UC3, kSheetColour);
  int left = 0;
  for (const cv::Mat& part : parts) {
    part.copyTo(picture(cv::Rect({left, 0}, part.size())));
    left += part.cols + kGap;
  }
  return picture;
}

std::optional<cv::Mat> LabelSheets::labelledImage(std::int64_t scene) {
  std::optional<cv::Mat> image;
  for (const output::WrittenWriter& writer : writers_) {
    reading(writer, [&] {
      const formats::LabelledPicture labels = labelsOf(writer, scene);
      if (!labels.image.empty()) image = formats::drawLabels(labels);
    });
    if (image) return image;
  }
  return image;
}

std::optional<cv::Mat> LabelSheets::image(std::int64_t scene) const {
  for (const output::WrittenWriter& writer : writers_) {
    try {
      const cv::Mat image = labelsOf(writer, scene).image;
      if (!image.empty()) return image;
    } catch (const Error&) {  // another writer may have it, too
    }
  }
  return std::nullopt;
}

std::vector<LabelSheets::Panel> LabelSheets::panelsOf(std::int64_t scene) {
  std::vector<Panel> panels;
  for (const output::WrittenWriter& writer : writers_) {
    panels.push_back({writer.name + "  (" + writer.type + ")", {}});
    reading(writer, [&] { panels.back().picture = pictureOf(writer, scene); });
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

/// Arranges the panels in about as many columns as rows.
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
