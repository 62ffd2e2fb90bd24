#include "motion/bag_contents.h"

#include <algorithm>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <utility>

#include <std_msgs/String.h>
#include <Eigen/Geometry>

#include "motion/bag/ros_time.h"
#include "motion/bag/topic_search.h"
#include "motion/frame_names.h"
#include "motion/recorded/recorded_camera_info.h"
#include "motion/tf/bag_reader.h"
#include "motion/tf/pose_messages.h"
#include "motion/tf/tf_topics.h"
#include "motion/tf/transform_recording.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// What is collected from a frame's transforms.
struct Seen {
  std::vector<Stamp> stamps;
  std::set<std::string> publishers;
  bool is_static = true;
};

using SeenFrames = std::map<std::string, Seen>;

void noteTransform(const RecordedTransform& each, SeenFrames& frames) {
  Seen& seen = frames[withoutLeadingSlashes(each.transform.child_frame_id)];
  seen.stamps.push_back(toStamp(each.transform.header.stamp));
  if (!each.publisher.empty()) seen.publishers.insert(each.publisher);
  seen.is_static = seen.is_static && each.kind == TransformKind::kStatic;
}

/// How a topic's messages give poses of frames; null if they do not.
const PoseMessage* poseMessageOf(const BagTopic& topic) {
  const std::vector<PoseMessage>& all = poseMessages();
  const auto found = std::find_if(all.begin(), all.end(), [&](const PoseMessage& message) {
    return message.md5sum == topic.md5sum;
  });
  return found == all.end() ? nullptr : &*found;
}

/// Reads odometry and the like, as runs do if there is no TF.
void readPoses(BagReader& bags, SeenFrames& seen, TransformRecording& recording,
               BagContents& contents) {
  std::vector<std::string>& notes = contents.notes;
  for (const BagTopic& topic : contents.topics) {
    const PoseMessage* const message = poseMessageOf(topic);
    if (message == nullptr) continue;
    const std::string named = topic.name + " (" + topic.type + ")";
    if (!message->names_frames) {
      notes.push_back(named +
                      " has poses of a frame that it does not name: pose_topics: [{topic: " +
                      topic.name + ", frame: NAME}]");
      continue;
    }
    std::vector<RecordedTransform> transforms;
    const TopicReaders readers{{topic.name, {TransformKind::kMoving, [&](const BagMessage& each) {
                                               return message->read(each, "");
                                             }}}};
    bags.read(readers, [&](RecordedTransform each) { transforms.push_back(std::move(each)); });
    const bool is_known =
        std::any_of(transforms.begin(), transforms.end(), [&](const RecordedTransform& each) {
          return seen.count(withoutLeadingSlashes(each.transform.child_frame_id)) != 0;
        });
    notes.push_back(is_known ? named +
                                   " moves a frame that another topic moves: pose_topics should "
                                   "name one of them"
                             : "without TF, frames come from " + named);
    if (is_known) continue;
    contents.pose_topics.push_back(topic.name);
    for (RecordedTransform& each : transforms) {
      noteTransform(each, seen);
      recording.add(std::move(each));
    }
  }
}

/// The root of a frame's chain of parents.
FrameId rootOf(const FrameTree& tree, FrameId frame) {
  std::set<FrameId> passed;
  while (passed.insert(frame).second) {
    const std::vector<FrameId> parents = tree.link(frame).parents();
    if (parents.empty()) break;
    frame = parents.front();
  }
  return frame;
}

int depthOf(const FrameTree& tree, FrameId frame) {
  int depth = 0;
  std::set<FrameId> passed;
  for (; passed.insert(frame).second; ++depth) {
    const std::vector<FrameId> parents = tree.link(frame).parents();
    if (parents.empty()) break;
    frame = parents.front();
  }
  return depth;
}

