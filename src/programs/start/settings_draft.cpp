#include "programs/start/settings_draft.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "config/readers.h"
#include "plugins/readback/format.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

using motion::RecordedFrame;

constexpr double kUnknownSize = 0.8;  // [m] of an object without a model

/// Puts a text in YAML's double quotes.
std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

const RecordedFrame* findFrame(const motion::BagContents& contents, const std::string& name) {
  const auto found = std::find_if(contents.frames.begin(), contents.frames.end(),
                                  [&](const RecordedFrame& each) { return each.name == name; });
  return found == contents.frames.end() ? nullptr : &*found;
}

/// The largest of 1, 2, 5, 10, ... that is not above a rate.
double roundRate(double rate) {
  const double power = std::pow(10.0, std::floor(std::log10(rate)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * power <= rate * (1.0 + 1e-9)) return factor * power;
  }
  return power;
}

class DraftWriter {
 public:
  explicit DraftWriter(const DraftInputs& inputs) : inputs_(inputs) {
    for (const DraftInputs::Object& object : inputs.objects) {
      robots_.push_back(robotNamed(object.name, inputs.contents));
    }
    if (!robots_.empty() && robots_.front()) {
      followed_ = findFrame(inputs.contents, robots_.front()->frame);
    }
  }

  SettingsDraft write() {
    out_ << "# Settings of synthetic_dataset. `check THIS_FILE` says what the run would be and "
            "what is odd,\n"
            "# `generate --config THIS_FILE` makes it; config/params.yaml documents every "
            "setting.\n\n";
    writeRecording();
    writeWorld();
    writeCamera();
    writeLidar();
    writeObjects();
    writeRandomization();
    writeFormats();
    return {out_.str(), gaps_};
  }

 private:
  /// Writes a line that the user has to complete.
  void gap(const std::string& line, const std::string& what) {
    out_ << line << "  # TODO: " << what << '\n';
    gaps_.push_back(what);
  }

  void writeRecording() {
    out_ << "# The recording.\n";
    if (inputs_.bag_files.size() == 1) {
      out_ << "bag_file: " << quoted(inputs_.bag_files.front()) << '\n';
    } else {
      out_ << "bag_file:\n";
      for (const std::string& file : inputs_.bag_files) out_ << "  - " << quoted(file) << '\n';
    }
    writePoseTopics();
    writeWindow();
    out_ << "# The frame in which everything moves; the world's origin is put there.\n";
    if (followed_ != nullptr) {
      out_ << "global_frame: " << quoted(followed_->root) << '\n';
    } else {
      gap("global_frame: map", "which frame is the world's? `inspect BAG` lists them");
    }
    out_ << '\n';
  }

  void writePoseTopics() {
    const std::vector<std::string>& topics = inputs_.contents.pose_topics;
    if (topics.empty()) return;
    out_ << "# Without TF, frames come from these topics.\npose_topics: [";
    for (std::size_t i = 0; i < topics.size(); ++i)
      out_ << (i == 0 ? "" : ", ") << quoted(topics[i]);
    out_ << "]\n";
  }

  /// Chooses the time during which the first object moves, and a rate that gives enough scenes for
  /// a first dataset.
  void writeWindow() {
    if (followed_ == nullptr) return;
    constexpr double kScenes = 200.0;
    constexpr double kStanding = 0.1;  // of the recording
    const motion::RecordedTimes& times = inputs_.contents.times;
    const double all = toSeconds(times.end - times.start);
    const double begin = toSeconds(followed_->moves_from - times.start);
    const double moving = toSeconds(followed_->moves_until - followed_->moves_from);
    double used = all;
    if (moving > 0.0 && moving < (1.0 - kStanding) * all) {
      used = moving;
      out_ << "# " << robots_.front()->name << " stands still before and after this part [s].\n"
           << "start_offset: " << fixed(std::max(begin, 0.0), 1) << '\n'
           << "duration: " << fixed(std::max(moving, 0.1), 1) << '\n';
    }
    const double recorded = fastest();
    const double rate =
        roundRate(std::max(1e-3, std::min(kScenes / std::max(used, 1e-3), recorded)));
    out_ << "# Scenes per second of the recording, whose frames move with " << fixed(recorded, 1)
         << " Hz.\n"
         << "simulated_rate: " << fixed(rate, rate < 1.0 ? 3 : 1) << '\n';
    sweep_rate_ = std::max(sweep_rate_, rate);
  }

  /// The rate of the most frequent frame between the first object and the root [Hz].
  [[nodiscard]] double fastest() const {
    double rate = 0.0;
    const RecordedFrame* frame = followed_;
    for (std::size_t i = 0; frame != nullptr && i < inputs_.contents.frames.size(); ++i) {
      if (frame->period.count() > 0) rate = std::max(rate, 1.0 / toSeconds(frame->period));
      frame = findFrame(inputs_.contents, frame->parents.front());
    }
    return rate > 0.0 ? rate : 1.0;
  }

