/// The share of a uniform environment's light that surfaces reflect, against the integral over all
/// directions.

#include "render/light/environment_response.h"

#include <cmath>

#include <gtest/gtest.h>
#include <Eigen/Core>

namespace synthetic_dataset::render {
namespace environment_response_test {

using Eigen::Vector3d;

/// The integral of the highlight of surface_shading.h over the hemisphere.
double mirroredOf(double f0, double roughness, double n_dot_v) {
  const double alpha = roughness * roughness;
  const Vector3d to_eye(std::sqrt(1.0 - n_dot_v * n_dot_v), 0.0, n_dot_v);
  constexpr int kRows = 600;
  constexpr int kColumns = 600;
  double sum = 0.0;
  for (int row = 0; row < kRows; ++row) {
    const double n_dot_l = (row + 0.5) / kRows;  // rows of equal solid angle
    const double across = std::sqrt(1.0 - n_dot_l * n_dot_l);
    for (int column = 0; column < kColumns; ++column) {
      const double around = M_PI * (column + 0.5) / kColumns;  // the other half is symmetric
      const Vector3d to_light(across * std::cos(around), across * std::sin(around), n_dot_l);
      const Vector3d halfway = (to_light + to_eye).normalized();
      const double bell = halfway.z() * halfway.z() * (alpha * alpha - 1.0) + 1.0;
      const double spread = alpha * alpha / (M_PI * bell * bell);
      const double mixed = (1.0 - alpha) * 2.0 * n_dot_l * n_dot_v + alpha * (n_dot_l + n_dot_v);
      const double off = 1.0 - to_eye.dot(halfway);
      const double fresnel = f0 + (1.0 - f0) * off * off * off * off * off;
      sum += fresnel * spread * 0.5 / mixed * n_dot_l;
    }
  }
  return 2.0 * M_PI * sum / (double{kRows} * kColumns);
}

TEST(MirroredShare, IsTheIntegralOverAllLight) {
  for (const double f0 : {0.04, 0.6, 1.0}) {
    for (const double roughness : {0.3, 0.5, 0.8, 1.0}) {
      for (const double n_dot_v : {0.1, 0.3, 0.6, 1.0}) {
        const Lanes3 share =
            mirroredShare(lanes(static_cast<float>(f0), 0.0F, 0.0F),
                          lanes(static_cast<float>(roughness)), lanes(static_cast<float>(n_dot_v)));
        EXPECT_NEAR(share.x.get0(), mirroredOf(f0, roughness, n_dot_v), 0.02)
            << f0 << " " << roughness << " " << n_dot_v;
      }
    }
  }
}

TEST(MirroredShare, OfASilverMirrorIsAll) {
  for (const float n_dot_v : {0.05F, 0.5F, 1.0F}) {
    const Lanes3 share = mirroredShare(lanes(1.0F, 1.0F, 1.0F), lanes(0.0F), lanes(n_dot_v));
    EXPECT_NEAR(share.y.get0(), 1.0F, 3e-3F);
  }
}

TEST(MirroredDirection, IsAMirrorsAndTheNormalOfChalk) {
  const Lanes3 normal = lanes(0.0F, 0.0F, 1.0F);
  const Lanes3 to_eye = lanes(0.6F, 0.0F, 0.8F);
  const Lanes3 mirror = mirroredDirection(normal, to_eye, lanes(0.0F));
  EXPECT_NEAR(mirror.x.get0(), -0.6F, 1e-6F);
  EXPECT_NEAR(mirror.z.get0(), 0.8F, 1e-6F);
  const Lanes3 chalk = mirroredDirection(normal, to_eye, lanes(1.0F));
  EXPECT_NEAR(chalk.x.get0(), 0.0F, 1e-6F);
}

TEST(MirroredOpenness, IsAllInTheOpenAndLittleInACorner) {
  const auto at = [](float open, float roughness, float n_dot_v) {
    return mirroredOpenness(lanes(open), lanes(roughness), lanes(n_dot_v)).get0();
  };
  EXPECT_EQ(at(1.0F, 0.5F, 0.3F), 1.0F);
  EXPECT_NEAR(at(0.0F, 0.5F, 0.3F), 0.0F, 0.02F);
  // Looked at head-on, a mirror in a hole shows what is above the hole.
  EXPECT_GT(at(0.5F, 0.05F, 1.0F), 0.6F);
  EXPECT_LT(at(0.5F, 0.05F, 0.1F), 0.5F);
}

}  // namespace environment_response_test
}  // namespace synthetic_dataset::render