void measureTimes(const Seen& seen, const LinkHistory& link, const RecordedTimes& times,
                  RecordedFrame& frame) {
  std::vector<Stamp> stamps = seen.stamps;
  std::sort(stamps.begin(), stamps.end());
  frame.count = static_cast<std::int64_t>(stamps.size());
  frame.first = stamps.front();
  frame.last = stamps.back();
  frame.is_static = seen.is_static;
  if (seen.is_static) {
    frame.known = {times};
    return;
  }
  frame.period = link.medianPeriod();
  const Duration longest = std::max<Duration>(std::chrono::seconds(10), 20 * frame.period);
  Stamp from = stamps.front();
  for (std::size_t i = 1; i < stamps.size(); ++i) {
    const Duration gap = stamps[i] - stamps[i - 1];
    if (gap <= longest) continue;
    ++frame.gap_count;
    frame.longest_gap = std::max(frame.longest_gap, gap);
    frame.known.push_back({from, stamps[i - 1]});
    from = stamps[i];
  }
  frame.known.push_back({from, stamps.back()});
}

/// When a frame's origin first and last moves relative to the root, and how far it travels.
void measureMovement(const FrameTree& tree, FrameId root, FrameId id, const RecordedTimes& times,
                     int steps, RecordedFrame& frame) {
  constexpr double kMoves = 0.002;  // [m]
  std::optional<Eigen::Vector3d> before;
  Stamp stamp_before = times.start;
  frame.moves_from = frame.moves_until = frame.first;
  bool has_moved = false;
  std::optional<Eigen::Vector3d> counted;  // end of the measured path; ignores jitter
  for (int i = 0; i <= steps; ++i) {
    const Stamp stamp = times.start + (times.end - times.start) * i / steps;
    const auto pose = tree.transform(root, id, stamp);
    if (!pose) continue;
    if (before && (pose->translation() - *before).norm() > kMoves) {
      if (!has_moved) frame.moves_from = stamp_before;
      has_moved = true;
      frame.moves_until = stamp;
    }
    before = pose->translation();
    if (!counted) counted = before;
    if (const double step = (*before - *counted).norm(); step > kMoves) {
      frame.path_length += step;
      counted = before;
    }
    stamp_before = stamp;
  }
}

/// The extent of a frame's positions, and its largest rotation, in the root's frame.
void measureWay(const FrameTree& tree, FrameId root, FrameId id, const RecordedTimes& times,
                int steps, RecordedFrame& frame) {
  std::optional<Pose> first;
  Eigen::Vector3d low;
  Eigen::Vector3d high;
  for (int i = 0; i <= steps; ++i) {
    const auto pose = tree.transform(root, id, times.start + (times.end - times.start) * i / steps);
    if (!pose) continue;
    const Eigen::Vector3d p_R = pose->translation();
    low = !first ? p_R : Eigen::Vector3d(low.cwiseMin(p_R));
    high = !first ? p_R : Eigen::Vector3d(high.cwiseMax(p_R));
    if (!first) first = pose;
    const Eigen::AngleAxisd turn(Eigen::Matrix3d(first->linear().transpose() * pose->linear()));
    frame.turned = std::max(frame.turned, turn.angle());
  }
  if (!first) return;
  measureMovement(tree, root, id, times, 2 * steps, frame);
  frame.extent = high - low;
  frame.middle_R = 0.5 * (low + high);
}

/// Samples the path of a moving frame, in the global frame.
void traceWay(const FrameTree& tree, FrameId global, FrameId id, const RecordedTimes& times,
              int steps, RecordedFrame& frame) {
  constexpr double kMoves = 0.02;  // [m]
  if (frame.is_static || !(frame.extent.norm() > kMoves)) return;
  for (int i = 0; i <= steps; ++i) {
    const auto pose =
        tree.transform(global, id, times.start + (times.end - times.start) * i / steps);
    if (pose) frame.path_G.emplace_back(pose->translation());
  }
}

