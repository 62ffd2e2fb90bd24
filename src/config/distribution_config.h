#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <string>

#include "base/random/distribution.h"
#include "base/random/weighted_index.h"
#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::config {

/// The range that a distribution in the settings may draw from, both ends included.
struct DistributionRange {
  std::size_t dimension = 1;                              ///< of vectors, such as 3 for colours
  double low = -std::numeric_limits<double>::infinity();  ///< of each component
  double high = std::numeric_limits<double>::infinity();  ///< of each component

  /// Whether a distribution given by single numbers is drawn for each component, as for places.
  /// Else it is drawn once for all, so that a colour is a grey.
  bool draws_each = false;

  bool is_angle = false;  ///< [rad]
};

/// For the end of messages about angles.
inline constexpr const char* kAngleUnit = " rad (degrees are written deg(20))";

/// [m] from the global frame's origin, along each axis
inline constexpr double kFarthest = 1e6;
inline constexpr DistributionRange kPlaceRange{3, -kFarthest, kFarthest, true};

/// [rad]: from straight down to straight up; and up to a whole turn either way.
inline constexpr double kHalfTurn = 3.141592653589793;
inline constexpr DistributionRange kElevationRange{1, -kHalfTurn / 2.0, kHalfTurn / 2.0, false,
                                                   true};
inline constexpr DistributionRange kTurnRange{1, -2.0 * kHalfTurn, 2.0 * kHalfTurn, false, true};

/// The distribution of a number, or of a vector of numbers: a single number, which is a constant,
/// or a group with one of
///
///     uniform: [low, high]
///     log_uniform: [low, high]
///     normal: [mean, stddev]    # and min and max, if it should not reach the range's ends
///     choice: [a, b, ...]       # and weights: [.., ..], one for each
///
/// For vectors, each of these except the weights may be a list with a number for each component.
///
/// What is wrong, or could be drawn out of range, is noted in `group` as an error of `name`.
/// @return nullopt if it is missing or wrong
[[nodiscard]] std::optional<base::Distribution> maybeDistribution(
    Parameters group, const std::string& name, const DistributionRange& range = {});

/// The same for a text: a single one, or a group with `choice` and optionally `weights`.
[[nodiscard]] std::optional<base::TextChoice> maybeChoice(Parameters group,
                                                          const std::string& name);

}  // namespace synthetic_dataset::config
