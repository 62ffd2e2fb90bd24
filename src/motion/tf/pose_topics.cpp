#include "motion/tf/pose_topics.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "base/name_list.h"
#include "motion/bag/checked_messages.h"
#include "motion/frame_names.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/nearest_name.h"

namespace synthetic_dataset::motion {
namespace {

using Transforms = std::vector<geometry_msgs::TransformStamped>;

std::string plain(const std::string& topic) { return withoutLeadingSlashes(topic); }

std::string described(const BagTopic& topic) { return topic.name + " (" + topic.type + ")"; }

/// A list of names; of many, only the first ones.
std::string someOf(const std::set<std::string>& names) {
  constexpr std::size_t kMost = 12;
  return base::listed({names.begin(), names.end()}, kMost);
}

const PoseMessage* messageOf(const BagTopic& topic) {
  for (const PoseMessage& message : poseMessages()) {
    if (message.md5sum == topic.md5sum) return &message;
  }
  return nullptr;
}

bool isJointState(const BagTopic& topic) {
  return topic.md5sum == ros::message_traits::MD5Sum<RecordedJoints>::value();
}

std::string readableTypes() {
  std::vector<std::string> types{"sensor_msgs/JointState"};
  for (const PoseMessage& message : poseMessages()) types.push_back(message.type);
  return base::listed(types);
}

/// Inserts joint states between the recorded ones if a joint turns so far between them that
/// interpolation along the shorter way would be wrong.
class DenseJoints {
 public:
  /// @param unwrapped  joints whose angles keep counting beyond a turn; other joints' angles wrap
  ///     around, and mean the shorter way
  explicit DenseJoints(std::set<std::string> unwrapped) : unwrapped_(std::move(unwrapped)) {}

  /// The states after the previous message, up to and including this one.
  std::vector<sensor_msgs::JointState> upTo(const sensor_msgs::JointState& message) {
    constexpr double kFar = 0.9 * 3.141592653589793;  // [rad]; half a turn is ambiguous to slerp
    constexpr double kStep = 1.0;                     // [rad]
    constexpr double kMost = 1000.0;                  // states; enough even for a propeller
    double farthest = 0.0;
    std::vector<double> from(message.position.begin(), message.position.end());
    const std::size_t count = std::min(message.name.size(), message.position.size());
    for (std::size_t i = 0; i < count; ++i) {
      const auto [last, is_first] = last_.emplace(message.name[i], message.position[i]);
      if (is_first || unwrapped_.count(message.name[i]) == 0) continue;
      from[i] = last->second;
      farthest = std::max(farthest, std::abs(message.position[i] - from[i]));
    }
    std::vector<sensor_msgs::JointState> states;
    const double steps = farthest > kFar ? std::min(std::ceil(farthest / kStep), kMost) : 1.0;
    for (double step = 1.0; step < steps && message.header.stamp > stamp_; ++step) {
      sensor_msgs::JointState state = message;
      const double share = step / steps;
      state.header.stamp = stamp_ + (message.header.stamp - stamp_) * share;
      for (std::size_t i = 0; i < count; ++i) {
        state.position[i] = from[i] + share * (message.position[i] - from[i]);
        if (unwrapped_.count(message.name[i]) == 0) state.name[i].clear();  // is not interpolated
      }
      states.push_back(std::move(state));
    }
    for (std::size_t i = 0; i < count; ++i) last_[message.name[i]] = message.position[i];
    stamp_ = message.header.stamp;
    states.push_back(message);
    return states;
  }

