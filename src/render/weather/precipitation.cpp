#include "render/weather/precipitation.h"

#include <algorithm>
#include <cmath>

#include "base/random/random_source.h"
#include "render/weather/cell_seed.h"

// In this file, lengths are in mm and flakes' masses in mg unless stated otherwise.

namespace synthetic_dataset::render {
namespace {

constexpr double kMillimetre = 1e-3;  // [m]
constexpr double kLargestDrop = 6.0;  // larger ones break up as they fall
constexpr double kLargestMelted = 4.0;

}  // namespace

Precipitation Precipitation::rain(double rate) {
  const double slope = 4.1 * std::pow(rate, -0.21);
  return {Kind::kRain, 8000.0 / slope, slope};
}

Precipitation Precipitation::snow(double rate) {
  const double slope = 2.55 * std::pow(rate, -0.48);
  return {Kind::kSnow, 3800.0 * std::pow(rate, -0.87) / slope, slope};
}

/// A flake's diameter, from that of the drop that it melts to: its mass is 0.073 D^1.4.
double Precipitation::diameterOf(double water) const {
  if (kind_ == Kind::kRain) return water;
  return std::pow(M_PI / 6.0 * water * water * water / 0.073, 1.0 / 1.4);
}

double Precipitation::waterOf(double diameter) const {
  if (kind_ == Kind::kRain) return diameter;
  return std::cbrt(6.0 / M_PI * 0.073 * std::pow(diameter, 1.4));
}

double Precipitation::opacityOf(double diameter) const {
  if (kind_ == Kind::kRain) return 1.0;
  const double centimetres = 100.0 * diameter;
  return std::min(1.0, 0.2285 * std::pow(centimetres, 1.88 - 2.0) / (M_PI / 4.0));
}

double Precipitation::speedOf(double diameter) const {
  const double width = diameter / kMillimetre;
  if (kind_ == Kind::kRain) return std::max(0.1, 9.65 - 10.3 * std::exp(-0.6 * width));
  return 0.8 * std::pow(width, 0.16);
}

std::vector<Drop> Precipitation::in(const Eigen::Vector3i& cell, double least,
                                    std::uint64_t seed) const {
  base::RandomSource random(cellSeed(seed, cell) + static_cast<std::uint64_t>(kind_));
  const double end = number_ * std::exp(-slope_ * waterOf(least / kMillimetre));
  std::vector<Drop> drops;
  // The number of larger drops is a Poisson process: its steps are exponentially distributed.
  for (double larger = 0.0;;) {
    larger -= std::log(1.0 - random.unit());
    const double x = random.unit();  // one by one: the order of arguments is unspecified
    const double y = random.unit();
    const double z = random.unit();
    if (larger >= end) return drops;
    const double largest = kind_ == Kind::kRain ? kLargestDrop : kLargestMelted;
    const double diameter = diameterOf(std::min(-std::log(larger / number_) / slope_, largest));
    drops.push_back({cell.cast<double>() + Eigen::Vector3d(x, y, z), kMillimetre * diameter});
  }
}

}  // namespace synthetic_dataset::render
