#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/distortion.h"

namespace synthetic_dataset::lens {

/// How a lens maps directions in the optical frame. All functions receive the distortion.
struct LensFunctions {
  /// Whether nothing is visible at 90 degrees or more from the axis, and nearness is measured along
  /// the axis.
  bool has_near_plane;

  /// The distance from the axis at which a point at this angle [rad] appears on the plane z = 1,
  /// for the lens's base projection without the distortion polynomials; nullopt if it does not see
  /// that far.
  std::optional<double> (*radiusAt)(const Distortion&, double angle);

  /// The angle at which radiusAt() returns this radius or, if it never does, comes nearest.
  double (*angleAt)(const Distortion&, double radius);

  /// Whether the whole lens is one-to-one around this angle.
  bool (*isOneToOne)(const Distortion&, double angle);

  /// Projects a direction (of any length) to the plane z = 1: its pixel is (fx x + cx, fy y + cy).
  /// Returns nullopt beyond the largest angle.
  std::optional<Eigen::Vector2d> (*distort)(const Distortion&, double largest_angle,
                                            const Eigen::Vector3d& direction);

  /// The unit vector that distort() maps to this place; nullopt if there is none.
  std::optional<Eigen::Vector3d> (*undistort)(const Distortion&, double largest_angle,
                                              const Eigen::Vector2d& place);
};

/// Everything known about one lens model.
struct LensModel {
  DistortionModel model;
  std::vector<std::string> names;   ///< the first is written; the others are only read, in lower
                                    ///< case and without spaces, hyphens and underscores
  std::vector<std::size_t> counts;  ///< of coefficients that lists may have
  std::size_t written;              ///< the least number of coefficients written
  std::string coefficients;         ///< their number and names, for messages
  bool bends_without_coefficients;  ///< it is not a pinhole even if all coefficients are 0
  const LensFunctions* functions;

  /// What is wrong with the coefficients; empty if nothing is.
  std::string (*fault)(const Distortion&) = nullptr;
};

[[nodiscard]] const LensModel& modelOf(DistortionModel model);

/// All lens models, in the order of DistortionModel.
[[nodiscard]] const std::vector<LensModel>& allModels();

}  // namespace synthetic_dataset::lens
