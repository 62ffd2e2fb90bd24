#include "world/shape/triangulation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::world {
namespace {

using Eigen::Vector2d;

/// Points closer than this count as one, as in Gazebo [m].
constexpr double kSamePoint = 1e-4;
constexpr std::size_t kMostCorners = 5000;

/// Twice the area of the triangle, positive if it is counter-clockwise.
double turn(const Vector2d& a, const Vector2d& b, const Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

double twiceArea(const Outline& outline) {
  double sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    sum += turn(outline.front(), outline[i], outline[(i + 1) % outline.size()]);
  }
  return sum;
}

std::string text(const Vector2d& point) {
  return "(" + fixed(point.x(), 3) + ", " + fixed(point.y(), 3) + ")";
}

Outline cleaned(const Outline& outline) {
  Outline result;
  for (const Vector2d& point : outline) {
    if (result.empty() || (point - result.back()).norm() > kSamePoint) result.push_back(point);
  }
  while (result.size() > 1 && (result.front() - result.back()).norm() <= kSamePoint) {
    result.pop_back();
  }
  if (result.size() < 3) {
    throw Error("the polyline has " + std::to_string(result.size()) +
                " different points; at least 3 are needed");
  }
  if (std::abs(twiceArea(result)) <= kSamePoint * kSamePoint) {
    throw Error("the polyline encloses no area; its points should not lie on one line");
  }
  return result;
}

struct Segment {
  Vector2d from, to;
};

/// Whether two segments cross in their interiors; ones that only touch do not.
bool cross(const Segment& a, const Segment& b) {
  const double b_from = turn(a.from, a.to, b.from);
  const double b_to = turn(a.from, a.to, b.to);
  const double a_from = turn(b.from, b.to, a.from);
  const double a_to = turn(b.from, b.to, a.to);
  return ((b_from > 0.0 && b_to < 0.0) || (b_from < 0.0 && b_to > 0.0)) &&
         ((a_from > 0.0 && a_to < 0.0) || (a_from < 0.0 && a_to > 0.0));
}

/// Whether a segment passes through a point between its ends.
bool passes(const Segment& line, const Vector2d& point) {
  const Vector2d along = line.to - line.from;
  const double length = along.norm();
  const double passed = along.dot(point - line.from) / length;
  constexpr double kTouch = 1e-9;  // of the line's length
  return std::abs(turn(line.from, line.to, point)) <= kTouch * length * length &&
         passed > kSamePoint && passed < length - kSamePoint;
}

std::vector<Segment> segmentsOf(const std::vector<Outline>& outlines) {
  std::vector<Segment> segments;
  for (const Outline& outline : outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      segments.push_back({outline[i], outline[(i + 1) % outline.size()]});
    }
  }
  return segments;
}

void requireNoCrossings(const std::vector<Segment>& segments) {
  for (std::size_t i = 0; i < segments.size(); ++i) {
    for (std::size_t j = i + 1; j < segments.size(); ++j) {
      if (!cross(segments[i], segments[j])) continue;
      throw Error("the polyline crosses itself: its line from " + text(segments[i].from) + " to " +
                  text(segments[i].to) + " and the one from " + text(segments[j].from) + " to " +
                  text(segments[j].to));
    }
  }
}

/// Whether a point lies inside an outline, from how often a ray along x crosses it.
bool contains(const Outline& outline, const Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vector2d& a = outline[i];
    const Vector2d& b = outline[(i + 1) % outline.size()];
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    const double x = a.x() + (point.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
    inside ^= point.x() < x;
  }
  return inside;
}

/// Whether `outer` encloses `inner`, which it does not cross. The majority of points decides, since
/// some may lie on the outer line itself.
bool encloses(const Outline& outer, const Outline& inner) {
  std::size_t within = 0;
  for (std::size_t i = 0; i < inner.size(); ++i) {
    if (contains(outer, 0.5 * (inner[i] + inner[(i + 1) % inner.size()]))) ++within;
  }
  return 2 * within > inner.size() && std::abs(twiceArea(outer)) > std::abs(twiceArea(inner));
}

