#include "world/mesh/farthest_pair.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include <Eigen/Geometry>

namespace synthetic_dataset::world {
namespace {

using Points = std::vector<Eigen::Vector3d>;

/// The points first .. last - 1, and their box; leaves have no children.
struct Node {
  std::size_t first = 0;
  std::size_t last = 0;
  Eigen::AlignedBox3d box;
  std::size_t child = 0;  ///< the first child, followed by the other; 0 (the root) for none

  [[nodiscard]] bool isLeaf() const { return child == 0; }
};

/// Builds a tree of boxes over the points, which it reorders; the root comes first.
std::vector<Node> makeTree(Points& points) {
  constexpr std::size_t kLeaf = 16;
  std::vector<Node> nodes;
  const auto add = [&](std::size_t first, std::size_t last) {
    Node node;
    node.first = first;
    node.last = last;
    for (std::size_t i = first; i < last; ++i) node.box.extend(points[i]);
    nodes.push_back(node);
  };
  add(0, points.size());
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const Node node = nodes[i];
    if (node.last - node.first <= kLeaf) continue;
    Eigen::Index axis = 0;
    node.box.sizes().maxCoeff(&axis);
    const std::size_t middle = (node.first + node.last) / 2;
    const auto place = [&](std::size_t at) {
      return points.begin() + static_cast<std::ptrdiff_t>(at);
    };
    std::nth_element(place(node.first), place(middle), place(node.last),
                     [axis](const auto& a, const auto& b) { return a[axis] < b[axis]; });
    nodes[i].child = nodes.size();
    add(node.first, middle);
    add(middle, node.last);
  }
  return nodes;
}

/// The largest distance that points of two boxes can have, squared.
double reachOf(const Eigen::AlignedBox3d& a, const Eigen::AlignedBox3d& b) {
  const Eigen::Vector3d ahead = (a.max() - b.min()).cwiseAbs();
  const Eigen::Vector3d back = (b.max() - a.min()).cwiseAbs();
  return ahead.cwiseMax(back).squaredNorm();
}

/// The range of a leaf's points along a direction, and their largest distance from a line along it.
struct Span {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double beside = 0.0;
};

/// Branch and bound over pairs of nodes. All distances are squared.
class Search {
 public:
  explicit Search(Points points) : points_(std::move(points)), nodes_(makeTree(points_)) {}

  double largest() {
    startFar();
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, 0}};
    while (!open.empty()) {
      const auto [a, b] = open.back();
      open.pop_back();
      if (reachOf(nodes_[a].box, nodes_[b].box) <= largest_) continue;
      if (nodes_[a].isLeaf() && nodes_[b].isLeaf()) {
        if (canBeat(nodes_[a], nodes_[b])) compare(nodes_[a], nodes_[b]);
        continue;
      }
      const auto size = [this](std::size_t node) { return nodes_[node].last - nodes_[node].first; };
      const bool split_a = !nodes_[a].isLeaf() && (nodes_[b].isLeaf() || size(a) >= size(b));
      const std::size_t whole = split_a ? b : a;
      const std::size_t child = split_a ? nodes_[a].child : nodes_[b].child;
      if (a == b) {
        open.insert(open.end(), {{child, child}, {child + 1, child + 1}, {child, child + 1}});
      } else {
        open.insert(open.end(), {{child, whole}, {child + 1, whole}});
      }
    }
    return largest_;
  }

 private:
  /// Goes from a point to the one farthest from it, a few times: this finds a pair that is far
  /// apart, if not the farthest.
  void startFar() {
    constexpr int kSteps = 4;
    Eigen::Vector3d from = points_.front();
    for (int i = 0; i < kSteps; ++i) {
      const auto farthest =
          std::max_element(points_.begin(), points_.end(), [&from](const auto& a, const auto& b) {
            return (a - from).squaredNorm() < (b - from).squaredNorm();
          });
      largest_ = std::max(largest_, (*farthest - from).squaredNorm());
      from = *farthest;
    }
  }

  [[nodiscard]] Span spanOf(const Node& node, const Eigen::Vector3d& centre,
                            const Eigen::Vector3d& direction) const {
    Span span;
    for (std::size_t i = node.first; i < node.last; ++i) {
      const Eigen::Vector3d from_centre = points_[i] - centre;
      const double along = from_centre.dot(direction);
      span.low = std::min(span.low, along);
      span.high = std::max(span.high, along);
      span.beside = std::max(span.beside, (from_centre - along * direction).norm());
    }
    return span;
  }

  /// Whether two leaves may have a pair that is farther apart: the extents of their points along
  /// the line between them are exact, and those across it add little.
  [[nodiscard]] bool canBeat(const Node& a, const Node& b) const {
    const Eigen::Vector3d centre = a.box.center();
    const Eigen::Vector3d direction = (b.box.center() - centre).normalized();
    const Span first = spanOf(a, centre, direction);
    const Span second = spanOf(b, centre, direction);
    const double along = std::max(second.high - first.low, first.high - second.low);
    const double across = first.beside + second.beside;
    constexpr double kRounding = 1.0 + 1e-12;
    return (along * along + across * across) * kRounding > largest_;
  }

  void compare(const Node& a, const Node& b) {
    for (std::size_t i = a.first; i < a.last; ++i) {
      for (std::size_t j = b.first; j < b.last; ++j) {
        largest_ = std::max(largest_, (points_[i] - points_[j]).squaredNorm());
      }
    }
  }

  Points points_;
  std::vector<Node> nodes_;
  double largest_ = 0.0;
};

}  // namespace

double largestDistance(std::vector<Eigen::Vector3d> points) {
  return points.empty() ? 0.0 : std::sqrt(Search(std::move(points)).largest());
}

}  // namespace synthetic_dataset::world
