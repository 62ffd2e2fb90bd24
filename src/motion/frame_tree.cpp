#include "motion/frame_tree.h"

#include <cstddef>
#include <numeric>
#include <utility>

namespace synthetic_dataset::motion {
namespace {

/// As in tf2 (`BufferCore::MAX_GRAPH_DEPTH`): a longer chain is taken for a loop.
constexpr std::size_t kMostLinks = 1000;

struct Climb {
  std::vector<FrameIndex> frames;  ///< from the start upwards
  Validity validity;
  bool loop = false;
};

/// Goes up from `start` to `stop`, or to where no parent is known.
Climb climb(const FrameTree& tree, FrameIndex start, FrameIndex stop, Stamp time) {
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

/// Frames in groups that grow together (union-find with path halving).
class Groups {
 public:
  explicit Groups(std::size_t frames) : next_(frames) { std::iota(next_.begin(), next_.end(), 0); }

  void join(FrameIndex a, FrameIndex b) { next(of(a)) = of(b); }

  [[nodiscard]] FrameIndex of(FrameIndex frame) {
    while (next(frame) != frame) frame = next(frame) = next(next(frame));
    return frame;
  }

 private:
  FrameIndex& next(FrameIndex frame) { return next_[static_cast<std::size_t>(frame)]; }

  std::vector<FrameIndex> next_;
};

}  // namespace

FrameIndex FrameTree::findOrAdd(const std::string& name) {
  const auto [entry, added] = indices_.try_emplace(name, static_cast<FrameIndex>(names_.size()));
  if (added) {
    names_.push_back(name);
    links_.emplace_back();
  }
  return entry->second;
}

std::optional<FrameIndex> FrameTree::find(const std::string& name) const {
  const auto entry = indices_.find(name);
  if (entry == indices_.end()) return std::nullopt;
  return entry->second;
}

const std::string& FrameTree::name(FrameIndex frame) const {
  return names_.at(static_cast<std::size_t>(frame));
}

void FrameTree::setLink(FrameIndex child, LinkHistory link) {
  links_.at(static_cast<std::size_t>(child)) = std::move(link);
}

const LinkHistory& FrameTree::link(FrameIndex child) const {
  return links_.at(static_cast<std::size_t>(child));
}

// The order of tf2's BufferCore::walkToTopParent: first up from the source, then from the target to
// where the first way ended.
Connection FrameTree::connection(FrameIndex target, FrameIndex source, Stamp time) const {
  Connection connection;
  Climb up = climb(*this, source, target, time);
  connection.validity = up.validity;
  if (up.loop) return connection;
  Climb down = climb(*this, target, up.frames.back(), time);
  connection.validity.intersect(down.validity);
  if (down.loop || down.frames.back() != up.frames.back()) return connection;

  connection.known = true;
  // What both ways share lies above their first common frame and is not crossed.
  while (!up.frames.empty() && !down.frames.empty() && up.frames.back() == down.frames.back()) {
    up.frames.pop_back();
    down.frames.pop_back();
  }
  connection.links = std::move(up.frames);
  connection.links.insert(connection.links.end(), down.frames.begin(), down.frames.end());
  return connection;
}

std::vector<Validity> FrameTree::knownTimes(FrameIndex target, FrameIndex source) const {
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

bool FrameTree::everLinked(FrameIndex a, FrameIndex b) const {
  Groups groups(names_.size());
  for (std::size_t child = 0; child < links_.size(); ++child) {
    for (const FrameIndex parent : links_[child].parents()) {
      groups.join(static_cast<FrameIndex>(child), parent);
    }
  }
  return groups.of(a) == groups.of(b);
}

}  // namespace synthetic_dataset::motion
