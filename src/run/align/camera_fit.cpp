#include "run/align/camera_fit.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Cholesky>

namespace synthetic_dataset::run {
namespace {

using SquareMatrix =
    Eigen::Matrix<double, AlignmentVector::RowsAtCompileTime, AlignmentVector::RowsAtCompileTime>;

constexpr double kAlike = 20.0;  // number of correlated edges, as neighbours on an outline are
constexpr int kReweightings = 10;

/// Standard deviations of the prior: larger corrections are never needed.
AlignmentVector farthest() {
  constexpr double kShift = 0.5;  // [m]
  constexpr double kTurn = 0.2;   // [rad]
  constexpr double kTime = 1.0;   // [s]
  constexpr double kFocal = 0.1;  // of the focal length
  AlignmentVector change;
  change << kShift, kShift, kShift, kTurn, kTurn, kTurn, kTime, kFocal;
  return change;
}

/// Normal equations: weighted sums over edges.
struct Normal {
  SquareMatrix matrix = SquareMatrix::Zero();
  AlignmentVector vector = AlignmentVector::Zero();

  void add(const AlignmentVector& change, double distance, double weight) {
    matrix += weight * change * change.transpose();
    vector += weight * distance * change;
  }
};

/// The weight of an edge at a distance from the outline after the change.
double weightOf(double rest, double scale) {
  const double share = 1.0 + rest * rest / (scale * scale);
  return 1.0 / (share * share);
}

AlignmentVector usedChange(const OutlineEdge& edge, const FitFreedom& freedom) {
  AlignmentVector change = edge.change;
  if (!freedom.time) change[kTimeEntry] = 0.0;
  if (!freedom.focal_length) change[kFocalEntry] = 0.0;
  return change;
}

}  // namespace

CameraFit fitCamera(const std::vector<std::vector<OutlineEdge>>& scenes, double reach,
                    const FitFreedom& freedom) {
  const SquareMatrix prior =
      AlignmentVector(farthest().cwiseAbs2().cwiseInverse() * kAlike).asDiagonal();
  CameraFit fit;
  SquareMatrix inverse = SquareMatrix::Zero();
  double scale = reach;
  const double finest = std::max(1.0, reach / 8.0);
  for (int i = 0; i < kReweightings; ++i, scale = std::max(finest, 0.7 * scale)) {
    Normal normal;
    normal.matrix = prior;
    for (const auto& edges : scenes) {
      for (const OutlineEdge& edge : edges) {
        const AlignmentVector change = usedChange(edge, freedom);
        const double rest = edge.distance - change.dot(fit.change);
        normal.add(change, edge.distance, weightOf(rest, scale));
      }
    }
    inverse = normal.matrix.ldlt().solve(SquareMatrix::Identity());
    fit.change = inverse * normal.vector;
  }
  SquareMatrix spread = SquareMatrix::Zero();
  for (const auto& edges : scenes) {
    AlignmentVector pull = AlignmentVector::Zero();
    for (const OutlineEdge& edge : edges) {
      const AlignmentVector change = usedChange(edge, freedom);
      const double rest = edge.distance - change.dot(fit.change);
      pull += weightOf(rest, scale) * rest * change;
    }
    spread += pull * pull.transpose();
  }
  const SquareMatrix robust = inverse * spread * inverse;
  fit.stddev = robust.diagonal().cwiseMax(kAlike * inverse.diagonal()).cwiseMax(0.0).cwiseSqrt();
  return fit;
}

}  // namespace synthetic_dataset::run
