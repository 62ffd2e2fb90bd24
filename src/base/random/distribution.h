#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "base/random/random_source.h"

namespace synthetic_dataset::base {

/// The distribution of a random number, or of a random vector such as a colour or a position.
///
/// A vector's distribution has parameters of one number, or of one for each component. If all of
/// them have one number, one draw serves all components: a colour drawn like that is a grey.
/// Otherwise each component is drawn on its own.
///
/// The documented range of a parameter applies to each of its numbers and is not checked.
class Distribution {
 public:
  using Numbers = std::vector<double>;  ///< of a parameter: one, or one for each component

  /// Always the same.
  /// @param value  a number for each component, at least one
  [[nodiscard]] static Distribution constant(Numbers value);

  /// Uniform between two numbers.
  /// @param low  <= high
  [[nodiscard]] static Distribution uniform(Numbers low, Numbers high, std::size_t dimension = 1);

  /// Uniform in the logarithm: 1 to 10 is as likely as 10 to 100.
  /// @param low  > 0, <= high
  [[nodiscard]] static Distribution logUniform(Numbers low, Numbers high,
                                               std::size_t dimension = 1);

  /// Normal without bounds.
  /// @param stddev  >= 0
  [[nodiscard]] static Distribution normal(Numbers mean, Numbers stddev, std::size_t dimension = 1);

  /// Normal between bounds. A number out of bounds is drawn anew, up to 1000 draws in all; then the
  /// nearer bound is taken. So if the bounds leave next to nothing of the distribution, a bound
  /// itself is drawn.
  /// @param stddev  >= 0
  /// @param low  <= high; -infinity: no bound
  /// @param high  infinity: no bound
  [[nodiscard]] static Distribution normalBetween(Numbers mean, Numbers stddev, Numbers low,
                                                  Numbers high, std::size_t dimension = 1);

  /// One of several values.
  /// @param values  at least one, all with a number for each component
  /// @param weights  as many, none below 0 and at least one above it; empty: all equally likely
  [[nodiscard]] static Distribution choice(std::vector<Numbers> values,
                                           std::vector<double> weights = {});

  /// @return as many numbers as there are components
  [[nodiscard]] std::vector<double> draw(RandomSource& source) const;

  /// Draws from a distribution of dimension 1.
  [[nodiscard]] double drawNumber(RandomSource& source) const { return draw(source).front(); }

  /// Bounds of all components; infinite if there is no bound.
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double highest() const;

  [[nodiscard]] std::size_t dimension() const { return dimension_; }

  /// All values that can be drawn, for a constant or a choice; else empty.
  [[nodiscard]] std::vector<Numbers> values() const;

 private:
  struct Uniform {
    Numbers low;
    Numbers high;
  };
  struct LogUniform {
    Numbers low;
    Numbers high;
  };
  struct Normal {
    Numbers mean;
    Numbers stddev;
    Numbers low;
    Numbers high;
  };
  struct Choice {  // a constant if it has a single value
    std::vector<Numbers> values;
    std::vector<double> weights;
  };
  using Kind = std::variant<Uniform, LogUniform, Normal, Choice>;

  Distribution(std::size_t dimension, Kind kind);

  struct Draw;
  struct Extremes;

  std::size_t dimension_;
  Kind kind_;
};

/// A component's number in a parameter that has one number, or one for each component.
[[nodiscard]] double componentOf(const Distribution::Numbers& numbers, std::size_t component);

}  // namespace synthetic_dataset::base
