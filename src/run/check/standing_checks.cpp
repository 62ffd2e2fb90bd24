#include "run/check/standing_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

/// An object's vertical extent and centre.
struct Standing {
  double top = 0.0;     ///< z of its model's highest corner [m]
  double bottom = 0.0;  ///< [m]
  Eigen::Vector3d middle_G{0, 0, 0};
};

Standing standingOf(const Cuboid& box_O, const Pose& X_GO) {
  Standing standing{-std::numeric_limits<double>::infinity(),
                    std::numeric_limits<double>::infinity(), X_GO * box_O.centre()};
  for (const Eigen::Vector3d& corner_O : box_O.corners()) {
    const double z = (X_GO * corner_O).z();
    standing.top = std::max(standing.top, z);
    standing.bottom = std::min(standing.bottom, z);
  }
  return standing;
}

/// What is below an object in the course of a motion.
struct Below {
  std::size_t moments = 0;
  std::vector<std::size_t> without_ground;  ///< moments
  std::vector<double> gaps;                 ///< from the ground to its bottom [m]; negative if sunk
  double height = 0.0;                      ///< of the object [m]
  std::string ground;                       ///< the last model found there
  std::vector<std::size_t> in_walls;        ///< moments
  std::string wall;                         ///< the model of the first such wall
};

/// Measures the gap from the ground, which is above a buried object, to the object's bottom.
void lookBelow(const Standing& standing, const NamedRays& rays, std::size_t moment, Below& below) {
  constexpr double kDeepest = 100.0;  // [m]
  Eigen::Vector3d top_G = standing.middle_G;
  top_G.z() = standing.top + 1e-3;
  ++below.moments;
  below.height = standing.top - standing.bottom;
  if (const auto hit = rays.cast(top_G, -Eigen::Vector3d::UnitZ(), kDeepest)) {
    below.gaps.push_back(standing.bottom - (top_G.z() - hit->distance));
    below.ground = hit->model;
    return;
  }
  if (const auto hit = rays.cast(top_G, Eigen::Vector3d::UnitZ(), below.height)) {
    below.gaps.push_back(standing.bottom - (top_G.z() + hit->distance));
    below.ground = hit->model;
    return;
  }
  below.without_ground.push_back(moment);
}

/// Looks for walls inside an object: casts rays sideways from its centre, well within half of its
/// narrower side.
void lookAround(const Cuboid& box_O, const Pose& X_GO, const NamedRays& rays, std::size_t moment,
                Below& below) {
  constexpr int kDirections = 8;
  constexpr double kWell = 0.7;  // of half of its width; what only touches it is not inside
  const double reach = kWell * 0.5 * box_O.size().head<2>().minCoeff();
  for (int i = 0; i < kDirections; ++i) {
    const double angle = 2.0 * M_PI * i / kDirections;
    const Eigen::Vector3d aside_G =
        X_GO.linear() * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0.0);
    const auto hit = rays.cast(X_GO * box_O.centre(), aside_G, reach);
    if (!hit) continue;
    if (below.in_walls.empty()) below.wall = hit->model;
    below.in_walls.push_back(moment);
    return;
  }
}

std::string lengthText(double length) { return fixed(length, length < 0.1 ? 3 : 2) + " m"; }

Finding noGround(const std::string& object, const Below& below, const Moment& first,
                 const Pose& X_GO) {
  return {
      "no ground", object,
      "nothing of the world is below it at " + std::to_string(below.without_ground.size()) +
          " of " + std::to_string(below.moments) + " times, first at " +
          fixed(toSeconds(first.stamp), 3) + " s, where it stands at [" +
          fixed(X_GO.translation().x(), 2) + ", " + fixed(X_GO.translation().y(), 2) + ", " +
          fixed(X_GO.translation().z(), 2) + "]",
      "the ground may end there (a larger one in the world, `duration` or `start_offset` help), "
      "or the world's origin may not be that of global_frame"};
}

Finding inWalls(const std::string& object, const Below& below, const Moment& first,
                const Pose& X_GO) {
  return {"in walls", object,
          "is inside parts of the world at " + std::to_string(below.in_walls.size()) + " of " +
              std::to_string(below.moments) + " times, first in '" + below.wall + "' at " +
              fixed(toSeconds(first.stamp), 3) + " s, where it stands at [" +
              fixed(X_GO.translation().x(), 2) + ", " + fixed(X_GO.translation().y(), 2) + ", " +
              fixed(X_GO.translation().z(), 2) + "]",
          "the map shows its path; the recording may be of another world, or the world's origin "
          "may not be that of global_frame"};
}

