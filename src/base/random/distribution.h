#pragma once

#include <cstddef>
#include <variant>
#include <vector>

#include "base/random/random_source.h"

namespace synthetic_dataset::base {

/// What a random number is drawn from, or a random vector such as a colour or a position.
///
/// A vector's distribution has parameters of one number, or of one for each component. Where all
/// are of one number, one draw serves all components: a colour drawn so is a grey. Otherwise each
/// component is drawn on its own.
///
/// What is written of a parameter's range holds for each of its numbers; nothing here checks it.
class Distribution {
 public:
  using Numbers = std::vector<double>;  ///< of a parameter: one, or one for each component

  /// Always the same.
  /// @param value  a number for each component, at least one
  [[nodiscard]] static Distribution constant(Numbers value);

  /// Each number between two as likely as the others.
  /// @param low  <= high
  [[nodiscard]] static Distribution uniform(Numbers low, Numbers high, std::size_t dimension = 1);

  /// Uniform in the logarithm: 1 to 10 as likely as 10 to 100.
  /// @param low  > 0, <= high
  [[nodiscard]] static Distribution logUniform(Numbers low, Numbers high,
                                               std::size_t dimension = 1);

  /// Unbounded.
  /// @param stddev  >= 0
  [[nodiscard]] static Distribution normal(Numbers mean, Numbers stddev, std::size_t dimension = 1);

  /// What lies out of bounds is drawn anew, at most 1000 times; then the nearer bound is taken. So
  /// bounds that leave next to nothing of the distribution are themselves what is drawn.
  /// @param stddev  >= 0
  /// @param low  <= high; -infinity: no bound
  /// @param high  infinity: no bound
  [[nodiscard]] static Distribution normalBetween(Numbers mean, Numbers stddev, Numbers low,
                                                  Numbers high, std::size_t dimension = 1);

  /// One of several.
  /// @param values  at least one, all with a number for each component
  /// @param weights  as many, none below 0 and one above it; empty: all alike
  [[nodiscard]] static Distribution choice(std::vector<Numbers> values,
                                           std::vector<double> weights = {});

  /// @return as many numbers as there are components
  [[nodiscard]] std::vector<double> draw(RandomSource& source) const;

  /// The number, of a distribution of dimension 1.
  [[nodiscard]] double drawNumber(RandomSource& source) const { return draw(source).front(); }

  /// No component is ever below the former or above the latter; infinite where there is no bound.
  [[nodiscard]] double lowest() const;
  [[nodiscard]] double highest() const;

  [[nodiscard]] std::size_t dimension() const { return dimension_; }

  /// All that can be drawn, where that is one of several; else nothing.
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
  struct Choice {  // of a single value: a constant
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

/// A component's number of a parameter of one number or of one for each component.
[[nodiscard]] double componentOf(const Distribution::Numbers& numbers, std::size_t component);

}  // namespace synthetic_dataset::base
