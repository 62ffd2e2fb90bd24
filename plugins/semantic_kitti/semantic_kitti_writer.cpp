#include <cmath>
#include <cstdint>
#include <locale>
#include <map>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <pluginlib/class_list_macros.hpp>

#include "plugins/semantic_kitti/semantic_kitti_classes.h"
#include "plugins/shared/cloud_files.h"
#include "plugins/shared/colour_map.h"
#include "plugins/shared/pose_formats.h"
#include "plugins/shared/sequences.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {
namespace {

std::string twoDigits(std::size_t number) {
  std::string digits = std::to_string(number);
  return digits.size() < 2 ? "0" + digits : digits;
}

/// A text as a double-quoted YAML string.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += static_cast<unsigned char>(c) < 0x20U ? ' ' : c;
  }
  return result + "\"";
}

/// The data of a scene kept for the files of its sequence.
struct Frame {
  Stamp stamp{0};
  Pose X_GS = Pose::Identity();
  Pose X_CS = Pose::Identity();
};

std::string textOf(const Frame& frame) {
  return std::to_string(frame.stamp.count()) + "\n" + matrixText(frame.X_GS) + "\n" +
         matrixText(frame.X_CS) + "\n";
}

Pose readMatrix(std::istream& stream) {
  Pose pose = Pose::Identity();
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) stream >> pose.matrix()(row, column);
  }
  return pose;
}

Frame frameOf(const std::string& text) {
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  Frame frame;
  std::int64_t stamp = 0;
  stream >> stamp;
  frame.stamp = Stamp(stamp);
  frame.X_GS = readMatrix(stream);
  frame.X_CS = readMatrix(stream);
  return frame;
}

/// Rounds a pose's numbers, without negative zeros.
Pose rounded(Pose pose) {
  constexpr double kStep = 1e-9;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      double& number = pose.matrix()(row, column);
      if (std::abs(number) < 0.5 * kStep) number = 0.0;
    }
  }
  return pose;
}

}  // namespace

