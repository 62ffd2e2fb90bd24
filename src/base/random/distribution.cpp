#include "base/random/distribution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/random/weighted_index.h"

namespace synthetic_dataset::base {
namespace {

using Numbers = Distribution::Numbers;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr int kMostDraws = 1000;  // until one lies within its bounds

double least(const Numbers& numbers) { return *std::min_element(numbers.begin(), numbers.end()); }
double greatest(const Numbers& numbers) {
  return *std::max_element(numbers.begin(), numbers.end());
}

double drawNormal(RandomSource& source, double mean, double stddev, double low, double high) {
  double number = mean;
  for (int i = 0; i < kMostDraws; ++i) {
    number = mean + stddev * source.normal();
    if (number >= low && number <= high) return number;
  }
  return std::clamp(number, low, high);
}

}  // namespace

double componentOf(const Numbers& numbers, std::size_t component) {
  return numbers.size() == 1 ? numbers.front() : numbers[component];
}

Distribution::Distribution(std::size_t dimension, Kind kind)
    : dimension_(dimension), kind_(std::move(kind)) {}

Distribution Distribution::constant(Numbers value) { return choice({std::move(value)}); }

Distribution Distribution::uniform(Numbers low, Numbers high, std::size_t dimension) {
  return {dimension, Uniform{std::move(low), std::move(high)}};
}

Distribution Distribution::logUniform(Numbers low, Numbers high, std::size_t dimension) {
  return {dimension, LogUniform{std::move(low), std::move(high)}};
}

Distribution Distribution::normal(Numbers mean, Numbers stddev, std::size_t dimension) {
  return normalBetween(std::move(mean), std::move(stddev), {-kInfinity}, {kInfinity}, dimension);
}

Distribution Distribution::normalBetween(Numbers mean, Numbers stddev, Numbers low, Numbers high,
                                         std::size_t dimension) {
  return {dimension, Normal{std::move(mean), std::move(stddev), std::move(low), std::move(high)}};
}

Distribution Distribution::choice(std::vector<Numbers> values, std::vector<double> weights) {
  const std::size_t dimension = values.front().size();
  return {dimension, Choice{std::move(values), std::move(weights)}};
}

struct Distribution::Draw {
  RandomSource& source;
  std::size_t dimension;

  Numbers operator()(const Uniform& kind) const {
    return components(kind.low.size() == 1 && kind.high.size() == 1, [&](std::size_t i) {
      const double low = componentOf(kind.low, i);
      const double high = componentOf(kind.high, i);
      return std::clamp(source.uniform(low, high), low, high);  // rounding may exceed an end
    });
  }

  Numbers operator()(const LogUniform& kind) const {
    return components(kind.low.size() == 1 && kind.high.size() == 1, [&](std::size_t i) {
      const double low = componentOf(kind.low, i);
      const double high = componentOf(kind.high, i);
      return std::clamp(std::exp(source.uniform(std::log(low), std::log(high))), low, high);
    });
  }

  Numbers operator()(const Normal& kind) const {
    const bool is_shared = kind.mean.size() == 1 && kind.stddev.size() == 1 &&
                           kind.low.size() == 1 && kind.high.size() == 1;
    return components(is_shared, [&](std::size_t i) {
      return drawNormal(source, componentOf(kind.mean, i), componentOf(kind.stddev, i),
                        componentOf(kind.low, i), componentOf(kind.high, i));
    });
  }

  Numbers operator()(const Choice& kind) const {
    return kind.values[weightedIndex(source, kind.values.size(), kind.weights)];
  }

  /// One draw for all components, or one for each.
  template <class DrawOne>
  Numbers components(bool is_shared, const DrawOne& drawOne) const {
    if (is_shared) return Numbers(dimension, drawOne(0));
    Numbers drawn;
    for (std::size_t i = 0; i < dimension; ++i) drawn.push_back(drawOne(i));
    return drawn;
  }
};

/// The least and the greatest number that a kind of distribution can draw.
struct Distribution::Extremes {
  template <class Bounded>
  std::pair<double, double> operator()(const Bounded& kind) const {
    return {least(kind.low), greatest(kind.high)};
  }

  std::pair<double, double> operator()(const Choice& kind) const {
    std::pair<double, double> extremes = {kInfinity, -kInfinity};
    for (const Numbers& value : kind.values) {
      extremes.first = std::min(extremes.first, least(value));
      extremes.second = std::max(extremes.second, greatest(value));
    }
    return extremes;
  }
};

std::vector<double> Distribution::draw(RandomSource& source) const {
  return std::visit(Draw{source, dimension_}, kind_);
}

std::vector<Numbers> Distribution::values() const {
  const auto* choice = std::get_if<Choice>(&kind_);
  return choice == nullptr ? std::vector<Numbers>{} : choice->values;
}

double Distribution::lowest() const { return std::visit(Extremes{}, kind_).first; }

double Distribution::highest() const { return std::visit(Extremes{}, kind_).second; }

}  // namespace synthetic_dataset::base
