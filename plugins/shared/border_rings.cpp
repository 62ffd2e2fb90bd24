#include "plugins/shared/border_rings.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <opencv2/imgproc.hpp>

namespace synthetic_dataset::masks {
namespace {

// Directions of steps, clockwise on the screen.
constexpr std::size_t kEast = 0;
constexpr std::size_t kWest = 2;
constexpr std::size_t kNorth = 3;
const std::array<cv::Point, 4> kSteps = {cv::Point(1, 0), cv::Point(0, 1), cv::Point(-1, 0),
                                         cv::Point(0, -1)};

// The pixels on both sides of a step, relative to the corner at which it begins.
const std::array<cv::Point, 4> kRight = {cv::Point(0, 0), cv::Point(-1, 0), cv::Point(-1, -1),
                                         cv::Point(0, -1)};
const std::array<cv::Point, 4> kLeft = {cv::Point(0, -1), cv::Point(0, 0), cv::Point(-1, 0),
                                        cv::Point(-1, -1)};

constexpr int kNone = -1;

bool goes(const BorderStep& step, std::size_t direction) {
  return step.pixel == step.corner + kRight[direction];
}

/// Judged by the sign of the area (shoelace formula): rings around parts are clockwise.
bool isHole(const BorderRing& ring) {
  std::int64_t twice_the_area = 0;
  cv::Point last = ring.back().corner;
  for (const BorderStep& step : ring) {
    twice_the_area += std::int64_t{last.x} * step.corner.y - std::int64_t{step.corner.x} * last.y;
    last = step.corner;
  }
  return twice_the_area < 0;
}

/// Makes the ring of a hole begin at the left end of its ceiling's first pixel (topmost, leftmost).
/// That corner comes first as a step of its own, at the pixel above the hole.
BorderRing fromCeiling(BorderRing ring) {
  const auto ceiling =
      std::min_element(ring.begin(), ring.end(), [](const BorderStep& a, const BorderStep& b) {
        if (goes(a, kWest) != goes(b, kWest)) return goes(a, kWest);
        return a.corner.y != b.corner.y ? a.corner.y < b.corner.y : a.corner.x < b.corner.x;
      });
  const BorderStep left_end{ceiling->corner + kSteps[kWest], ceiling->pixel};
  std::rotate(ring.begin(), ceiling + 1, ring.end());
  ring.insert(ring.begin(), left_end);
  return ring;
}

/// Follows the edges between the mask's pixels and others, with the mask on the right: clockwise
/// around parts, counter-clockwise around holes.
class BorderTracer {
 public:
  /// @param mask  with a margin of one pixel that is 0
  explicit BorderTracer(const cv::Mat1b& mask)
      : mask_(mask), top_edge_ring_(mask.size(), kNone), top_edge_place_(mask.size(), kNone) {
    for (int y = 1; y < mask_.rows; ++y) {
      for (int x = 1; x < mask_.cols; ++x) {
        // Every ring runs along the top of some pixel.
        const cv::Point pixel(x, y);
        if (isTop(pixel) && top_edge_ring_(pixel) == kNone) addRing(pixel);
      }
    }
  }

  [[nodiscard]] std::vector<BorderRing> parts() const {
    Branches seams;
    for (const std::size_t hole : holes_) {
      // Goes straight up from the hole to the border above, which belongs to the part or to a hole
      // that begins higher, so seams form no cycle.
      cv::Point top = rings_[hole].front().pixel;
      while (!isTop(top)) top += kSteps[kNorth];
      seams[{static_cast<std::size_t>(top_edge_ring_(top)),
             static_cast<std::size_t>(top_edge_place_(top))}]
          .push_back({hole, 0});
    }
    std::vector<BorderRing> parts;
    for (const std::size_t part : parts_) parts.push_back(walk(rings_, seams, {part, 0}));
    return parts;
  }

 private:
  [[nodiscard]] bool isTop(const cv::Point& pixel) const {
    return mask_(pixel) != 0 && mask_(pixel + kSteps[kNorth]) == 0;
  }

