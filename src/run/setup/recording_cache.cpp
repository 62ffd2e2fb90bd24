#include "run/setup/recording_cache.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <utility>

#include "base/json_text.h"
#include "motion/bag/ros2_bag.h"
#include "motion/bag_motion.h"
#include "run/setup/file_stamps.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::run {
namespace {

using motion::JointedLink;
using motion::JointedRobot;

constexpr std::size_t kMostKept = 3;

/// Everything that determines what is read, except the files and the robots.
std::string textOf(const motion::BagMotionOptions& options) {
  const auto list = [](const std::vector<std::string>& texts) {
    return Value(Value::List(texts.begin(), texts.end()));
  };
  const auto orNothing = [](const std::optional<std::string>& text) {
    return text ? Value(*text) : Value();
  };
  Value::List topics;
  for (const motion::PoseTopic& each : options.pose_topics) {
    topics.emplace_back(Value::List{each.topic, orNothing(each.frame), orNothing(each.object)});
  }
  return base::jsonText(
      Value::List{list(options.bag_files), options.global_frame,
                  options.stretch ? Value(static_cast<std::int64_t>(*options.stretch)) : Value(),
                  list(options.tf_topics), topics, list(options.frames)});
}

bool areSame(const JointedLink& a, const JointedLink& b) {
  const bool same_mimic = a.mimic.has_value() == b.mimic.has_value() &&
                          (!a.mimic || (a.mimic->joint == b.mimic->joint &&
                                        a.mimic->multiplier == b.mimic->multiplier &&
                                        a.mimic->offset == b.mimic->offset));
  return same_mimic && a.frame == b.frame && a.parent == b.parent && a.joint == b.joint &&
         a.slides == b.slides && a.axis_L == b.axis_L && a.rest == b.rest &&
         a.X_PL.matrix() == b.X_PL.matrix();
}

bool areSame(const JointedRobot& a, const JointedRobot& b) {
  return a.object == b.object && a.frame == b.frame && a.own_link == b.own_link &&
         std::equal(a.links.begin(), a.links.end(), b.links.begin(), b.links.end(),
                    [](const JointedLink& x, const JointedLink& y) { return areSame(x, y); });
}

bool areSame(const std::vector<JointedRobot>& a, const std::vector<JointedRobot>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](const JointedRobot& x, const JointedRobot& y) { return areSame(x, y); });
}

}  // namespace

struct RecordingCache::Kept {
  std::string wanted;  ///< what was requested
  FileStamps files;
  std::optional<std::vector<JointedRobot>> robots;  ///< if requested
  std::shared_ptr<const motion::FrameSource> recording;
};

RecordingCache::RecordingCache() = default;
RecordingCache::~RecordingCache() = default;

bool RecordingCache::isOf(const Kept& kept, const std::string& wanted,
                          const motion::BagMotionOptions& options) {
  return kept.wanted == wanted && kept.files.areCurrent() &&
         (!kept.robots || areSame(*kept.robots, options.robots()));
}

std::shared_ptr<const motion::FrameSource> RecordingCache::get(
    const motion::BagMotionOptions& options) {
  const std::string wanted = textOf(options);
  const auto found = std::find_if(kept_.begin(), kept_.end(),
                                  [&](const Kept& kept) { return isOf(kept, wanted, options); });
  if (found != kept_.end()) {
    std::rotate(found, found + 1, kept_.end());
    return kept_.back().recording;
  }
  Kept kept{wanted, {}, {}, {}};
  motion::BagMotionOptions watched = options;
  if (options.robots) {
    watched.robots = [&] {
      kept.robots = options.robots();
      return *kept.robots;
    };
  }
  kept.recording = std::make_shared<motion::BagMotion>(watched);
  for (const std::string& bag : options.bag_files) {
    for (const std::string& file : motion::filesOfBag(bag)) kept.files.add(file);
  }
  if (kept_.size() >= kMostKept) kept_.erase(kept_.begin());
  kept_.push_back(std::move(kept));
  return kept_.back().recording;
}

}  // namespace synthetic_dataset::run