 private:
  std::set<std::string> unwrapped_;
  std::map<std::string, double> last_;
  ros::Time stamp_;
};

}  // namespace

PoseTopics::PoseTopics(BagReader& bags, TransformRecording& recording)
    : bags_(bags), recording_(recording) {}

bool PoseTopics::hasJointStates() const {
  const std::vector<BagTopic> topics = bags_.topics();
  return std::any_of(topics.begin(), topics.end(), isJointState);
}

void PoseTopics::readNamed(const std::vector<PoseTopic>& named,
                           const std::vector<JointedRobot>& robots) {
  std::vector<std::string> errors;
  for (const PoseTopic& each : named) {
    try {
      nameTopic(each, robots);
    } catch (const ErrorList&) {
      throw;  // about the bags
    } catch (const Error& error) {
      errors.push_back(std::string("pose_topics: ") + error.what());
    }
  }
  if (!errors.empty()) throw ErrorList(errors);
}

void PoseTopics::nameTopic(const PoseTopic& named, const std::vector<JointedRobot>& robots) {
  std::vector<std::string> readable;
  for (const BagTopic& topic : bags_.topics()) {
    const PoseMessage* message = messageOf(topic);
    const bool is_joints = isJointState(topic);
    if (message != nullptr || is_joints) readable.push_back(topic.name);
    if (plain(topic.name) != plain(named.topic)) continue;
    if (is_joints) {
      std::vector<JointedRobot> chosen;
      std::copy_if(robots.begin(), robots.end(), std::back_inserter(chosen),
                   [&](const JointedRobot& robot) {
                     return !named.object || robot.object == *named.object;
                   });
      if (chosen.empty()) {
        throw Error("found '" + named.topic + "', joint states, and no " +
                    (named.object ? "object '" + *named.object + "' whose" : "object whose") +
                    " model has joints that move; they move the links of an object with a URDF");
      }
      readJoints(topic.name, chosen);
      return;
    }
    if (!topic.problem.empty()) {
      throw Error("found '" + named.topic + "' (" + topic.type +
                  "), which cannot be read: " + topic.problem);
    }
    if (message == nullptr) {
      throw Error("found '" + named.topic + "', whose messages are " + topic.type +
                  "; they should be one of " + readableTypes());
    }
    if (!message->names_frames && !named.frame) {
      throw Error("found '" + named.topic + "', whose messages (" + topic.type +
                  ") do not name the frame that they move; {topic: " + named.topic +
                  ", frame: NAME} does");
    }
    if (message->names_frames && !message->moves_one_frame && named.frame) {
      throw Error("found the frame '" + *named.frame + "' of '" + named.topic +
                  "', whose messages (" + topic.type + ") name the many frames that they move");
    }
    read({topic, message}, named.frame.value_or(""));
    return;
  }
  throw Error("found '" + named.topic +
              "', a topic that the recording does not have; of those "
              "that can be read it has " +
              (readable.empty() ? "none" : base::listed(readable)) +
              didYouMean(named.topic, readable));
}

std::vector<PoseTopics::Source> PoseTopics::unreadSources() const {
  std::vector<Source> sources;
  for (const BagTopic& topic : bags_.topics()) {
    const PoseMessage* message = messageOf(topic);
    if (message != nullptr && read_.count(topic.name) == 0) sources.push_back({topic, message});
  }
  return sources;
}

void PoseTopics::read(const Source& source, const std::string& frame) {
  read_.insert(source.topic.name);
  const TopicReaders readers{
      {source.topic.name, {TransformKind::kMoving, [&](const BagMessage& message) {
                             return source.message->read(message, frame);
                           }}}};
  bags_.read(readers, [&](RecordedTransform each) { recording_.add(std::move(each)); });
}

/// The frames that a topic's messages connect.
PoseTopics::GivenFrames PoseTopics::framesOf(const Source& source) {
  GivenFrames frames;
  const auto look = [&](const BagMessage& message) {
    for (const auto& each : source.message->read(message, "")) {
      const std::string moved = withoutLeadingSlashes(each.child_frame_id);
      frames.moved.insert(moved);
      frames.all.insert({moved, withoutLeadingSlashes(each.header.frame_id)});
    }
    return Transforms{};
  };
  const TopicReaders readers{{source.topic.name, {TransformKind::kMoving, look}}};
  bags_.read(readers, [](const RecordedTransform& /*none*/) {});
  return frames;
}

void PoseTopics::readLacking(const std::string& global_frame,
                             const std::vector<std::string>& frames) {
  const std::set<std::string> known = recording_.connectedWith(global_frame);
  std::map<std::string, std::set<std::string>> lacking;  // the frames with which each is connected
  for (const std::string& frame : frames) {
    if (known.count(withoutLeadingSlashes(frame)) != 0) continue;
    lacking[frame] = recording_.connectedWith(frame);
  }
  if (lacking.empty()) return;
  if (!recording_.moves(global_frame) && known.size() == 1) lacking[global_frame] = known;
  const bool has_tf = !recording_.empty();
  std::map<std::string, std::vector<Source>> sources_of;
  std::map<std::string, std::set<std::string>> given_by;  ///< by topic
  for (const Source& source : unreadSources()) {
    if (!source.message->names_frames) continue;
    const GivenFrames given = framesOf(source);
    const auto isKnown = [&](const std::string& frame) { return recording_.moves(frame); };
    if (std::any_of(given.moved.begin(), given.moved.end(), isKnown)) continue;
    for (const auto& [frame, connected] : lacking) {
      const auto isGiven = [&](const std::string& each) { return given.all.count(each) != 0; };
      if (std::any_of(connected.begin(), connected.end(), isGiven)) {
        sources_of[frame].push_back(source);
      }
    }
    given_by[described(source.topic)] = given.all;
  }
  for (const auto& [frame, sources] : sources_of) choose(frame, sources, global_frame);
  for (const auto& [topic, all] : given_by) {
    if (read_.count(topic.substr(0, topic.find(' '))) != 0) continue;
    hints_.push_back("the topic " + topic + " gives the frames " + someOf(all));
  }
  lacking.erase(global_frame);
  if (!has_tf && sources_of.empty() && lacking.size() == 1) readOnlyPose(lacking.begin()->first);
}

/// Reads the topic that gives a frame, if it is the only one.
void PoseTopics::choose(const std::string& frame, const std::vector<Source>& sources,
                        const std::string& global_frame) {
  if (sources.size() == 1) {
    const BagTopic& topic = sources.front().topic;
    if (read_.count(topic.name) == 0) read(sources.front(), "");
    if (frame == global_frame) return;
    notes_.push_back("TF does not connect the frame '" + frame + "' with '" + global_frame +
                     "': its poses come from the topic " + described(topic));
    return;
  }
  std::vector<std::string> topics;
  for (const Source& source : sources) topics.push_back(source.topic.name);
  hints_.push_back("several topics give the frame '" + frame + "': " + base::listed(topics) +
                   "; pose_topics should name one, as in pose_topics: [" + topics.front() + "]");
}

/// If the recording only has the poses of a single thing, the topic need not be named in the
/// settings.
void PoseTopics::readOnlyPose(const std::string& frame) {
  std::vector<Source> sources;
  for (const Source& source : unreadSources()) {
    if (source.message->names_frames || !source.message->moves_one_frame) continue;
    sources.push_back(source);
    hints_.push_back("the messages of " + described(source.topic) +
                     " do not name the frame that they move; pose_topics: [{topic: " +
                     source.topic.name + ", frame: " + frame + "}] does");
  }
  if (sources.size() != 1) return;
  read(sources.front(), frame);
  notes_.push_back("the recording has no TF: the poses of the frame '" + frame +
                   "' come from the topic " + described(sources.front().topic) +
                   ", the only one that has any");
}

std::set<std::string> PoseTopics::jointsOf(const std::string& topic) {
  const auto known = joints_.find(topic);
  if (known != joints_.end()) return known->second;
  std::set<std::string>& names = joints_[topic];
  constexpr double kTurn = 2.0 * 3.141592653589793;  // [rad]
  const auto look = [&](const BagMessage& message) {
    const auto joints = message.instantiate<RecordedJoints>();
    const auto& all = joints->message.name;
    const std::vector<double>& positions = joints->message.position;
    if (!positions.empty()) names.insert(all.begin(), all.end());
    for (std::size_t i = 0; i < std::min(all.size(), positions.size()); ++i) {
      if (std::abs(positions[i]) > 1.01 * kTurn) unwrapped_[topic].insert(all[i]);
    }
    return Transforms{};
  };
  bags_.read({{topic, {TransformKind::kMoving, look}}}, [](const RecordedTransform& /*none*/) {});
  return names;
}

void PoseTopics::readJoints(const std::string& topic, const std::vector<JointedRobot>& robots) {
  read_.insert(topic);
  const std::set<std::string> positions = jointsOf(topic);
  std::vector<JointFrames> moved;
  for (const JointedRobot& robot : robots) moved.emplace_back(robot, positions);
  std::set<std::string> known;  // TF already has these frames
  for (const JointFrames& each : moved) {
    for (const std::string& frame : each.frames()) {
      if (recording_.moves(frame)) known.insert(frame);
    }
  }
  DenseJoints dense(unwrapped_[topic]);
  const auto read = [&](const BagMessage& message) {
    const auto joints = message.instantiate<RecordedJoints>();
    Transforms all;
    for (const sensor_msgs::JointState& state : dense.upTo(joints->message)) {
      for (const JointFrames& each : moved) {
        for (const auto& transform : each.transforms(state)) {
          if (known.count(transform.child_frame_id) == 0) all.push_back(transform);
        }
      }
    }
    return all;
  };
  bags_.read({{topic, {TransformKind::kMoving, read}}},
             [&](RecordedTransform each) { recording_.add(std::move(each)); });
}

void PoseTopics::readJoints(const std::vector<JointedRobot>& robots) {
  for (const JointedRobot& robot : robots) {
    std::vector<std::string> topics;
    for (const BagTopic& topic : bags_.topics()) {
      if (!isJointState(topic)) continue;
      const std::vector<std::string> frames = JointFrames(robot, jointsOf(topic.name)).frames();
      const bool has_tf = std::any_of(frames.begin(), frames.end(), [&](const std::string& frame) {
        return recording_.moves(frame);
      });
      if (!frames.empty() && !has_tf) topics.push_back(topic.name);
    }
    if (topics.size() > 1) {
      notes_.push_back("several topics have joints of '" + robot.object + "': " +
                       base::listed(topics) + "; none is taken, pose_topics should name one");
    }
    if (topics.size() != 1) continue;
    readJoints(topics.front(), {robot});
    notes_.push_back("the joints of '" + robot.object + "' follow the topic " + topics.front() +
                     " (sensor_msgs/JointState), as TF has none of their links' frames");
  }
}

}  // namespace synthetic_dataset::motion
