#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <Eigen/Core>

namespace synthetic_dataset::randomize {

/// A paint of a model: colours of one hue, from shadows to highlights. Colours in this file are
/// sRGB-encoded red, green, blue, 0 to 1.
struct Paint {
  Eigen::Vector3f colour{0.0F, 0.0F, 0.0F};  ///< the mean
  double share = 0.0;                        ///< of the model's surface
};

[[nodiscard]] inline float lightnessOf(const Eigen::Vector3f& colour) {
  return 0.3F * colour[0] + 0.59F * colour[1] + 0.11F * colour[2];
}

/// How much of each colour a model shows.
class ColourCount {
 public:
  ColourCount() : cells_(kSide * kSide * kSide) {}

  void add(const Eigen::Vector3f& colour, double amount);

 private:
  friend class PaintPalette;
  static constexpr std::size_t kSide = 16;
  struct Cell {
    Eigen::Vector3d sum{0.0, 0.0, 0.0};
    double amount = 0.0;
  };
  std::vector<Cell> cells_;
};

/// The paints of a model.
class PaintPalette {
 public:
  explicit PaintPalette(const ColourCount& count);

  /// The most common first; at least one.
  [[nodiscard]] const std::vector<Paint>& paints() const { return paints_; }

  /// The two paints that a colour is most like, and the share of the second: up to a half.
  struct Likeness {
    std::size_t first = 0;
    std::size_t second = 0;
    float share = 0.0F;
  };
  [[nodiscard]] Likeness likeness(const Eigen::Vector3f& colour) const;

 private:
  void merge(const ColourCount& count);

  std::vector<Paint> paints_;
  std::vector<Eigen::Vector3f> features_;  ///< one per paint: what distinguishes paints
};

}  // namespace synthetic_dataset::randomize
