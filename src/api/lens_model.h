#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "synthetic_dataset/distortion.h"

namespace synthetic_dataset::lens {

/// What a lens does with directions of the optical frame. All functions get the distortion.
struct LensFunctions {
  /// Whether nothing is seen from 90 degrees on, and nearness is measured along the axis.
  bool has_near_plane;

  /// How far from the axis what is at an angle [rad] appears on the plane z = 1, for the lens's
  /// kind alone, without the polynomials that bend its picture; nothing where it does not see.
  std::optional<double> (*radiusAt)(const Distortion&, double angle);

  /// The angle that radiusAt() gives this radius to or, where none does, the nearest to it.
  double (*angleAt)(const Distortion&, double radius);

  /// Whether the whole lens is one to one about this angle.
  bool (*isOneToOne)(const Distortion&, double angle);

  /// Where a direction (of any length) falls on the plane z = 1: its pixel is (fx x + cx,
  /// fy y + cy). Nothing beyond the largest angle.
  std::optional<Eigen::Vector2d> (*distort)(const Distortion&, double largest_angle,
                                            const Eigen::Vector3d& direction);

  /// The unit vector that distort() takes to a place; nothing where there is none.
  std::optional<Eigen::Vector3d> (*undistort)(const Distortion&, double largest_angle,
                                              const Eigen::Vector2d& place);
};

/// All that the software knows of one model of lenses.
struct LensModel {
  DistortionModel model;
  std::vector<std::string> names;   ///< the first is written; others are read, in small letters
                                    ///< and without spaces, hyphens and underscores
  std::vector<std::size_t> counts;  ///< of coefficients that lists may have
  std::size_t written;              ///< so many coefficients are written at least
  std::string coefficients;         ///< how many there are, and which, for messages
  bool bends_without;               ///< it is not a pinhole when all of its coefficients are 0
  const LensFunctions* functions;

  /// What is wrong with the coefficients; nothing where all is right.
  std::string (*fault)(const Distortion&) = nullptr;
};

[[nodiscard]] const LensModel& modelOf(DistortionModel model);

/// All of them, a row each, in the order of DistortionModel.
[[nodiscard]] const std::vector<LensModel>& allModels();

}  // namespace synthetic_dataset::lens