  void writeWorld() {
    if (inputs_.world) {
      out_ << "# The surroundings.\nworld:\n  file: " << quoted(*inputs_.world) << '\n';
      if (!inputs_.model_folders.empty()) {
        out_ << "  # Where its models are.\n  model_folders:\n";
        for (const std::string& folder : inputs_.model_folders) {
          out_ << "    - " << quoted(folder) << '\n';
        }
      }
      out_ << '\n';
      return;
    }
    out_ << "# The surroundings: a plain ground and the sun. `--world` names one of your own.\n"
            "world: \"$(find synthetic_dataset)/worlds/ground.sdf\"\n\n";
  }

  void writeCamera() {
    out_ << "# The camera.\ncamera:\n";
    if (inputs_.camera_info) {
      out_ << "  info_file: " << quoted(*inputs_.camera_info) << '\n';
    } else if (!inputs_.contents.cameras.empty()) {
      out_ << "  # As it was recorded.\n  info_topic: "
           << quoted(inputs_.contents.cameras.front().topic) << '\n';
    } else {
      gap("  info_file: \"$(find synthetic_dataset)/worlds/pinhole.yaml\"",
          "a pinhole of 640 x 480 stands in for your camera's calibration");
    }
    writeAim();
    const auto frames = motion::cameraFrames(inputs_.contents);
    if (!frames.empty()) {
      out_ << "  # Instead of this, `frame_id: " << frames.front()
           << "` puts the camera where the recording has this frame.\n";
    }
    out_ << '\n';
  }

  /// Puts the camera beside the path of the first object; somewhere near the object if there may be
  /// walls or the path is long.
  void writeAim() {
    if (followed_ == nullptr) {
      gap("  pose: {position: [-4, -3, 2], look_at: [0, 0, 0]}",
          "where does the camera stand, and what does it look at?");
      return;
    }
    constexpr double kFar = 15.0;  // in sizes of the object; beyond that, little is seen of it
    const DraftInputs::Object& object = inputs_.objects.front();
    const double size = object.size > 0.0 ? object.size : kUnknownSize;
    const double distance = std::max(4.0 * size, 0.75 * followed_->extent.norm() + 2.5 * size);
    if (inputs_.world || distance > kFar * size) {
      out_ << "  # Somewhere else for each scene, never inside of anything. `pose: {position: [x, "
              "y, z],\n"
              "  # look_at: "
           << object.name << "}` instead lets it stand and follow with its eye.\n"
           << "  sample: {look_at: any, distance: {uniform: [" << fixed(3.0 * size, 1) << ", "
           << fixed(8.0 * size, 1) << "]}, elevation: {uniform: [deg(8), deg(45)]}}\n";
      return;
    }
    const Eigen::Vector3d p_G = followed_->middle_R + distance * Eigen::Vector3d(-0.75, -0.53, 0.4);
    out_ << "  # Beside the way of " << object.name << ", which it follows with its eye.\n"
         << "  pose: {position: [" << fixed(p_G.x(), 2) << ", " << fixed(p_G.y(), 2) << ", "
         << fixed(p_G.z(), 2) << "], look_at: " << quoted(object.name) << "}\n";
  }

  /// Mounts a lidar on top of the first object, for formats that are made of a lidar's points.
  void writeLidar() {
    const std::vector<std::string>& formats = inputs_.formats;
    if (std::find(formats.begin(), formats.end(), "semantic_kitti") == formats.end()) return;
    out_ << "# The lidar (docs/lidar.md); a sweep has to end before the next scene's begins.\n"
            "lidars:\n  top:\n    model: VLP-16\n    rate: "
         << fixed(sweep_rate_, 1) << '\n';
    if (followed_ == nullptr) {
      gap("    pose: {position: [0, 0, 1], rpy: [0, 0, 0]}", "where does the lidar stand?");
    } else {
      const DraftInputs::Object& object = inputs_.objects.front();
      out_ << "    mounted_on: " << quoted(object.name) << "\n    pose: {position: [0, 0, "
           << fixed(object.size > 0.0 ? object.size : kUnknownSize, 2) << "], rpy: [0, 0, 0]}\n";
    }
    out_ << '\n';
  }

  void writeObjects() {
    out_ << "# The objects: what moves and is labelled.\nrobot_list: [";
    for (std::size_t i = 0; i < inputs_.objects.size(); ++i) {
      out_ << (i == 0 ? "" : ", ") << quoted(inputs_.objects[i].name);
    }
    out_ << "]";
    if (inputs_.objects.empty()) {
      out_ << "  # TODO: which?\n";
      std::string gap = "the recording has no frame that looks like a robot's: robot_list is empty";
      for (const std::string& note : inputs_.contents.notes) gap += "; " + note;
      gaps_.push_back(gap);
    }
    out_ << '\n';
    for (std::size_t i = 0; i < inputs_.objects.size(); ++i) {
      writeObject(inputs_.objects[i], robots_[i]);
    }
    out_ << '\n';
  }