/// The number of samples per path: fewer if there are thousands of frames.
int stepsFor(std::size_t frame_count) {
  constexpr std::size_t kMost = 200;
  constexpr std::size_t kLeast = 10;
  constexpr std::size_t kAll = 400000;
  return static_cast<int>(std::clamp(kAll / std::max<std::size_t>(frame_count, 1), kLeast, kMost));
}

/// From the first to the last stamp of moving frames, as record times may be from another clock.
RecordedTimes stampedTimes(const SeenFrames& frames, const RecordedTimes& recorded) {
  RecordedTimes times{Stamp::max(), Stamp::min()};
  for (const auto& [name, seen] : frames) {
    if (seen.is_static) continue;
    const auto [first, last] = std::minmax_element(seen.stamps.begin(), seen.stamps.end());
    times = {std::min(times.start, *first), std::max(times.end, *last)};
  }
  return times.start > times.end ? recorded : times;
}

std::vector<RecordedFrame> framesOf(const FrameTree& tree, const SeenFrames& seen,
                                    const RecordedTimes& times, const std::string& global_frame) {
  const int steps = stepsFor(seen.size());
  const auto global = tree.names().find(withoutLeadingSlashes(global_frame));
  std::vector<std::pair<int, RecordedFrame>> found;
  for (const auto& [name, of] : seen) {
    const auto id = tree.names().find(name);
    if (!id || tree.link(*id).parents().empty()) continue;  // all of its transforms were left out
    RecordedFrame frame;
    frame.name = name;
    const FrameId root = rootOf(tree, *id);
    frame.root = tree.names().of(root);
    for (const FrameId parent : tree.link(*id).parents()) {
      frame.parents.push_back(tree.names().of(parent));
    }
    measureTimes(of, tree.link(*id), times, frame);
    measureWay(tree, root, *id, times, steps, frame);
    traceWay(tree, global.value_or(root), *id, times, steps, frame);
    frame.publishers.assign(of.publishers.begin(), of.publishers.end());
    found.emplace_back(depthOf(tree, *id), std::move(frame));
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<RecordedFrame> frames;
  for (auto& [depth, frame] : found) frames.push_back(std::move(frame));
  return frames;
}

void readCameras(const std::vector<std::string>& bag_files, BagContents& contents) {
  for (const BagTopic& topic : contents.topics) {
    if (topic.type != "sensor_msgs/CameraInfo") continue;
    try {
      const RecordedCameraInfo info = readCameraInfo(bag_files, topic.name);
      const auto numberIn = [&](const char* name) {
        const auto* number = info.info.as<Value::Map>()->at(name).as<std::int64_t>();
        return number == nullptr ? 0 : *number;
      };
      contents.cameras.push_back({topic.name, info.frame, numberIn("width"), numberIn("height")});
      contents.notes.insert(contents.notes.end(), info.notes.begin(), info.notes.end());
    } catch (const Error& error) {
      contents.notes.emplace_back(topic.name + ": " + error.what());
    }
  }
}

/// The first robot model on a topic; nothing if its texts are not URDF.
std::optional<RecordedDescription> readDescription(const std::vector<std::string>& bag_files,
                                                   const std::string& topic) {
  auto search = TopicSearch::of<std_msgs::String>(topic);
  std::optional<RecordedDescription> found;
  for (const std::string& file : bag_files) {
    search.in(file, [&](BagMessages& messages) {
      for (auto message = messages.next(); message && !found; message = messages.next()) {
        const auto text = message->instantiate<std_msgs::String>();
        const std::string robot = text ? robotOf(text->data) : "";
        if (!robot.empty()) found = {topic, robot, text->data};
      }
    });
  }
  return found;
}

void readDescriptions(const std::vector<std::string>& bag_files, BagContents& contents) {
  for (const BagTopic& topic : contents.topics) {
    const bool is_description = topic.type == "std_msgs/String" &&
                                topic.name.find("robot_description") != std::string::npos;
    if (!is_description) continue;
    try {
      const auto found = readDescription(bag_files, topic.name);
      if (found) contents.descriptions.push_back(*found);
    } catch (const Error& error) {
      contents.notes.emplace_back(topic.name + ": " + error.what());
    }
  }
}

std::string lastPartOf(const std::string& frame) { return frame.substr(frame.rfind('/') + 1); }

}  // namespace

