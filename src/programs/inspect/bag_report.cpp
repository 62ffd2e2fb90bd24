#include "programs/inspect/bag_report.h"

#include <functional>
#include <set>
#include <sstream>

#include "base/name_list.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::programs {
namespace {

using motion::BagContents;
using motion::RecordedFrame;

std::string secondsOfStamp(Duration time) { return fixed(toSeconds(time), 3); }

/// "20.0 Hz, 47.600 s to 108.800 s, travels in 3.10 x 2.00 x 0.00 m, by /robot_state_publisher".
std::string frameLine(const RecordedFrame& frame) {
  std::string text = frame.is_static ? "static" : "";
  if (!frame.is_static) {
    const double rate = frame.period.count() > 0 ? 1.0 / toSeconds(frame.period) : 0.0;
    text = (rate > 0.0 ? fixed(rate, 1) + " Hz" : "once") + ", " + secondsOfStamp(frame.first) +
           " s to " + secondsOfStamp(frame.last) + " s";
  }
  if (frame.gap_count > 0) {
    text += ", " + std::to_string(frame.gap_count) + (frame.gap_count == 1 ? " gap" : " gaps") +
            " (longest " + secondsOfStamp(frame.longest_gap) + " s)";
  }
  constexpr double kStill = 0.005;  // [m]
  if (frame.extent.norm() > kStill) {
    text += ", travels in " + fixed(frame.extent.x(), 2) + " x " + fixed(frame.extent.y(), 2) +
            " x " + fixed(frame.extent.z(), 2) + " m";
  }
  if (frame.parents.size() > 1) text += ", parents " + base::listed(frame.parents);
  if (!frame.publishers.empty()) text += ", by " + base::listed(frame.publishers);
  return text;
}

/// Prints the frames below a frame, each followed by those below it.
void printTree(const BagContents& contents, const std::string& parent, const std::string& indent,
               std::set<std::string>& printed, std::ostream& out) {
  for (const RecordedFrame& frame : contents.frames) {
    if (frame.parents.front() != parent || !printed.insert(frame.name).second) continue;
    out << indent << frame.name << "  (" << frameLine(frame) << ")\n";
    printTree(contents, frame.name, indent + "  ", printed, out);
  }
}

const RecordedFrame* frameOf(const BagContents& contents, const std::string& name) {
  for (const RecordedFrame& frame : contents.frames) {
    if (frame.name == name) return &frame;
  }
  return nullptr;
}

/// "; known in 2.0 s of 10.0 s, as 'odom' is in 'map' (...)": names the link between a frame and
/// its root that is known for the shortest time, if that costs more than a tenth of the recording.
std::string knownText(const BagContents& contents, const std::string& name) {
  constexpr double kMuch = 0.9;
  const Duration whole = contents.times.end - contents.times.start;
  Duration shortest = whole;
  std::string link;
  std::set<std::string> seen;  // a recording can contain loops
  for (const RecordedFrame* frame = frameOf(contents, name);
       frame != nullptr && seen.insert(frame->name).second;
       frame = frameOf(contents, frame->parents.front())) {
    Duration known{0};
    for (const motion::RecordedTimes& each : frame->known) known += each.end - each.start;
    if (frame->is_static || known >= shortest) continue;
    shortest = known;
    link = "'" + frame->name + "' is in '" + frame->parents.front() + "'";
  }
  if (toSeconds(shortest) >= kMuch * toSeconds(whole)) return "";
  return "; known in " + fixed(toSeconds(shortest), 1) + " s of " + fixed(toSeconds(whole), 1) +
         " s, as " + link + " (`when_unknown: absent` makes scenes without it)";
}

Value namesValue(const std::vector<std::string>& names) {
  Value::List list;
  for (const std::string& name : names) list.emplace_back(name);
  return Value(list);
}

Value pointValue(const Eigen::Vector3d& point) {
  return Value(Value::List{Value(point.x()), Value(point.y()), Value(point.z())});
}

Value frameValue(const RecordedFrame& frame) {
  Value::Map map = {
      {"name", Value(frame.name)},          {"parents", namesValue(frame.parents)},
      {"root", Value(frame.root)},          {"static", Value(frame.is_static)},
      {"transforms", Value(frame.count)},   {"middle", pointValue(frame.middle_R)},
      {"extent", pointValue(frame.extent)}, {"publishers", namesValue(frame.publishers)}};
  if (frame.is_static) return Value(map);
  map["first"] = Value(toSeconds(frame.first));
  map["last"] = Value(toSeconds(frame.last));
  map["gaps"] = Value(frame.gap_count);
  map["longest_gap"] = Value(toSeconds(frame.longest_gap));
  if (frame.period.count() > 0) map["rate"] = Value(1.0 / toSeconds(frame.period));
  return Value(map);
}

std::set<std::string> rootsOf(const BagContents& contents) {
  std::set<std::string> roots;
  for (const RecordedFrame& frame : contents.frames) roots.insert(frame.root);
  return roots;
}

}  // namespace

