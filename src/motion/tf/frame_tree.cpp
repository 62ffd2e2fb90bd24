#include "motion/tf/frame_tree.h"

#include <cstddef>
#include <numeric>
#include <utility>

#include <tf2/LinearMath/Quaternion.h>
#include <tf2/LinearMath/Vector3.h>

namespace synthetic_dataset::motion {
namespace {

/// As in tf2 (`BufferCore::MAX_GRAPH_DEPTH`): a longer chain counts as a loop.
constexpr std::size_t kMostLinks = 1000;

struct Climb {
  std::vector<FrameId> frames;  ///< from the start upwards
  Validity validity;
  bool loop = false;
};

/// Goes up from `start` to `stop`, or to where no parent is known.
Climb climb(const FrameTree& tree, FrameId start, FrameId stop, Stamp time) {
  Climb way{{start}, {}, false};
  while (way.frames.back() != stop && !way.loop) {
    const LinkHistory::Parent parent = tree.link(way.frames.back()).parentAt(time);
    way.validity.intersect(parent.validity);
    if (parent.frame == kNoFrame) break;
    way.frames.push_back(parent.frame);
    way.loop = way.frames.size() > kMostLinks + 1;
  }
  return way;
}

/// The product of links from a frame upwards, in tf2's own arithmetic and order.
struct Chain {
  tf2::Vector3 position{0, 0, 0};
  tf2::Quaternion rotation{0, 0, 0, 1};

  void climb(const geometry_msgs::Transform& X_PC) {
    const auto& t = X_PC.translation;
    const auto& q = X_PC.rotation;
    const tf2::Quaternion link(q.x, q.y, q.z, q.w);
    position = tf2::quatRotate(link, position) + tf2::Vector3(t.x, t.y, t.z);
    rotation = link * rotation;
  }

  [[nodiscard]] Chain inverse() const {
    const tf2::Quaternion back = rotation.inverse();
    return {tf2::quatRotate(back, -position), back};
  }

  [[nodiscard]] Chain behind(const Chain& first) const {
    return {tf2::quatRotate(first.rotation, position) + first.position, first.rotation * rotation};
  }

  [[nodiscard]] Pose pose() const {
    return makePose({position.x(), position.y(), position.z()},
                    Eigen::Quaterniond(rotation.w(), rotation.x(), rotation.y(), rotation.z()));
  }
};

/// Connected groups of frames (union-find with path halving).
class Groups {
 public:
  explicit Groups(std::size_t frames) : next_(frames) { std::iota(next_.begin(), next_.end(), 0); }

  void join(std::size_t a, std::size_t b) { next_[of(a)] = of(b); }

  [[nodiscard]] std::size_t of(std::size_t frame) {
    while (next_[frame] != frame) frame = next_[frame] = next_[next_[frame]];
    return frame;
  }

 private:
  std::vector<std::size_t> next_;
};

}  // namespace

FrameId FrameTree::findOrAdd(const std::string& name) {
  const FrameId frame = names_.findOrAdd(name);
  links_.resize(names_.all().size());
  return frame;
}

void FrameTree::setLink(FrameId child, LinkHistory link) {
  links_.at(static_cast<std::size_t>(child)) = std::move(link);
}

const LinkHistory& FrameTree::link(FrameId child) const {
  return links_.at(static_cast<std::size_t>(child));
}

// The order of tf2's BufferCore::walkToTopParent: first up from the source, then from the target to
// where the first path ended. All links up to there are used, not only those below the first common
// frame: that changes the last bits.
std::optional<Pose> FrameTree::transform(FrameId target, FrameId source, Stamp time) const {
  if (source == target) return Pose::Identity();
  Chain up;
  FrameId top = source;
  for (std::size_t links = 0;; ++links) {
    const FrameId parent = parentOf(top, time);
    if (parent == kNoFrame) break;
    if (top == target) return up.pose();
    if (links == kMostLinks) return std::nullopt;
    up.climb(link(top).transformAt(time));
    top = parent;
  }
  Chain down;
  FrameId frame = target;
  for (std::size_t links = 0; frame != top; ++links) {
    const FrameId parent = parentOf(frame, time);
    if (parent == kNoFrame || links == kMostLinks) return std::nullopt;
    if (frame == source) return down.inverse().pose();
    down.climb(link(frame).transformAt(time));
    frame = parent;
  }
  return up.behind(down.inverse()).pose();
}

Connection FrameTree::connection(FrameId target, FrameId source, Stamp time) const {
  Connection connection;
  Climb up = climb(*this, source, target, time);
  connection.validity = up.validity;
  if (up.loop) return connection;
  Climb down = climb(*this, target, up.frames.back(), time);
  connection.validity.intersect(down.validity);
  if (down.loop || down.frames.back() != up.frames.back()) return connection;

  connection.known = true;
  // The shared part of both paths lies above their first common frame and is not crossed.
  while (!up.frames.empty() && !down.frames.empty() && up.frames.back() == down.frames.back()) {
    up.frames.pop_back();
    down.frames.pop_back();
  }
  connection.links = std::move(up.frames);
  connection.links.insert(connection.links.end(), down.frames.begin(), down.frames.end());
  return connection;
}

std::vector<Validity> FrameTree::knownTimes(FrameId target, FrameId source) const {
  std::vector<Validity> times;
  bool adjacent = false;
  for (Stamp time = Stamp::min();;) {
    const Connection answer = connection(target, source, time);
    if (answer.known && adjacent) {
      times.back().until = answer.validity.until;
    } else if (answer.known) {
      times.push_back(answer.validity);
    }
    adjacent = answer.known;
    if (answer.validity.until == Stamp::max()) return times;
    time = answer.validity.until + Duration{1};
  }
}

bool FrameTree::everLinked(FrameId a, FrameId b) const {
  Groups groups(links_.size());
  for (std::size_t child = 0; child < links_.size(); ++child) {
    for (const FrameId parent : links_[child].parents()) {
      groups.join(child, static_cast<std::size_t>(parent));
    }
  }
  return groups.of(static_cast<std::size_t>(a)) == groups.of(static_cast<std::size_t>(b));
}

}  // namespace synthetic_dataset::motion
