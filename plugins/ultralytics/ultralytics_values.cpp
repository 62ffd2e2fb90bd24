#include "plugins/ultralytics/ultralytics_values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <sstream>

#include <opencv2/core.hpp>

#include "plugins/readback/files.h"
#include "plugins/readback/json_text.h"
#include "plugins/readback/mask_shapes.h"
#include "plugins/ultralytics/oriented_box.h"
#include "plugins/ultralytics/ultralytics_options.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::formats::ultralytics {
namespace {

/// Keypoints' columns: a name has the same one in all objects of a class.
struct Columns {
  std::map<int, std::vector<std::string>> names;     ///< by class
  std::vector<std::vector<std::size_t>> of_objects;  ///< of each object's keypoints
  std::size_t count = 0;

  explicit Columns(const DatasetInfo& dataset) {
    std::map<int, std::map<std::string, std::size_t>> known;
    for (const ObjectInfo& object : dataset.objects) {
      std::vector<std::size_t> columns;
      for (const std::string& name : object.keypoint_names) {
        auto& of_class = known[object.class_id];
        const auto [column, is_new] = of_class.try_emplace(name, of_class.size());
        if (is_new) names[object.class_id].push_back(name);
        columns.push_back(column->second);
      }
      count = std::max(count, known[object.class_id].size());
      of_objects.push_back(std::move(columns));
    }
  }
};

class UltralyticsValues : public ValueCheck {
 public:
  UltralyticsValues(UltralyticsOptions options, std::vector<double> flips,
                    const DatasetInfo& dataset)
      : options_(std::move(options)),
        flips_(std::move(flips)),
        dataset_(dataset),
        columns_(dataset) {}

