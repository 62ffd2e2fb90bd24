#include "run/live/live_recording.h"

#include <algorithm>
#include <cstdint>
#include <set>

#include "run/live/json_values.h"

namespace synthetic_dataset::run {
namespace {

using motion::RecordedFrame;

constexpr std::size_t kMostFrames = 2000;
constexpr std::size_t kMostWays = 100;

Value knownValue(const RecordedFrame& frame, Stamp start) {
  Value::List known;
  for (const motion::RecordedTimes& each : frame.known) {
    known.push_back(numbersValue({toSeconds(each.start - start), toSeconds(each.end - start)}));
  }
  return known;
}

Value frameValue(const RecordedFrame& frame, Stamp start, bool looks_like_robot) {
  Value::Map map = {{"name", frame.name},           {"parent", frame.parents.front()},
                    {"is_static", frame.is_static}, {"known", knownValue(frame, start)},
                    {"moved", frame.path_length},   {"turned", frame.turned},
                    {"gaps", frame.gap_count},      {"looks_like_robot", looks_like_robot}};
  if (frame.period.count() > 0) map["rate"] = 1.0 / toSeconds(frame.period);
  return map;
}

/// The frames to list, in their order.
std::vector<const RecordedFrame*> listedFrames(const std::vector<RecordedFrame>& all) {
  std::vector<const RecordedFrame*> listed;
  for (const RecordedFrame& frame : all) {
    if (all.size() <= kMostFrames || !frame.is_static) listed.push_back(&frame);
  }
  listed.resize(std::min(listed.size(), kMostFrames));
  return listed;
}

/// The paths of robots first, then the longest ones.
Value waysValue(const std::vector<const RecordedFrame*>& frames,
                const std::set<std::string>& robots) {
  std::vector<const RecordedFrame*> with_way;
  std::copy_if(frames.begin(), frames.end(), std::back_inserter(with_way),
               [](const RecordedFrame* frame) { return !frame->path_G.empty(); });
  std::stable_sort(with_way.begin(), with_way.end(), [&](const auto* a, const auto* b) {
    const bool a_first = robots.count(a->name) != 0;
    const bool b_first = robots.count(b->name) != 0;
    return a_first != b_first ? a_first : a->extent.norm() > b->extent.norm();
  });
  with_way.resize(std::min(with_way.size(), kMostWays));
  Value::Map ways;
  for (const RecordedFrame* frame : with_way) {
    Value::List points;
    for (const Eigen::Vector3d& p_G : frame->path_G) {
      points.push_back(numbersValue({p_G.x(), p_G.y()}));
    }
    ways[frame->name] = points;
  }
  return ways;
}

Value camerasValue(const motion::BagContents& contents) {
  Value::List cameras;
  for (const motion::RecordedCamera& camera : contents.cameras) {
    cameras.emplace_back(Value::Map{{"topic", camera.topic},
                                    {"frame", camera.frame},
                                    {"width", camera.width},
                                    {"height", camera.height}});
  }
  return cameras;
}

Value topicsValue(const motion::BagContents& contents) {
  Value::List topics;
  for (const motion::BagTopic& topic : contents.topics) {
    topics.emplace_back(Value::Map{{"name", topic.name}, {"type", topic.type}});
  }
  return topics;
}

}  // namespace

Value::Map recordingValue(const LiveRecording& recording) {
  const motion::BagContents& contents = recording.contents;
  std::set<std::string> robot_frames;
  Value::List robots;
  for (const motion::RobotFrame& robot : motion::robotFrames(contents)) {
    robot_frames.insert(robot.frame);
    robots.emplace_back(Value::Map{{"name", robot.name}, {"frame", robot.frame}});
  }
  const std::vector<const RecordedFrame*> listed = listedFrames(contents.frames);
  Value::List frames;
  for (const RecordedFrame* frame : listed) {
    frames.push_back(
        frameValue(*frame, contents.times.start, robot_frames.count(frame->name) != 0));
  }
  return {{"bags", namesValue(recording.bags)},
          {"start", toSeconds(contents.times.start)},
          {"duration", toSeconds(contents.times.end - contents.times.start)},
          {"frames", frames},
          {"frames_left_out", static_cast<std::int64_t>(contents.frames.size() - listed.size())},
          {"ways", waysValue(listed, robot_frames)},
          {"robots", robots},
          {"cameras", camerasValue(contents)},
          {"camera_frames", namesValue(motion::cameraFrames(contents))},
          {"topics", topicsValue(contents)},
          {"notes", namesValue(contents.notes)}};
}

}  // namespace synthetic_dataset::run