/// The filled area that one outline encloses: the indices of its points and of those of its holes.
struct Area {
  std::vector<std::size_t> outer;
  std::vector<std::vector<std::size_t>> holes;
};

/// Cuts an area into triangles.
class EarClipper {
 public:
  EarClipper(const std::vector<Vector2d>& points, Area area)
      : points_(points), ring_(std::move(area.outer)) {
    const auto rightmost = [&](std::vector<std::size_t>& hole) {
      return std::max_element(hole.begin(), hole.end(), [&](std::size_t a, std::size_t b) {
        return points_[a].x() < points_[b].x();
      });
    };
    for (std::vector<std::size_t>& hole : area.holes) {
      std::rotate(hole.begin(), rightmost(hole), hole.end());
    }
    std::sort(area.holes.begin(), area.holes.end(), [&](const auto& a, const auto& b) {
      return points_[a.front()].x() > points_[b.front()].x();
    });
    for (std::size_t i = 0; i < area.holes.size(); ++i) join(area.holes, i);
  }

  void cut(std::vector<std::array<std::size_t, 3>>& triangles) {
    while (ring_.size() > 3) {
      const std::optional<std::size_t> ear = findEar();
      if (ear) triangles.push_back({before(*ear), ring_[*ear], after(*ear)});
      const std::optional<std::size_t> gone = ear ? ear : findFlat();
      if (!gone) throw Error("the polyline cannot be cut into triangles; its lines may touch");
      ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(*gone));
    }
    triangles.push_back({ring_[0], ring_[1], ring_[2]});
  }

 private:
  std::size_t before(std::size_t i) const { return ring_[(i + ring_.size() - 1) % ring_.size()]; }
  std::size_t after(std::size_t i) const { return ring_[(i + 1) % ring_.size()]; }
  const Vector2d& at(std::size_t point) const { return points_[point]; }

  /// Whether a line from the ring's i-th corner to a point starts inside the area.
  bool opensTo(std::size_t i, const Vector2d& point) const {
    const Vector2d& corner = at(ring_[i]);
    const bool left_of_next = turn(corner, at(after(i)), point) > 0.0;
    const bool left_of_last = turn(at(before(i)), corner, point) > 0.0;
    const bool convex = turn(at(before(i)), corner, at(after(i))) > 0.0;
    return convex ? left_of_next && left_of_last : left_of_next || left_of_last;
  }

  /// Whether a line crosses a ring or runs through one of its corners.
  bool meets(const Segment& line, const std::vector<std::size_t>& ring) const {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      if (cross(line, {at(ring[k]), at(ring[(k + 1) % ring.size()])})) return true;
      if (passes(line, at(ring[k]))) return true;
    }
    return false;
  }

  /// Joins the i-th hole, from its rightmost point, to the nearest corner that is visible from
  /// there.
  void join(const std::vector<std::vector<std::size_t>>& holes, std::size_t i) {
    const std::vector<std::size_t>& hole = holes[i];
    const Vector2d& start = at(hole.front());
    std::vector<std::size_t> corners(ring_.size());
    for (std::size_t k = 0; k < corners.size(); ++k) corners[k] = k;
    const auto distance = [&](std::size_t k) { return (at(ring_[k]) - start).squaredNorm(); };
    std::sort(corners.begin(), corners.end(),
              [&](std::size_t a, std::size_t b) { return distance(a) < distance(b); });
    const auto seen = std::find_if(corners.begin(), corners.end(), [&](std::size_t k) {
      const Segment line{at(ring_[k]), start};
      if (!opensTo(k, start) || meets(line, ring_)) return false;
      return std::none_of(holes.begin() + static_cast<std::ptrdiff_t>(i), holes.end(),
                          [&](const auto& other) { return meets(line, other); });
    });
    if (seen == corners.end()) throw Error("a hole of the polyline touches its outline");
    std::vector<std::size_t> detour = hole;
    detour.push_back(hole.front());
    detour.push_back(ring_[*seen]);
    ring_.insert(ring_.begin() + static_cast<std::ptrdiff_t>(*seen) + 1, detour.begin(),
                 detour.end());
  }

  std::optional<std::size_t> findEar() const {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      if (isEar(i)) return i;
    }
    return std::nullopt;
  }

  /// A corner at which the ring goes straight on, or straight back.
  std::optional<std::size_t> findFlat() const {
    for (std::size_t i = 0; i < ring_.size(); ++i) {
      const Vector2d& a = at(before(i));
      const Vector2d& c = at(after(i));
      const double length = std::max((at(ring_[i]) - a).norm(), (c - at(ring_[i])).norm());
      if (std::abs(turn(a, at(ring_[i]), c)) <= 1e-12 * length * length) return i;
    }
    return std::nullopt;
  }

  bool isEar(std::size_t i) const {
    const std::array<std::size_t, 3> ear{before(i), ring_[i], after(i)};
    if (turn(at(ear[0]), at(ear[1]), at(ear[2])) <= 0.0) return false;
    for (std::size_t other = 0; other < ring_.size(); ++other) {
      if (blocks(other, ear)) return false;
    }
    return true;
  }

  /// Whether the ring enters a triangle at a corner; it may touch it from outside.
  bool blocks(std::size_t corner, const std::array<std::size_t, 3>& triangle) const {
    const Vector2d& p = at(ring_[corner]);
    for (std::size_t side = 0; side < 3; ++side) {
      const Vector2d& from = at(triangle[side]);
      const Vector2d& to = at(triangle[(side + 1) % 3]);
      const double inwards = turn(from, to, p);
      if (p == from || inwards < 0.0) return false;
      const bool stays_outside =
          turn(from, to, at(before(corner))) <= 0.0 && turn(from, to, at(after(corner))) <= 0.0;
      if (inwards == 0.0 && stays_outside) return false;
    }
    return true;
  }

  const std::vector<Vector2d>& points_;
  std::vector<std::size_t> ring_;
};