BagContents readContents(const std::vector<std::string>& bag_files,
                         const std::string& global_frame) {
  BagReader bags(bag_files);
  BagContents contents;
  contents.topics = bags.topics();
  std::sort(contents.topics.begin(), contents.topics.end(),
            [](const BagTopic& a, const BagTopic& b) { return a.name < b.name; });
  for (const auto& bag : bags.bags()) {
    const std::string kind = bag->kind();
    const auto known = std::find(contents.kinds.begin(), contents.kinds.end(), kind);
    if (known == contents.kinds.end()) contents.kinds.push_back(kind);
  }
  contents.notes = bags.notes();
  const TfTopics tf = findTfTopics(bags);
  if (!tf.note.empty()) contents.notes.push_back(tf.note);
  for (const std::string& topic : tf.ignored) {
    contents.notes.push_back("TF in " + topic + " is not read (tf_topics can name it)");
  }
  SeenFrames seen;
  TransformRecording recording;
  bags.read(tf.readers, [&](RecordedTransform each) {
    noteTransform(each, seen);
    recording.add(std::move(each));
  });
  if (recording.empty()) readPoses(bags, seen, recording, contents);
  contents.times = stampedTimes(seen, bags.times());
  if (!recording.empty()) {
    const FrameTree tree = recording.finish();
    contents.frames = framesOf(tree, seen, contents.times, global_frame);
    const std::vector<std::string> notes = recording.notes();
    contents.notes.insert(contents.notes.end(), notes.begin(), notes.end());
    for (const FrameFinding& each : recording.findings()) contents.notes.push_back(each.message);
  }
  readCameras(bag_files, contents);
  readDescriptions(bag_files, contents);
  return contents;
}

std::vector<RobotFrame> robotFrames(const BagContents& contents) {
  std::map<std::string, RobotFrame> by_prefix;
  for (const char* const base : {"base_footprint", "base_link"}) {  // the latter overrides
    for (const RecordedFrame& frame : contents.frames) {
      if (lastPartOf(frame.name) != base) continue;
      const std::size_t slash = frame.name.rfind('/');
      const std::string prefix = slash == std::string::npos ? "" : frame.name.substr(0, slash);
      by_prefix[prefix] = {prefix.empty() ? "robot" : lastPartOf(prefix), prefix, frame.name};
    }
  }
  std::vector<RobotFrame> robots;
  for (auto& [prefix, robot] : by_prefix) robots.push_back(std::move(robot));
  if (!robots.empty()) return robots;
  constexpr double kMoves = 0.05;  // [m]
  for (const RecordedFrame& frame : contents.frames) {
    const bool is_first = frame.parents.front() == frame.root;
    if (is_first && !frame.is_static && frame.extent.norm() > kMoves && frame.name != "odom") {
      robots.push_back({lastPartOf(frame.name), "", frame.name});
    }
  }
  return robots;
}

std::string robotOf(const std::string& urdf) {
  const std::size_t tag = urdf.find("<robot");
  const std::size_t end = tag == std::string::npos ? tag : urdf.find('>', tag);
  if (end == std::string::npos) return "";
  static const std::regex kName(R"(\sname\s*=\s*["']([^"']*)["'])");
  std::smatch found;
  const std::string opening = urdf.substr(tag, end - tag);
  return std::regex_search(opening, found, kName) ? found[1].str() : "robot";
}

std::vector<std::string> cameraFrames(const BagContents& contents) {
  std::vector<std::string> names;
  for (const RecordedFrame& frame : contents.frames) {
    if (frame.name.find("optical") != std::string::npos) names.push_back(frame.name);
  }
  return names;
}

}  // namespace synthetic_dataset::motion