  void writeObject(const DraftInputs::Object& object,
                   const std::optional<motion::RobotFrame>& robot) {
    out_ << quoted(object.name) << ":\n"
         << "  class: " << quoted(object.name) << "  # what a network learns to recognise\n"
         << "  id: " << quoted(object.name) << "\n";
    if (robot) {
      out_ << "  frame: " << quoted(robot->frame) << '\n';
      if (robot->prefix != object.name) {
        const std::string before = robot->prefix.empty() ? "" : robot->prefix + "/";
        out_ << "  link_frames: " << quoted(before + "{link}") << "  # the frames of its links\n";
      }
    } else {
      gap("  frame: base_link", "which frame of the recording is " + object.name + "?");
    }
    if (object.model) {
      out_ << "  model: " << quoted(*object.model) << '\n';
    } else {
      gap("  # model: /path/to/" + object.name + ".urdf",
          "a model of " + object.name +
              " (URDF, xacro or SDF), unless the world has one of this name" + recordedModel());
    }
  }

  [[nodiscard]] std::string recordedModel() const {
    if (inputs_.contents.descriptions.empty()) return "";
    const std::string file = safeFileName(inputs_.contents.descriptions.front().robot) + ".urdf";
    return "; the recording has one: `inspect --urdf BAG > " + file + "`";
  }

  /// If pictures were recorded, suggests labelling these, which serves a network better.
  void writeRandomization() {
    const std::vector<motion::BagTopic>& topics = inputs_.contents.topics;
    const auto pictures = std::find_if(topics.begin(), topics.end(), [](const auto& topic) {
      return topic.type == "sensor_msgs/Image" || topic.type == "sensor_msgs/CompressedImage";
    });
    if (pictures == topics.end()) {
      out_ << "# Light, paint, backgrounds and sensor that differ from scene to scene: networks "
              "that "
              "learn from\n# these find more in photographs (docs/transfer.md).\n"
              "randomize: {preset: transfer}\n\n";
      return;
    }
    out_ << "# The recording has pictures: `camera: {image_topic: " << pictures->name
         << "}` labels these (docs/twin.md).\n"
            "# Where scenes are drawn instead, networks that learn from them find more in "
            "photographs with this:\n# randomize: {preset: transfer}\n\n";
  }

  void writeFormats() {
    out_ << "# Where the dataset goes, and in which formats (docs/formats.md).\n"
            "output_folder: \"$(dirname)/dataset\"\n"
            "# Stretches of the recording to learn from and to validate with, each with all "
            "classes.\n"
            "split: {train: 0.8, val: 0.2, by: balanced_blocks}\n"
            "writers:\n";
    for (const auto& [name, type] : formats::formatNames()) {
      if (std::find(inputs_.formats.begin(), inputs_.formats.end(), name) ==
          inputs_.formats.end()) {
        continue;
      }
      out_ << "  - {name: " << name << ", type: " << type << "}\n";
    }
    for (const std::string& name : inputs_.formats) {
      if (name == "ultralytics") out_ << "ultralytics: {task: detect}\n";
      if (name == "yolo") out_ << "yolo: {main_list: list.txt, class: number}\n";
      if (name == "bounding_shape") {
        out_ << "bounding_shape: {output_frame: "
             << quoted(followed_ != nullptr ? followed_->root : "map") << "}\n";
      }
    }
  }

  const DraftInputs& inputs_;
  std::vector<std::optional<motion::RobotFrame>> robots_;  ///< of the objects
  const RecordedFrame* followed_ = nullptr;                ///< of the first object
  double sweep_rate_ = 10.0;                               ///< a lidar's turns per second [Hz]
  std::ostringstream out_;
  std::vector<std::string> gaps_;
};

}  // namespace

SettingsDraft draftSettings(const DraftInputs& inputs) { return DraftWriter(inputs).write(); }

std::string objectNameOf(const motion::RobotFrame& robot) {
  return robot.name + (config::isSettingGroup(robot.name) ? "_robot" : "");
}

std::optional<motion::RobotFrame> robotNamed(const std::string& name,
                                             const motion::BagContents& contents) {
  const std::vector<motion::RobotFrame> robots = motion::robotFrames(contents);
  for (const motion::RobotFrame& robot : robots) {
    const bool is_named = objectNameOf(robot) == name || robot.name == name;
    if (is_named || robot.prefix == name || robot.frame == name) return robot;
  }
  if (robots.size() == 1) return robots.front();
  return std::nullopt;
}

}  // namespace synthetic_dataset::programs