std::string bagText(const BagContents& contents, const std::vector<ServerDescription>& on_server) {
  std::ostringstream out;
  out << "kind: bag of " << base::listed(contents.kinds) << '\n';
  if (contents.times.start > contents.times.end) {
    out << "times: none, as there is no message\n";
  } else {
    out << "times: " << secondsOfStamp(contents.times.start) << " s to "
        << secondsOfStamp(contents.times.end) << " s ("
        << fixed(toSeconds(contents.times.end - contents.times.start), 1) << " s)\n";
  }
  out << "frames:" << (contents.frames.empty() ? " none\n" : "\n");
  std::set<std::string> printed;
  for (const std::string& root : rootsOf(contents)) {
    out << "  " << root << "  (root)\n";
    printTree(contents, root, "    ", printed, out);
  }
  out << "topics:\n";
  for (const motion::BagTopic& topic : contents.topics) {
    out << "  " << topic.name << "  (" << topic.type << ")\n";
  }
  for (const motion::RecordedCamera& camera : contents.cameras) {
    out << "camera: " << camera.topic << ", " << camera.width << " x " << camera.height
        << ", in the frame '" << camera.frame << "' (camera/info_topic)\n";
  }
  for (const std::string& frame : motion::cameraFrames(contents)) {
    out << "camera frame: " << frame << " (camera_frame_id)\n";
  }
  for (const motion::RobotFrame& robot : motion::robotFrames(contents)) {
    out << "robot: " << robot.name << ", whose frame is '" << robot.frame << "'"
        << knownText(contents, robot.frame) << '\n';
  }
  for (const motion::RecordedDescription& each : contents.descriptions) {
    out << "model: " << each.topic << " is a URDF of '" << each.robot << "' (`inspect --urdf BAG > "
        << safeFileName(each.robot) << ".urdf` saves it)\n";
  }
  for (const ServerDescription& each : on_server) {
    out << "model on the parameter server: " << each.parameter << " is a URDF of '" << each.robot
        << "' (`rosparam get -p " << each.parameter << " > " << safeFileName(each.robot)
        << ".urdf` saves it)\n";
  }
  for (const std::string& each : contents.notes) out << "note: " << each << '\n';
  return out.str();
}

Value bagValue(const BagContents& contents, const std::vector<ServerDescription>& on_server) {
  Value::List frames;
  for (const RecordedFrame& frame : contents.frames) frames.push_back(frameValue(frame));
  Value::List topics;
  for (const motion::BagTopic& topic : contents.topics) {
    topics.emplace_back(Value::Map{{"name", Value(topic.name)}, {"type", Value(topic.type)}});
  }
  Value::List cameras;
  for (const motion::RecordedCamera& camera : contents.cameras) {
    cameras.emplace_back(Value::Map{{"topic", Value(camera.topic)},
                                    {"frame", Value(camera.frame)},
                                    {"width", Value(camera.width)},
                                    {"height", Value(camera.height)}});
  }
  Value::List robots;
  for (const motion::RobotFrame& robot : motion::robotFrames(contents)) {
    robots.emplace_back(Value::Map{{"name", Value(robot.name)},
                                   {"prefix", Value(robot.prefix)},
                                   {"frame", Value(robot.frame)}});
  }
  Value::List models;
  for (const motion::RecordedDescription& each : contents.descriptions) {
    models.emplace_back(Value::Map{{"topic", Value(each.topic)}, {"robot", Value(each.robot)}});
  }
  for (const ServerDescription& each : on_server) {
    models.emplace_back(
        Value::Map{{"parameter", Value(each.parameter)}, {"robot", Value(each.robot)}});
  }
  return Value(Value::Map{{"kind", Value("recording")},
                          {"bags", namesValue(contents.kinds)},
                          {"start", Value(toSeconds(contents.times.start))},
                          {"end", Value(toSeconds(contents.times.end))},
                          {"frames", Value(frames)},
                          {"topics", Value(topics)},
                          {"cameras", Value(cameras)},
                          {"camera_frames", namesValue(motion::cameraFrames(contents))},
                          {"robots", Value(robots)},
                          {"models", Value(models)},
                          {"notes", namesValue(contents.notes)}});
}

}  // namespace synthetic_dataset::programs
