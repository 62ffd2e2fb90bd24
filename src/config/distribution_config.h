#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "base/random/distribution.h"
#include "base/random/weighted_index.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// What a distribution in the settings may draw, both ends included.
struct DistributionRange {
  std::size_t dimension = 1;                              ///< of vectors, such as 3 of colours
  double low = -std::numeric_limits<double>::infinity();  ///< of each component
  double high = std::numeric_limits<double>::infinity();  ///< of each component

  /// Whether single numbers stand for a draw of each component: of places. Else they stand for one
  /// draw that serves all: of colours, a grey.
  bool draws_each = false;

  bool is_angle = false;  ///< [rad]
};

/// For the end of messages about angles.
inline constexpr const char* kAngleUnit = " rad (degrees are written deg(20))";

/// [m] from the global frame's origin, along each axis
inline constexpr double kFarthest = 1e6;
inline constexpr DistributionRange kPlaceRange{3, -kFarthest, kFarthest, true};

/// [rad]: from straight below to straight above; and up to a whole turn either way.
inline constexpr double kHalfTurn = 3.141592653589793;
inline constexpr DistributionRange kElevationRange{1, -kHalfTurn / 2.0, kHalfTurn / 2.0, false,
                                                   true};
inline constexpr DistributionRange kTurnRange{1, -2.0 * kHalfTurn, 2.0 * kHalfTurn, false, true};

/// What a number, or a vector of numbers, is drawn from: a number alone, which is a constant, or a
/// group with one of
///
///     uniform: [low, high]
///     log_uniform: [low, high]
///     normal: [mean, stddev]    # and min and max, where it is not to reach the range's ends
///     choice: [a, b, ...]       # and weights: [.., ..], as many
///
/// For vectors, each of these but the weights may be a list of a number for each component.
///
/// What is wrong, or could be drawn out of range, is noted in `group` as an error of `name`.
/// @return nothing where it is not there or wrong
[[nodiscard]] std::optional<base::Distribution> maybeDistribution(
    Parameters group, const std::string& name, const DistributionRange& range = {});

/// The same of a text: one alone, or a group with `choice` and perhaps `weights`.
[[nodiscard]] std::optional<base::TextChoice> maybeChoice(Parameters group,
                                                          const std::string& name);

}  // namespace synthetic_dataset::config