/// SemanticKITTI: `sequences/SS/{velodyne/NNNNNN.bin, labels/NNNNNN.label, image_2/NNNNNN.png,
/// calib.txt, poses.txt, times.txt}` and `semantic-kitti.yaml`, for one lidar; pictures are those
/// of the first camera. A label has the class's number in its lower 16 bits and the object's in the
/// upper 16. https://github.com/PRBonn/semantic-kitti-api
class SemanticKittiWriter : public LabelWriter {
 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& dataset) override {
    if (dataset.lidars.empty()) {
      throw Error("it writes a lidar's clouds, and the run has no `lidars`");
    }
    const std::string name = dataset.lidars.size() == 1 ? parameters.optional<std::string>(
                                                              "lidar", dataset.lidars.front().name)
                                                        : parameters.required<std::string>("lidar");
    lidar_ = dataset.lidarIndex(parameters, "lidar", name).value_or(0);
    lidar_frame_ = dataset.lidars[lidar_].frame;
    global_frame_ = dataset.global_frame;
    images_ = parameters.optional("images", true);
    if (images_) dataset.refuseVaryingIntrinsics("sequences/SS/calib.txt");
    positions_ = readCloudPositions(parameters);
    classes_ = SemanticKittiClasses(parameters, dataset);
    camera_ = dataset.cameras.front().model.intrinsics();
    DatasetInfo of_lidar = dataset;  // one sequence per motion, whatever cameras there are
    of_lidar.cameras.erase(of_lidar.cameras.begin() + 1, of_lidar.cameras.end());
    sequences_ = Sequences(of_lidar);
    splits_ = dataset.splitFolders();
  }

  [[nodiscard]] Requirements doRequirements() const override {
    Requirements requirements;
    requirements.clouds = true;
    requirements.frames = {lidar_frame_};
    return requirements;
  }

  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    if (scene.camera_index != 0) return;  // all cameras of an instant have the same clouds
    const Cloud& cloud = *scene.clouds().at(lidar_);
    const std::string file = "scenes/" + scene.name;
    std::string labels;
    std::map<std::uint32_t, std::int64_t> counts;
    for (const CloudPoint& point : cloud.points) {
      const std::uint32_t number = classes_.numberOf(point);
      appendWord(labels, static_cast<std::uint32_t>(point.instance) << 16U | number);
      ++counts[number];
    }
    const Pose X_GS = scene.transform(global_frame_, lidar_frame_);
    const Frame frame{scene.stamp, rounded(X_GS), rounded(scene.X_GC.inverse() * X_GS)};
    sequences_.noteFrame(scene, file + ".bin", textOf(frame), output);
    output.addText(file + ".bin", velodyneFile(cloud, positions_));
    output.addText(file + ".label", std::move(labels));
    if (images_) {
      warnOfDistortion(scene.camera, output);
      output.addImage(file + ".png", scene.image);
    }
    std::string content;
    for (const auto& [number, name] : classes_.names()) {
      content += (content.empty() ? "" : " ") + std::to_string(counts[number]);
    }
    output.addRecord(kContent, content);
  }

  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    std::map<std::string, std::vector<std::size_t>> by_split;
    std::size_t next = 0;
    for (std::size_t i = 0; i < sequences_.all().size(); ++i) {
      const std::vector<Frame> frames = addFrames(i, twoDigits(next), records, output);
      if (frames.empty()) continue;
      addSequenceFiles(twoDigits(next), frames, output);
      by_split[sequences_.all()[i].split].push_back(next++);
    }
    output.addFile("semantic-kitti.yaml",
                   [&](std::ostream& file) { writeConfig(by_split, records, file); });
  }

  /// Adds the files of a sequence's frames, numbered without gaps.
  [[nodiscard]] std::vector<Frame> addFrames(std::size_t sequence, const std::string& name,
                                             const SceneRecords& records,
                                             DatasetOutput& output) const {
    std::vector<Frame> frames;
    sequences_.forEachFrame(
        sequence, records,
        [&](std::int64_t frame, const std::string& file, const std::string& text) {
          const std::string from = file.substr(0, file.rfind('.'));
          const std::string to = "sequences/" + name + "/";
          output.addLink(to + "velodyne/" + sixDigits(frame) + ".bin", from + ".bin");
          output.addLink(to + "labels/" + sixDigits(frame) + ".label", from + ".label");
          if (images_) output.addLink(to + "image_2/" + sixDigits(frame) + ".png", from + ".png");
          frames.push_back(frameOf(text));
        });
    return frames;
  }

  /// Poses are those of the camera relative to its first frame, as in KITTI's odometry benchmark.
  /// They assume that the scanner does not move relative to the camera; if it does, its own poses,
  /// which follow from these and `Tr`, are still right.
  void addSequenceFiles(const std::string& name, const std::vector<Frame>& frames,
                        DatasetOutput& output) const {
    const std::string folder = "sequences/" + name + "/";
    const Pose& X_CS = frames.front().X_CS;
    const Pose X_SG = frames.front().X_GS.inverse();
    output.addFile(folder + "calib.txt", [&](std::ostream& file) {
      Pose projection = Pose::Identity();
      projection.matrix().topRows<3>() << camera_.fx, 0.0, camera_.cx, 0.0, 0.0, camera_.fy,
          camera_.cy, 0.0, 0.0, 0.0, 1.0, 0.0;
      for (const char* camera : {"P0", "P1", "P2", "P3"}) {
        file << camera << ": " << matrixText(projection) << '\n';
      }
      file << "Tr: " << matrixText(X_CS) << '\n';
    });
    output.addFile(folder + "poses.txt", [&](std::ostream& file) {
      for (const Frame& frame : frames) {
        file << matrixText(rounded(X_CS * X_SG * frame.X_GS * X_CS.inverse())) << '\n';
      }
    });
    output.addFile(folder + "times.txt", [&](std::ostream& file) {
      constexpr int kDecimals = 9;
      for (const Frame& frame : frames) {
        file << fixed(toSeconds(frame.stamp - frames.front().stamp), kDecimals) << '\n';
      }
    });
  }

  /// Writes the configuration in the form read by semantic-kitti-api and training code based on it.
  void writeConfig(const std::map<std::string, std::vector<std::size_t>>& by_split,
                   const SceneRecords& records, std::ostream& file) const {
    const std::map<std::uint32_t, std::string>& names = classes_.names();
    std::vector<std::int64_t> counts(names.size(), 0);
    records.forEach(kContent, [&](std::int64_t, const std::string& record) {
      std::istringstream stream(record);
      stream.imbue(std::locale::classic());
      for (std::int64_t& count : counts) {
        std::int64_t here = 0;
        stream >> here;
        count += here;
      }
    });
    std::int64_t all = 0;
    for (const std::int64_t count : counts) all += count;
    const std::vector<cv::Vec3b> colours = vocColourMap();
    const auto list = [&](const std::string& title, const auto& value) {
      file << title << ":\n";
      std::size_t index = 0;
      for (const auto& [number, name] : names) {
        file << "  " << number << ": " << value(index, number, name) << '\n';
        ++index;
      }
    };
    list("labels",
         [](std::size_t, std::uint32_t, const std::string& name) { return quoted(name); });
    list("color_map", [&](std::size_t index, std::uint32_t, const std::string&) {
      const cv::Vec3b& c = colours[index % colours.size()];
      return "[" + std::to_string(c[0]) + ", " + std::to_string(c[1]) + ", " +
             std::to_string(c[2]) + "]";
    });
    list("content", [&](std::size_t index, std::uint32_t, const std::string&) {
      constexpr int kDecimals = 9;
      return fixed(all > 0 ? static_cast<double>(counts[index]) / static_cast<double>(all) : 0.0,
                   kDecimals);
    });
    list("learning_map", [](std::size_t index, std::uint32_t, const std::string&) {
      return std::to_string(index);
    });
    file << "learning_map_inv:\n";
    std::size_t index = 0;
    for (const auto& [number, name] : names) file << "  " << index++ << ": " << number << '\n';
    file << "learning_ignore:\n";
    for (std::size_t i = 0; i < names.size(); ++i) {
      file << "  " << i << ": " << (i == 0 ? "True" : "False") << '\n';
    }
    file << "split:\n";
    const std::vector<std::pair<std::string, std::string>> splits = {
        {"train", "train"}, {"val", "valid"}, {"test", "test"}};
    for (const auto& [split, name] : splits) {
      file << "  " << name << ":";
      const auto found = by_split.find(split);
      if (found == by_split.end()) {
        file << " []\n";
        continue;
      }
      file << '\n';
      for (const std::size_t sequence : found->second) file << "    - " << sequence << '\n';
    }
  }

  static constexpr const char* kContent = "content";  // channel of records

  std::size_t lidar_ = 0;
  std::string lidar_frame_;
  std::string global_frame_;
  bool images_ = true;
  CloudPositions positions_ = CloudPositions::kAtStamp;
  SemanticKittiClasses classes_;
  Intrinsics camera_;
  Sequences sequences_;
  std::vector<std::string> splits_;
};

}  // namespace synthetic_dataset

PLUGINLIB_EXPORT_CLASS(synthetic_dataset::SemanticKittiWriter, synthetic_dataset::LabelWriter)