  void addRing(const cv::Point& first) {
    BorderRing ring = trace(first);
    const bool is_hole = isHole(ring);
    if (is_hole) ring = fromCeiling(std::move(ring));
    (is_hole ? holes_ : parts_).push_back(rings_.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
      if (!goes(ring[i], kEast)) continue;
      top_edge_ring_(ring[i].pixel) = static_cast<int>(rings_.size());
      top_edge_place_(ring[i].pixel) = static_cast<int>(i);
    }
    rings_.push_back(std::move(ring));
  }

  /// @param first  a pixel along whose top the ring runs
  [[nodiscard]] BorderRing trace(const cv::Point& first) const {
    BorderRing ring;
    cv::Point corner = first;
    std::size_t direction = kEast;
    do {
      ring.push_back({corner, corner + kRight[direction]});
      corner += kSteps[direction];
      if (mask_(corner + kLeft[direction]) != 0) {
        direction = (direction + 3) % 4;  // left: pixels that share a corner belong together
      } else if (mask_(corner + kRight[direction]) == 0) {
        direction = (direction + 1) % 4;
      }
    } while (corner != first || direction != kEast);
    return ring;
  }

  cv::Mat1b mask_;
  cv::Mat1i top_edge_ring_;   // by pixel: the ring along its top edge
  cv::Mat1i top_edge_place_;  // by pixel: that ring's step there
  std::vector<BorderRing> rings_;
  std::vector<std::size_t> parts_;  // indices of outer rings
  std::vector<std::size_t> holes_;
};

}  // namespace

std::vector<BorderRing> partBorders(const Mask& mask) {
  if (mask.empty()) return {};
  cv::Mat1b with_margin;
  cv::copyMakeBorder(mask.pixels(), with_margin, 1, 1, 1, 1,
                     cv::BORDER_CONSTANT | cv::BORDER_ISOLATED, cv::Scalar(0));
  std::vector<BorderRing> parts = BorderTracer(with_margin).parts();
  const cv::Point offset = mask.offset() - cv::Point(1, 1);
  for (BorderRing& part : parts) {
    for (BorderStep& step : part) step = {step.corner + offset, step.pixel + offset};
  }
  return parts;
}

BorderRing walk(const std::vector<BorderRing>& rings, const Branches& branches,
                const Branch& root) {
  struct Round {
    Branch ring;
    std::size_t steps = 0;          // taken
    std::size_t branches_left = 0;  // at the current step
  };
  const auto branchesAt = [&](std::size_t ring, std::size_t index) {
    const auto found = branches.find({ring, index});
    return found == branches.end() ? nullptr : &found->second;
  };
  BorderRing result;
  std::vector<Round> rounds;  // an explicit stack, as noisy masks nest deeply
  const auto stepTo = [&](Round& round, std::size_t index) {
    const auto* leaving = branchesAt(round.ring.ring, index);
    result.push_back(rings[round.ring.ring][index]);
    round.branches_left = leaving == nullptr ? 0 : leaving->size();
  };
  rounds.push_back({root});
  stepTo(rounds.back(), root.start);
  while (!rounds.empty()) {
    Round& round = rounds.back();
    const std::size_t size = rings[round.ring.ring].size();
    const std::size_t index = (round.ring.start + round.steps) % size;
    if (round.branches_left > 0) {
      const auto& leaving = *branchesAt(round.ring.ring, index);
      const Branch branch = leaving[leaving.size() - round.branches_left];
      --round.branches_left;
      rounds.push_back({branch});
      stepTo(rounds.back(), branch.start);
    } else if (round.steps + 1 < size) {
      ++round.steps;
      stepTo(round, (index + 1) % size);
    } else {
      if (rounds.size() > 1) result.push_back(rings[round.ring.ring][round.ring.start]);
      rounds.pop_back();
      if (!rounds.empty()) {
        const Round& left = rounds.back();
        const BorderRing& ring = rings[left.ring.ring];
        result.push_back(ring[(left.ring.start + left.steps) % ring.size()]);
      }
    }
  }
  return result;
}

}  // namespace synthetic_dataset::masks
