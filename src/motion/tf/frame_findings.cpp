#include "motion/tf/frame_findings.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Core>

#include "base/name_list.h"
#include "motion/bag/ros_time.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::motion {
namespace {

using Sample = LinkHistory::Sample;
using Samples = std::vector<Sample>;

/// A jump and its return: longer than noise, and back to nearly where it began, within a few
/// samples.
constexpr double kLeastJump = 0.005;  // [m]
constexpr double kNearlyBack = 0.1;   // fraction of the jump
constexpr std::size_t kMostBetween = 4;
/// At least this many jumps, and at least this fraction of all samples, are not accidental.
constexpr std::int64_t kLeastJumps = 3;
constexpr std::int64_t kLeastShare = 5;  // one in five

Eigen::Vector3d positionIn(const Sample& sample) {
  const auto& t = sample.X_PC.translation;
  return {t.x, t.y, t.z};
}

double distance(const Sample& a, const Sample& b) { return (positionIn(a) - positionIn(b)).norm(); }

struct Jumps {
  std::int64_t count = 0;
  Stamp first{0};
  double length = 0.0;  ///< of the first jump [m]
};

bool comesBack(const Samples& samples, std::size_t from, double jump) {
  const std::size_t end = std::min(samples.size(), from + 2 + kMostBetween);
  for (std::size_t i = from + 2; i < end; ++i) {
    const bool same_parent = samples[i].parent == samples[from].parent;
    if (same_parent && distance(samples[from], samples[i]) < kNearlyBack * jump) return true;
  }
  return false;
}

/// Whether a step continues the previous one, as for something that swings.
bool goesOn(const Samples& samples, std::size_t from) {
  constexpr double kLeast = 0.5;  // fraction of the step
  if (from == 0 || samples[from - 1].parent != samples[from].parent) return false;
  const Eigen::Vector3d here = positionIn(samples[from]);
  const Eigen::Vector3d before = here - positionIn(samples[from - 1]);
  const Eigen::Vector3d step = positionIn(samples[from + 1]) - here;
  return before.dot(step) >= kLeast * step.squaredNorm();
}

Jumps jumpsToAndFro(const Samples& samples) {
  Jumps jumps;
  for (std::size_t i = 0; i + 2 < samples.size(); ++i) {
    if (samples[i].parent != samples[i + 1].parent) continue;
    const double jump = distance(samples[i], samples[i + 1]);
    if (jump < kLeastJump || goesOn(samples, i) || !comesBack(samples, i, jump)) continue;
    if (jumps.count++ == 0) jumps = {1, samples[i + 1].stamp, jump};
  }
  return jumps;
}

std::vector<std::size_t> parentChanges(const Samples& samples) {
  std::vector<std::size_t> changes;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    if (samples[i].parent != samples[i - 1].parent) changes.push_back(i);
  }
  return changes;
}

bool areMany(std::int64_t count, const Samples& samples) {
  return count >= kLeastJumps && kLeastShare * count >= static_cast<std::int64_t>(samples.size());
}

std::string quoted(const FrameNames& names, FrameId frame) { return "'" + names.of(frame) + "'"; }

}  // namespace

bool isSameTransform(const geometry_msgs::Transform& a, const geometry_msgs::Transform& b) {
  constexpr double kSame = 1e-6;  // [m], [1]
  const auto& p = a.rotation;
  const auto& q = b.rotation;
  // A quaternion and its negative are the same rotation.
  const double sign = p.x * q.x + p.y * q.y + p.z * q.z + p.w * q.w < 0.0 ? -1.0 : 1.0;
  const auto isNear = [](double x, double y) { return std::abs(x - y) <= kSame; };
  return isNear(a.translation.x, b.translation.x) && isNear(a.translation.y, b.translation.y) &&
         isNear(a.translation.z, b.translation.z) && isNear(p.x, sign * q.x) &&
         isNear(p.y, sign * q.y) && isNear(p.z, sign * q.z) && isNear(p.w, sign * q.w);
}

std::optional<FrameFinding> findFight(const FrameNames& names, FrameId child,
                                      const Samples& samples,
                                      const std::vector<std::string>& publishers) {
  std::string what;
  const Jumps jumps = jumpsToAndFro(samples);
  const auto changes = parentChanges(samples);
  if (areMany(static_cast<std::int64_t>(changes.size()), samples)) {
    const std::size_t first = changes.front();
    what = "changes between the parents " + quoted(names, samples[first - 1].parent) + " and " +
           quoted(names, samples[first].parent) + " " + std::to_string(changes.size()) +
           " times, first at " + secondsText(samples[first].stamp);
  } else if (areMany(jumps.count, samples)) {
    what = "jumps to and fro in " + quoted(names, samples.front().parent) + " " +
           std::to_string(jumps.count) + " times, first at " + secondsText(jumps.first) + " by " +
           fixed(jumps.length, 3) + " m";
  }
  if (what.empty()) return std::nullopt;
  const std::string who =
      publishers.size() > 1 ? "; its publishers are " + base::listed(publishers) : std::string();
  return FrameFinding{child, "two publishers seem to fight over the frame " + quoted(names, child) +
                                 ": it " + what + who + "; its poses are just as unsteady"};
}

std::optional<FrameFinding> findParentChange(const FrameNames& names, FrameId child,
                                             const Samples& samples) {
  constexpr std::size_t kMost = 3;
  const auto changes = parentChanges(samples);
  if (changes.empty() || areMany(static_cast<std::int64_t>(changes.size()), samples)) {
    return std::nullopt;
  }
  std::string list;
  for (std::size_t i = 0; i < std::min(changes.size(), kMost); ++i) {
    const Sample& after = samples[changes[i]];
    list += (i == 0 ? " to " : ", to ") + quoted(names, after.parent) + " at " +
            secondsText(after.stamp);
  }
  if (changes.size() > kMost) {
    list += ", and " + std::to_string(changes.size() - kMost) + " more times";
  }
  return FrameFinding{child, "the frame " + quoted(names, child) + " changes its parent from " +
                                 quoted(names, samples.front().parent) + list};
}

std::optional<FrameFinding> findStaticChange(const FrameNames& names, FrameId child,
                                             const Samples& samples, bool is_moved) {
  constexpr std::size_t kMost = 3;
  if (samples.size() < 2) return std::nullopt;
  std::string list;
  for (std::size_t i = 1; i < std::min(samples.size(), kMost + 1); ++i) {
    list += (i == 1 ? "" : ", ") + secondsText(samples[i].stamp);
  }
  if (samples.size() > kMost + 1) {
    list += ", and " + std::to_string(samples.size() - kMost - 1) + " more times";
  }
  return FrameFinding{child,
                      "the static transform " + quoted(names, samples.front().parent) + " -> " +
                          quoted(names, child) + " changes at " + list +
                          "; each value holds from its time on, the first one also before it" +
                          (is_moved ? " (/tf has this frame, too: two publishers?)" : "")};
}

}  // namespace synthetic_dataset::motion
