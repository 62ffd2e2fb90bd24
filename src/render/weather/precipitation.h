#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::render {

/// A drop or a flake.
struct Drop {
  Eigen::Vector3d p_G;  ///< [m]
  double diameter;      ///< [m]
};

/// Rain or snow: how many drops or flakes of which sizes the air contains, and how fast they fall.
/// The number per volume of those larger than a diameter D is n e^(-L D); they are spread
/// uniformly.
class Precipitation {
 public:
  /// Drops according to Marshall and Palmer (1948), with the speeds of Atlas, Srivastava and Sekhon
  /// (1973).
  /// @param rate  [mm/h], > 0
  [[nodiscard]] static Precipitation rain(double rate);

  /// Flakes according to Gunn and Marshall (1958), whose sizes are those of the drops that they
  /// melt to; aggregates of dendrites, with the widths and speeds of Locatelli and Hobbs (1974).
  /// @param rate  of melted snow [mm/h], > 0
  [[nodiscard]] static Precipitation snow(double rate);

  /// The drops in a cube of the global frame, the largest first. A smaller `least` gives the same
  /// ones and more.
  /// @param cell  the cube's corner with the smallest coordinates [m]; its sides are 1 m long
  /// @param least  the diameter of the smallest [m]
  /// @param seed  the same seed gives the same drops in a cell
  [[nodiscard]] std::vector<Drop> in(const Eigen::Vector3i& cell, double least,
                                     std::uint64_t seed) const;

  /// The share of the area inside its outline that hides what is behind it, 0 .. 1: a flake has
  /// gaps (Mitchell 1996, aggregates of side planes, columns and bullets).
  [[nodiscard]] double opacityOf(double diameter) const;

  /// How fast a drop or flake of this diameter [m] falls in still air [m/s].
  [[nodiscard]] double speedOf(double diameter) const;

 private:
  enum class Kind { kRain, kSnow };

  Precipitation(Kind kind, double number, double slope)
      : kind_(kind), number_(number), slope_(slope) {}

  [[nodiscard]] double diameterOf(double water) const;
  [[nodiscard]] double waterOf(double diameter) const;

  Kind kind_;
  double number_;  ///< of all sizes together, n [1/m^3]
  double slope_;   ///< L [1/mm]
};

}  // namespace synthetic_dataset::render
