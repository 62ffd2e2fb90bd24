#include "render/light/environment_response.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace synthetic_dataset::render {
namespace {

constexpr int kPoints = 32;  // along either side of the table
constexpr float kNaturalOfTwo = 0.693147181F;

/// What is reflected of white surroundings: by a surface that reflects nothing at normal incidence,
/// and how much more by one that reflects everything.
struct Mirrored {
  float of_none;
  float of_all;
};

/// Indexed by roughness from 0 to 1, then by the cosine of the angle to the eye from 0 to 1.
using MirroredTable = std::array<std::array<Mirrored, kPoints>, kPoints>;

/// The mean over halfway vectors that are distributed according to GGX (Karis 2013).
Mirrored integrated(double roughness, double n_dot_v) {
  constexpr int kCount = 24;
  const double alpha = std::max(roughness * roughness, 1e-4);
  const double n_cross_v = std::sqrt(1.0 - n_dot_v * n_dot_v);
  double none = 0.0;
  double all = 0.0;
  for (int i = 0; i < kCount; ++i) {
    const double share = (i + 0.5) / kCount;
    const double angle = std::atan(alpha * std::sqrt(share / (1.0 - share)));
    for (int k = 0; k < kCount; ++k) {
      const double around = M_PI * (k + 0.5) / kCount;  // the other half is symmetric
      const double n_dot_h = std::cos(angle);
      const double v_dot_h = n_cross_v * std::sin(angle) * std::cos(around) + n_dot_v * n_dot_h;
      const double n_dot_l = 2.0 * v_dot_h * n_dot_h - n_dot_v;
      if (v_dot_h <= 0.0 || n_dot_l <= 0.0) continue;
      // SurfaceShading's visibility (Hammon 2017), times 4.
      const double mixed = (1.0 - alpha) * 2.0 * n_dot_l * n_dot_v + alpha * (n_dot_l + n_dot_v);
      const double weight = 2.0 / mixed * n_dot_l * v_dot_h / n_dot_h;
      const double fresnel = std::pow(1.0 - v_dot_h, 5.0);
      none += weight * fresnel;
      all += weight * (1.0 - fresnel);
    }
  }
  constexpr double kEach = 1.0 / (kCount * kCount);
  return {static_cast<float>(none * kEach), static_cast<float>(all * kEach)};
}

MirroredTable makeTable() {
  MirroredTable table{};
  for (int row = 0; row < kPoints; ++row) {
    for (int column = 0; column < kPoints; ++column) {
      table[static_cast<std::size_t>(row)][static_cast<std::size_t>(column)] =
          integrated(row / (kPoints - 1.0), std::max(column / (kPoints - 1.0), 1e-3));
    }
  }
  return table;
}

Mirrored between(const Mirrored& a, const Mirrored& b, float share) {
  return {a.of_none + share * (b.of_none - a.of_none), a.of_all + share * (b.of_all - a.of_all)};
}

Mirrored lookedUp(const MirroredTable& table, float roughness, float n_dot_v) {
  const float row = std::clamp(roughness, 0.0F, 1.0F) * (kPoints - 1);
  const float column = std::clamp(n_dot_v, 0.0F, 1.0F) * (kPoints - 1);
  const auto v = static_cast<std::size_t>(std::min(row, kPoints - 2.0F));
  const auto u = static_cast<std::size_t>(std::min(column, kPoints - 2.0F));
  const float across = column - static_cast<float>(u);
  return between(between(table[v][u], table[v][u + 1], across),
                 between(table[v + 1][u], table[v + 1][u + 1], across),
                 row - static_cast<float>(v));
}

}  // namespace

Lanes3 mirroredShare(const Lanes3& f0, const Lanes& roughness, const Lanes& n_dot_v) {
  static const MirroredTable kTable = makeTable();
  std::array<float, kLaneCount> rough{};
  std::array<float, kLaneCount> cosine{};
  cv::v_store(rough.data(), roughness);
  cv::v_store(cosine.data(), n_dot_v);
  std::array<float, kLaneCount> none{};
  std::array<float, kLaneCount> all{};
  for (std::size_t i = 0; i < kLaneCount; ++i) {
    const Mirrored found = lookedUp(kTable, rough[i], cosine[i]);
    none[i] = found.of_none;
    all[i] = found.of_all;
  }
  const Lanes of_none = cv::v_load(none.data());
  const Lanes of_all = cv::v_load(all.data());
  return {of_none + f0.x * of_all, of_none + f0.y * of_all, of_none + f0.z * of_all};
}

Lanes3 mirroredDirection(const Lanes3& normal, const Lanes3& to_eye, const Lanes& roughness) {
  const Lanes smooth = lanes(1.0F) - roughness;
  const Lanes share = smooth * (cv::v_sqrt(smooth) + roughness);
  const Lanes3 mirror = normal * (lanes(2.0F) * dot(normal, to_eye)) - to_eye;
  return normalized(mix(normal, mirror, share));
}

Lanes mirroredOpenness(const Lanes& open, const Lanes& roughness, const Lanes& n_dot_v) {
  const Lanes one = lanes(1.0F);
  if (cv::v_check_all(open == one)) return one;
  const Lanes exponent = exponential(lanes(kNaturalOfTwo) * (lanes(-16.0F) * roughness - one));
  return clamped(power(n_dot_v + open, exponent) - one + open, 0.0F, 1.0F);
}

}  // namespace synthetic_dataset::render
