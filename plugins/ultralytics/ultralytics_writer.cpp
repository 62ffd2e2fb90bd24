#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <ostream>
#include <set>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/shared/mask_outlines.h"
#include "plugins/ultralytics/oriented_box.h"
#include "plugins/ultralytics/ultralytics_options.h"
#include "plugins/ultralytics/ultralytics_yaml.h"
#include "synthetic_dataset/box_choice.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

/// A point as fractions of the image's size, as columns of a label. The loader discards an image
/// that has a label with a number outside 0 .. 1.
/// @param place  [px], where the image spans (0, 0) to (width, height)
std::string fractions(const Eigen::Vector2d& place, const CameraModel& camera) {
  const auto fraction = [](double length, int size) {
    return " " +
           fixed(std::clamp(length / size, 0.0, 1.0) + 0.0, kFractionDecimals);  // no negative zero
  };
  return fraction(place.x(), camera.width()) + fraction(place.y(), camera.height());
}

/// From coordinates in which pixel centres are integers to those in which pixel edges are.
const Eigen::Vector2d kToEdges(0.5, 0.5);

std::string boxColumns(const Box& box, const CameraModel& camera) {
  const Eigen::Vector2d centre(0.5 * (box.left + box.right), 0.5 * (box.top + box.bottom));
  return fractions(centre + kToEdges, camera) + fractions({box.width(), box.height()}, camera);
}

/// x, y and the visibility: 2 visible, 1 hidden, 0 (also for x and y) not in the image.
std::string keypointText(const Keypoint& keypoint, const CameraModel& camera) {
  if (!keypoint.pixel || keypoint.state() == KeypointState::kOutside) return " 0 0 0";
  return fractions(*keypoint.pixel + kToEdges, camera) +
         (keypoint.state() == KeypointState::kVisible ? " 2" : " 1");
}

std::string orientedBoxColumns(const Mask& mask, const CameraModel& camera) {
  std::string columns;
  if (const auto corners = orientedBox(mask)) {
    for (const Eigen::Vector2d& corner : *corners) columns += fractions(corner, camera);
  }
  return columns;
}

/// A mask as one polygon through its outermost pixels: loaders convert its points to integers and
/// fill it including its rim (cv::fillPoly), which reproduces the mask. Ultralytics truncates,
/// supervision rounds; at a quarter of a pixel from its corner both yield the same pixel.
/// Ultralytics also uses the box around the points as the object's, hence the polygon has a spike
/// on each side that reaches the edge of an outermost pixel.
std::string ringColumns(const Mask& mask, const CameraModel& camera) {
  const Eigen::Vector2d kInside(0.25, 0.25);
  struct Side {
    Eigen::Vector2d outwards;
    double farthest = -std::numeric_limits<double>::infinity();
  };
  std::array<Side, 4> sides = {Side{{-1.0, 0.0}}, Side{{0.0, -1.0}}, Side{{1.0, 0.0}},
                               Side{{0.0, 1.0}}};
  const masks::Ring ring = masks::centreRing(mask);
  for (const cv::Point& pixel : ring) {
    for (Side& side : sides) {
      side.farthest = std::max(side.farthest, side.outwards.dot(Eigen::Vector2d(pixel.x, pixel.y)));
    }
  }
  std::string columns;
  for (const cv::Point& pixel : ring) {
    const Eigen::Vector2d centre(pixel.x, pixel.y);
    columns += fractions(centre + kInside, camera);
    for (Side& side : sides) {
      if (side.outwards.dot(centre) != side.farthest) continue;
      side.farthest = std::numeric_limits<double>::infinity();  // one pixel per side is enough
      const double to_edge =
          side.outwards.sum() > 0.0 ? 0.75 - kOutlineMargin : 0.25 - kOutlineMargin;
      columns += fractions(centre + kInside + to_edge * side.outwards, camera);
      columns += fractions(centre + kInside, camera);
    }
  }
  return columns;
}

}  // namespace

