/// The tool `draw_labels`: draws a written dataset's labels on its images, from the files alone,
/// for the eye.
///
///   rosrun synthetic_dataset draw_labels DATASET PICTURE [SCENE [WRITER]]
///
/// DATASET is the folder of the run's manifest. Without SCENE, the one in the middle; without
/// WRITER, a panel for each writer whose format has something to draw.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "output/written_dataset.h"
#include "plugins/readback/format.h"
#include "plugins/readback/label_overlay.h"
#include "synthetic_dataset/errors.h"

namespace {

using namespace synthetic_dataset;

std::int64_t sceneIndex(const std::string& text) {
  std::int64_t index = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, index);
  if (fault != std::errc() || stopped != end) {
    throw Error("SCENE: found '" + text + "'; it should be a scene's index, a whole number");
  }
  return index;
}

struct Panel {
  std::string caption;
  cv::Mat picture;
};

/// What one writer made of a scene; nothing where it made no picture of it.
std::optional<Panel> panelOf(const output::WrittenDataset& dataset,
                             const output::WrittenWriter& writer, std::int64_t index) {
  const formats::Format* format = formats::formatOf(writer.type);
  if (format == nullptr) return std::nullopt;
  const output::WrittenSceneRow row = dataset.scene(index);
  const formats::WrittenScene scene{writer.folder, row.name, row.camera_index, row.stamp,
                                    dataset.files(writer, index)};
  if (scene.files.empty()) return std::nullopt;
  const formats::LabelledPicture picture = format->read(scene);
  if (picture.image.empty()) return std::nullopt;
  return Panel{writer.name + "  (" + writer.type + ")", formats::drawLabels(picture)};
}

/// The panels in rows that make a sheet about as wide as high.
cv::Mat sheetOf(const std::vector<Panel>& panels) {
  if (panels.size() == 1) return panels.front().picture;
  constexpr int kCaptionHeight = 24;
  const auto columns = static_cast<int>(std::ceil(std::sqrt(static_cast<double>(panels.size()))));
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  cv::Size cell;
  for (const Panel& panel : panels) {
    cell.width = std::max(cell.width, panel.picture.cols);
    cell.height = std::max(cell.height, panel.picture.rows);
  }
  cell.height += kCaptionHeight;
  cv::Mat sheet(rows * cell.height, columns * cell.width, CV_8UC3, cv::Scalar::all(30));
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const cv::Point corner(static_cast<int>(i) % columns * cell.width,
                           static_cast<int>(i) / columns * cell.height);
    cv::putText(sheet, panels[i].caption, corner + cv::Point(6, 17), cv::FONT_HERSHEY_SIMPLEX, 0.5,
                cv::Scalar::all(240), 1, cv::LINE_AA);
    const cv::Mat& picture = panels[i].picture;
    picture.copyTo(sheet(cv::Rect(corner + cv::Point(0, kCaptionHeight), picture.size())));
  }
  return sheet;
}

void writePicture(const std::string& file, const cv::Mat& picture) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(file, picture);
  } catch (const cv::Exception&) {  // an extension that OpenCV does not know
  }
  if (!is_written) {
    throw Error("PICTURE: '" + file +
                "' cannot be written; it should end in .png or .jpg, in a "
                "folder that is there");
  }
}

void drawLabelsOf(const std::vector<std::string>& arguments) {
  const std::string& folder = arguments[0];
  const output::WrittenDataset dataset(folder);
  if (dataset.lists(arguments[1])) {
    throw Error("PICTURE: '" + arguments[1] + "' is a file of the dataset; choose another name");
  }
  const std::int64_t scene =
      arguments.size() > 2 ? sceneIndex(arguments[2]) : dataset.middleScene();
  std::vector<Panel> panels;
  bool is_known = false;
  std::string names;
  for (const output::WrittenWriter& writer : dataset.writers()) {
    names += (names.empty() ? "" : ", ") + writer.name;
    if (arguments.size() > 3 && writer.name != arguments[3]) continue;
    is_known = true;
    if (arguments.size() > 3 && formats::formatOf(writer.type) == nullptr) {
      throw Error("WRITER: '" + writer.name + "' is of type " + writer.type +
                  ", whose files this tool does not draw");
    }
    try {
      if (auto panel = panelOf(dataset, writer, scene)) panels.push_back(std::move(*panel));
    } catch (const std::exception& error) {
      if (arguments.size() > 3) throw;
      // Of a run that was stopped, formats with files of the dataset as a whole cannot be read.
      std::cerr << "draw_labels: left out '" << writer.name << "': " << error.what() << '\n';
    }
  }
  if (dataset.writers().empty()) throw Error("'" + folder + "': its manifest lists no writers");
  if (!is_known) {
    throw Error("WRITER: found '" + arguments[3] + "'; the dataset has " + names);
  }
  if (panels.empty()) {
    throw Error("'" + folder + "': no writer made anything of scene " + std::to_string(scene) +
                " that this tool can draw (of the dataset's writers: " + names + ")");
  }
  writePicture(arguments[1], sheetOf(panels));
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  if (arguments.size() < 2 || arguments.size() > 4) {
    std::cerr << "usage: draw_labels DATASET PICTURE [SCENE [WRITER]]\n";
    return 2;
  }
  try {
    drawLabelsOf(arguments);
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "draw_labels: " << error.what() << '\n';
    return 1;
  }
}