double medianGap(std::vector<double> numbers) {
  const auto middle = numbers.begin() + static_cast<std::ptrdiff_t>(numbers.size() / 2);
  std::nth_element(numbers.begin(), middle, numbers.end());
  return *middle;
}

/// Whether the height above the ground is nearly constant most of the time, unlike that of a flying
/// object.
bool isSteady(const std::vector<double>& gaps, double median) {
  constexpr double kSteady = 0.015;  // [m]
  constexpr double kNearlyAll = 0.8;
  const auto steady = std::count_if(gaps.begin(), gaps.end(),
                                    [&](double gap) { return std::abs(gap - median) < kSteady; });
  return static_cast<double>(steady) >= kNearlyAll * static_cast<double>(gaps.size());
}

void checkGap(const std::string& object, const Below& below, std::vector<Finding>& findings) {
  constexpr double kLeast = 0.03;  // [m]; wheels sink this far into the ground of recordings
  constexpr double kHover = 0.75;  // of its height; an object that is higher is meant to fly
  if (below.gaps.empty()) return;
  const double gap = medianGap(below.gaps);
  if (!isSteady(below.gaps, gap)) return;
  const std::string cure =
      "its frame may be at another height than its model's origin (base_link and base_footprint "
      "differ by a wheel's radius: `frame_id` chooses), or the world's ground at a wrong one";
  if (gap > kLeast && gap < kHover * below.height) {
    findings.push_back(
        {"floats", object,
         "floats " + lengthText(gap) + " above '" + below.ground + "' nearly all the time", cure});
  } else if (gap < -std::max(kLeast, 0.05 * below.height)) {
    findings.push_back(
        {"sinks", object,
         "sinks " + lengthText(-gap) + " into '" + below.ground + "' nearly all the time", cure});
  }
}

/// Whether it is placed anywhere in a volume and is above the ground most of the time.
bool hangsByChance(const MotionSetup& motion, const Below& below) {
  constexpr double kHangs = 0.03;  // [m]
  const auto hanging =
      std::count_if(below.gaps.begin(), below.gaps.end(), [](double gap) { return gap > kHangs; });
  return motion.config.isPlaced() &&
         motion.config.placement.mode == randomize::PlacementMode::kVolume && hanging > 0 &&
         2 * static_cast<std::size_t>(hanging) > below.moments;
}

Finding hanging(const std::string& object, const Below& below) {
  return {"hangs", object,
          "hangs in the air above '" + below.ground + "' in most of the scenes, by " +
              lengthText(medianGap(below.gaps)) +
              " (median): `placement/mode: volume` puts it anywhere in the volume",
          "`placement: {mode: ground}` lets it stand, `mode: drop` fall; if it flies on purpose, "
          "ignore this"};
}

}  // namespace

std::vector<Finding> checkStanding(const MotionSetup& motion, const NamedRays& rays,
                                   const std::vector<Moment>& moments) {
  std::vector<Finding> findings;
  for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
    const scene::ObjectOptions& object = motion.config.objects[i];
    if (!object.takes_part || object.is_distractor) continue;
    if (object.stands && !object.X_GM) continue;        // placed by the world's author
    if (motion.variants[i].all().size() > 1) continue;  // these stand at several heights
    const Cuboid box_O = motion.shapes->boxesAtRest(i).front();
    Below below;
    for (std::size_t at = 0; at < moments.size(); ++at) {
      const auto& X_GO = moments[at].X_GO[i];
      if (!X_GO) continue;
      lookBelow(standingOf(box_O, *X_GO), rays, at, below);
      lookAround(box_O, *X_GO, rays, at, below);
    }
    if (!below.in_walls.empty()) {
      const Moment& first = moments[below.in_walls.front()];
      findings.push_back(inWalls(object.name, below, first, *first.X_GO[i]));
    }
    if (!below.without_ground.empty()) {
      const Moment& first = moments[below.without_ground.front()];
      findings.push_back(noGround(object.name, below, first, *first.X_GO[i]));
    }
    if (hangsByChance(motion, below)) {
      findings.push_back(hanging(object.name, below));
    } else {
      checkGap(object.name, below, findings);
    }
  }
  return findings;
}

}  // namespace synthetic_dataset::run