/// Ultralytics' YOLO: `images/<split>/N.png`, `labels/<split>/N.txt` with one line per object: the
/// class's number and the columns that the task requires, as fractions of the image; and
/// `data.yaml`. https://docs.ultralytics.com/datasets/, ultralytics/data/utils.py
/// (verify_image_label)
class UltralyticsYoloWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    options_ = readUltralyticsOptions(parameters);
    yaml_.names = dataset.classNamesWithoutGaps();
    if (options_.task == "pose") readKeypoints(parameters, dataset);
  }

  void readKeypoints(WriterParameters& parameters, const DatasetInfo& dataset) {
    KeypointColumns columns = keypointColumns(dataset, yaml_.names.size());
    std::size_t& count = yaml_.keypoint_count;
    for (const auto& of_class : columns.names) count = std::max(count, of_class.size());
    if (count == 0) {
      parameters.addError("task", "found 'pose'; it should be another: no object has keypoints");
    }
    yaml_.kpt_names = std::move(columns.names);
    columns_of_ = std::move(columns.of_objects);
    yaml_.flip_idx.resize(count);
    std::iota(yaml_.flip_idx.begin(), yaml_.flip_idx.end(), std::size_t{0});
    if (const auto given = parameters.maybe<std::vector<double>>("flip_idx")) {
      readFlipIndices(parameters, *given);
    }
  }

  void readFlipIndices(WriterParameters& parameters, const std::vector<double>& given) {
    const std::set<double> different(given.begin(), given.end());
    const auto isIndex = [&](double number) {
      return number >= 0.0 && number < static_cast<double>(given.size()) &&
             number == std::floor(number);
    };
    const auto isPartner = [&](double number) {  // is its partner's partner
      return isIndex(number) &&
             given[static_cast<std::size_t>(given[static_cast<std::size_t>(number)])] == number;
    };
    if (given.size() != yaml_.keypoint_count || different.size() != given.size() ||
        !std::all_of(given.begin(), given.end(), isIndex) ||
        !std::all_of(given.begin(), given.end(), isPartner)) {
      parameters.addError("flip_idx", "found " + parameters.required<Value>("flip_idx").text() +
                                          "; it should be the numbers from 0 to " +
                                          std::to_string(yaml_.keypoint_count) +
                                          " - 1, each once: each keypoint's mirror partner, "
                                          "and vice versa");
      return;
    }
    for (std::size_t i = 0; i < given.size(); ++i) {
      yaml_.flip_idx[i] = static_cast<std::size_t>(given[i]);
    }
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements = requirementsOf(options_.box);
    requirements.silhouettes = options_.is_whole;
    requirements.keypoint_states = options_.task == "pose";
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    std::string labels;
    for (const SceneObject& object : scene.objects) {
      if (!object.labelled()) continue;
      if (const std::string columns = columnsOf(object, scene.camera); !columns.empty()) {
        labels += std::to_string(object.class_id) + columns + "\n";
      }
    }
    const std::string split = scene.splitFolder();
    const std::string name = split + "/" + scene.flatName();
    output.addImage("images/" + name + "." + options_.image_format, scene.image);
    output.addText("labels/" + name + ".txt", labels);
    output.addRecord(kSplits, split);
  }

  /// The columns after the class in an object's line; empty if it has no such label.
  [[nodiscard]] std::string columnsOf(const SceneObject& object, const CameraModel& camera) const {
    const Mask& mask = options_.is_whole ? object.silhouette() : object.visible_mask();
    if (options_.task == "obb") return orientedBoxColumns(mask, camera);
    if (options_.task == "segment") return ringColumns(mask, camera);
    const auto box = boxOf(object, options_.box, camera);
    if (!box) return "";
    std::string columns = boxColumns(*box, camera);
    std::vector<std::string> keypoints(yaml_.keypoint_count, " 0 0 0");
    if (options_.task == "pose") {
      const auto& places = columns_of_.at(static_cast<std::size_t>(object.instance - 1));
      for (std::size_t i = 0; i < places.size(); ++i) {
        keypoints[places[i]] = keypointText(object.keypoints.at(i), camera);
      }
    }
    for (const std::string& keypoint : keypoints) columns += keypoint;
    return columns;
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    std::set<std::string> used;
    records.forEach(kSplits,
                    [&](std::int64_t /*scene*/, const std::string& split) { used.insert(split); });
    UltralyticsDataset yaml = yaml_;
    for (const std::string split : {"train", "val", "test"}) {
      if (used.erase(split) > 0) yaml.splits.push_back(split);
    }
    yaml.splits.insert(yaml.splits.end(), used.begin(), used.end());
    const auto add = [&](const std::string& name, const std::string& purpose) {
      output.addFile(name, [&](std::ostream& stream) {
        stream << "# " << purpose << '\n';
        writeUltralyticsYaml(stream, yaml);
      });
    };
    add("data.yaml",
        "For Ultralytics: `yolo " + options_.task + " train data=/path/to/data.yaml`.");
    add("dataset.yaml", "For FiftyOne, which looks for this name; the rest is that of data.yaml.");
    // Label Studio looks for classes.txt.
    output.addFile("classes.txt", [&](std::ostream& stream) {
      for (const std::string& name : yaml.names) stream << name << '\n';
    });
  }

  static constexpr const char* kSplits = "splits";  // channel of records

  UltralyticsOptions options_;
  UltralyticsDataset yaml_;                           ///< without the splits
  std::vector<std::vector<std::size_t>> columns_of_;  ///< column of each object's keypoints
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::UltralyticsYoloWriter, synthetic_dataset::LabelWriter)