/// How many others enclose each outline.
std::vector<std::size_t> depthsOf(const std::vector<Outline>& outlines) {
  std::vector<std::size_t> depths(outlines.size(), 0);
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    for (std::size_t j = 0; j < outlines.size(); ++j) {
      if (i != j && encloses(outlines[j], outlines[i])) ++depths[i];
    }
  }
  return depths;
}

std::vector<Area> areasOf(const std::vector<Outline>& outlines,
                          const std::vector<std::size_t>& depths) {
  std::vector<std::vector<std::size_t>> rings;
  std::size_t count = 0;
  for (const Outline& outline : outlines) {
    std::vector<std::size_t>& ring = rings.emplace_back(outline.size());
    for (std::size_t& point : ring) point = count++;
  }
  std::vector<Area> areas;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (depths[i] % 2 == 1) continue;
    Area& area = areas.emplace_back();
    area.outer = rings[i];
    for (std::size_t j = 0; j < outlines.size(); ++j) {
      const bool hole = depths[j] == depths[i] + 1 && encloses(outlines[i], outlines[j]);
      if (hole) area.holes.push_back(rings[j]);
    }
  }
  return areas;
}

}  // namespace

Triangulation triangulate(const std::vector<Outline>& outlines) {
  Triangulation result;
  std::size_t count = 0;
  for (const Outline& outline : outlines) count += outline.size();
  if (count > kMostCorners) {
    throw Error("the polyline has " + std::to_string(count) + " points; at most " +
                std::to_string(kMostCorners) + " can be filled");
  }
  for (const Outline& outline : outlines) result.outlines.push_back(cleaned(outline));
  requireNoCrossings(segmentsOf(result.outlines));
  const std::vector<std::size_t> depths = depthsOf(result.outlines);
  std::vector<Vector2d> points;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    Outline& outline = result.outlines[i];
    const bool hole = depths[i] % 2 == 1;
    if ((twiceArea(outline) < 0.0) != hole) std::reverse(outline.begin(), outline.end());
    points.insert(points.end(), outline.begin(), outline.end());
  }
  for (Area& area : areasOf(result.outlines, depths)) {
    EarClipper(points, std::move(area)).cut(result.triangles);
  }
  return result;
}

}  // namespace synthetic_dataset::world