  void checkScene(const TrueScene& truth, FoundFiles& files) override {
    const Scene& scene = truth.scene;
    const std::string name = scene.splitFolder() + "/" + scene.flatName();
    splits_.insert(scene.splitFolder());
    files.compareWithScene("images/" + name + "." + options_.image_format, truth);
    const std::string labels = "labels/" + name + ".txt";
    if (options_.hasBoxes()) {
      std::string lines;
      for (const SceneObject& object : scene.objects) lines += boxLine(object, scene.camera);
      files.compareText(labels, lines);
      return;
    }
    const auto file = files.take(labels);
    if (!file) return;
    const std::vector<std::string> lines = readLines(*file);
    std::size_t at = 0;
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled()) continue;
      const Mask& mask = options_.is_whole ? object.silhouette() : object.visible_mask();
      if (mask.empty()) continue;
      if (at == lines.size()) {
        files.differences().add(labels + ": the line of '" + object.name + "' is missing");
        return;
      }
      const std::string where = labels + ", line " + std::to_string(at + 1);
      compareShape(lines[at++], object.class_id, mask, *file, where, files.differences());
    }
    if (at < lines.size()) files.differences().add(labels + ": found lines of no object");
  }

  void checkDataset(FoundFiles& files) override {
    for (const std::string name : {"data.yaml", "dataset.yaml"}) files.compareText(name, yaml());
    std::string names;
    for (const std::string& name : dataset_.classNamesWithoutGaps()) names += name + "\n";
    files.compareText("classes.txt", names);
  }

 private:
  /// Fractions of the image, in 0 .. 1.
  static std::string words(std::initializer_list<std::pair<double, int>> lengths) {
    std::string text;
    for (const auto& [length, size] : lengths) {
      text += " " + fixed(std::clamp(length / size, 0.0, 1.0), kFractionDecimals);
    }
    return text;
  }

  [[nodiscard]] std::string boxLine(const SceneObject& object, const CameraModel& camera) const {
    if (!object.labelled()) return "";
    const auto box = boxOf(object, options_.box, camera);
    if (!box) return "";
    const int width = camera.width();
    const int height = camera.height();
    std::string line =
        std::to_string(object.class_id) + words({{0.5 * (box->left + box->right) + 0.5, width},
                                                 {0.5 * (box->top + box->bottom) + 0.5, height},
                                                 {box->right - box->left, width},
                                                 {box->bottom - box->top, height}});
    if (options_.task != "pose") return line + "\n";
    std::vector<std::string> keypoints(columns_.count, " 0 0 0");
    const auto& columns = columns_.of_objects.at(static_cast<std::size_t>(object.instance - 1));
    for (std::size_t i = 0; i < std::min(columns.size(), object.keypoints.size()); ++i) {
      const Keypoint& keypoint = object.keypoints[i];
      std::string& text = keypoints.at(columns[i]);
      text = " 0 0 0";
      if (!keypoint.pixel || keypoint.state() == KeypointState::kOutside) continue;
      text = words({{keypoint.pixel->x() + 0.5, width}, {keypoint.pixel->y() + 0.5, height}}) +
             (keypoint.state() == KeypointState::kVisible ? " 2" : " 1");
    }
    for (const std::string& keypoint : keypoints) line += keypoint;
    return line + "\n";
  }

  /// A line with a polygon or an oriented box.
  void compareShape(const std::string& line, int class_id, const Mask& mask,
                    const std::filesystem::path& file, const std::string& where,
                    Differences& differences) const {
    const std::vector<std::string> found = wordsOf(line);
    if (found.front() != std::to_string(class_id)) {
      differences.add(where, "class " + found.front(), std::to_string(class_id));
    }
    std::vector<cv::Point2d> points;
    for (std::size_t i = 1; i + 1 < found.size(); i += 2) {
      points.emplace_back(numberOf(found[i], file) * mask.imageSize().width,
                          numberOf(found[i + 1], file) * mask.imageSize().height);
    }
    if (found.size() != 1 + 2 * points.size()) {
      differences.add(where + ": found an odd number of coordinates");
    }
    if (options_.task == "obb") {
      compareOrientedBox(points, mask, where, differences);
    } else {
      compareOutline(points, mask, where, differences);
    }
  }

  static void compareOrientedBox(const std::vector<cv::Point2d>& points, const Mask& mask,
                                 const std::string& where, Differences& differences) {
    constexpr double kTolerance = 1e-4;  // [px]
    const auto right = orientedBox(mask);
    if (!right || points.size() != right->size()) {
      differences.add(where + ": it should have four corners");
      return;
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Eigen::Vector2d& corner = (*right)[i];
      if (std::hypot(points[i].x - corner.x(), points[i].y - corner.y()) <= kTolerance) continue;
      std::ostringstream text;
      text << "the corner " << points[i].x << ", " << points[i].y;
      differences.add(where, text.str(),
                      std::to_string(corner.x()) + ", " + std::to_string(corner.y()));
    }
  }

  /// Points are pixels' centres, but for the four that reach to the outer edges of pixels.
  static void compareOutline(const std::vector<cv::Point2d>& points, const Mask& mask,
                             const std::string& where, Differences& differences) {
    constexpr double kTolerance = 1e-4;  // [px]
    constexpr std::size_t kReaching = 4;
    std::vector<cv::Point> outline;
    std::size_t reaching = 0;
    for (const cv::Point2d& point : points) {
      const cv::Point pixel(static_cast<int>(std::floor(point.x)),
                            static_cast<int>(std::floor(point.y)));
      const double off = std::hypot(point.x - pixel.x - 0.5, point.y - pixel.y - 0.5);
      if (off > kTolerance) {
        ++reaching;
        if (std::abs(off - (0.5 - kOutlineMargin)) > kTolerance) {
          differences.add(where, "a point " + std::to_string(off) + " px from a pixel's centre",
                          "one at it");
        }
      }
      outline.push_back(pixel);
    }
    if (reaching != kReaching) {
      differences.add(where, std::to_string(reaching) + " points at pixels' edges", "four");
    }
    const std::string problem = outlineProblem(outline, mask);
    if (!problem.empty()) differences.add(where + ": " + problem);
  }

  [[nodiscard]] std::string yaml() const {
    std::vector<std::string> splits;  // that have images, in this order
    for (const std::string split : {"train", "val", "test"}) {
      if (splits_.count(split) != 0) splits.push_back(split);
    }
    std::string text =
        "# Ultralytics looks for the images beside this file: as there is no `path`, the folder "
        "can be moved.\n";
    for (const std::string split : {"train", "val"}) {
      const bool is_there = splits_.count(split) != 0;
      text += split + ": images/" + (is_there ? split : splits.empty() ? "train" : splits.front());
      if (!is_there) {
        text += "  # the loader wants it, and the dataset has no images of this split";
      }
      text += "\n";
    }
    if (splits_.count("test") != 0) text += "test: images/test\n";
    text += "names:\n";
    const std::vector<std::string> names = dataset_.classNamesWithoutGaps();
    for (std::size_t i = 0; i < names.size(); ++i) {
      text += "  " + std::to_string(i) + ": " + quotedInJson(names[i]) + "\n";
    }
    return options_.task == "pose" ? text + keypointYaml(names.size()) : text;
  }

  [[nodiscard]] std::string keypointYaml(std::size_t class_count) const {
    std::string text = "kpt_shape: [" + std::to_string(columns_.count) + ", 3]\nflip_idx: [";
    for (std::size_t i = 0; i < columns_.count; ++i) {
      const std::size_t partner = i < flips_.size() ? static_cast<std::size_t>(flips_[i]) : i;
      text += (i > 0 ? ", " : "") + std::to_string(partner);
    }
    text += "]\nkpt_names:\n";
    for (std::size_t id = 0; id < class_count; ++id) {
      const auto of_class = columns_.names.find(static_cast<int>(id));
      text += "  " + std::to_string(id) + ": [";
      for (std::size_t i = 0; i < columns_.count; ++i) {
        const bool is_used = of_class != columns_.names.end() && i < of_class->second.size();
        text += (i > 0 ? ", " : "") +
                quotedInJson(is_used ? of_class->second[i] : "unused_" + std::to_string(i));
      }
      text += "]\n";
    }
    return text;
  }

  UltralyticsOptions options_;
  std::vector<double> flips_;
  DatasetInfo dataset_;
  Columns columns_;
  std::set<std::string> splits_;  ///< that have images
};

}  // namespace

std::unique_ptr<ValueCheck> valueCheck(Parameters& parameters, const DatasetInfo& dataset) {
  UltralyticsOptions options = readUltralyticsOptions(parameters);
  std::vector<double> flips =
      parameters.maybe<std::vector<double>>("flip_idx").value_or(std::vector<double>{});
  return std::make_unique<UltralyticsValues>(std::move(options), std::move(flips), dataset);
}

}  // namespace synthetic_dataset::formats::ultralytics
