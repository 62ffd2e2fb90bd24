/// Gazebo Classic's light in lanes, against OGRE's formulas in double precision.

#include "render/light/classic_shading.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <gtest/gtest.h>

namespace synthetic_dataset::render {
namespace classic_shading_test {

using Eigen::Vector3d;

struct Point {
  Vector3d position, normal, picture, around, diffuse, specular;
  double shininess;
};

/// SGX_Light_Point_DiffuseSpecular and its variants in OGRE 1.9's SGXLib_PerPixelLighting.glsl.
void addLight(const LightInView& light, const Point& p, Vector3d& diffuse, Vector3d& specular) {
  Vector3d to_light = -light.direction_C.cast<double>();
  double share = 1.0;
  if (light.type != world::LightType::kDirectional) {
    const Vector3d way = light.position_C.cast<double>() - p.position;
    const double d = way.norm();
    to_light = way / d;
    if (d > light.range) return;
    const Vector3d fading = light.attenuation.cast<double>();
    share = 1.0 / (fading[0] + fading[1] * d + fading[2] * d * d);
  }
  if (light.type == world::LightType::kSpot) {
    const double rho = -to_light.dot(light.direction_C.cast<double>());
    const double inside = (rho - light.cone[1]) / double{light.cone[0] - light.cone[1]};
    share *= std::pow(std::clamp(inside, 0.0, 1.0), double{light.cone[2]});
  }
  const double n_dot_l = p.normal.dot(to_light);
  if (n_dot_l <= 0.0) return;
  diffuse += p.diffuse.cwiseProduct(light.intensity.cast<double>()) * n_dot_l * share;
  if (p.shininess <= 0.0) return;
  const Vector3d halfway = (to_light - p.position.normalized()).normalized();
  const double n_dot_h = std::clamp(p.normal.dot(halfway), 0.0, 1.0);
  specular += p.specular.cwiseProduct(light.specular.cast<double>()) *
              std::pow(n_dot_h, p.shininess) * share;
}

Vector3d seen(const LightingContext& all, const Point& p) {
  Vector3d diffuse = p.around;
  Vector3d specular = Vector3d::Zero();
  for (const LightInView& light : all.lights) addLight(light, p, diffuse, specular);
  return (diffuse.cwiseProduct(p.picture) + specular).cwiseMin(1.0);
}

class ClassicLight : public testing::Test {
 protected:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d vector(double low, double high) {
    return {number(low, high), number(low, high), number(low, high)};
  }
  Eigen::Vector3f colour() { return vector(0, 1).cast<float>(); }

  void add(LightingContext& all, world::LightType type) {
    all.lights.push_back({type,
                          vector(-3.0, 3.0).cast<float>(),
                          vector(-1.0, 1.0).normalized().cast<float>(),
                          colour(),
                          colour(),
                          {0.5F, 0.2F, 0.05F},
                          5.0F,
                          {0.95F, 0.5F, 1.7F}});
    all.shadows.emplace_back();
  }

  Point point() {
    const Vector3d position(number(-2, 2), number(-2, 2), number(0.5, 6));
    const double shininess = number(0, 1) < 0.3 ? 0.0 : number(0.5, 128);
    return {position,     vector(-1, 1).normalized(),
            vector(0, 1), vector(0, 0.5),
            vector(0, 1), vector(0, 1),
            shininess};
  }

 private:
  std::mt19937 random_{8};
};

ClassicLanes lanesOf(const Point& p) {
  const auto all = [](const Vector3d& v) { return lanes(Eigen::Vector3f(v.cast<float>())); };
  return {all(p.position),         all(p.normal),
          all(p.normal),           all(p.picture),
          all(p.around),           lanes(1.0F),
          lanes(0.0F, 0.0F, 0.0F), all(p.diffuse),
          all(p.specular),         lanes(static_cast<float>(p.shininess)),
          lanes(0.0F, 0.0F, 0.0F)};
}

LightingContext context() {
  return {{}, {}, {1, 1, 1}, {0, -1, 0}, 1.0F, std::nullopt, world::Simulator::kClassic};
}

Vector3d found(const ClassicShading& shading, const Point& p) {
  const Lanes3 result = shading.seen(lanesOf(p), shading.lights().all());
  return {result.x.get0(), result.y.get0(), result.z.get0()};
}

TEST_F(ClassicLight, OfEachKindIsThatOfOgresFormulas) {
  for (const auto type :
       {world::LightType::kDirectional, world::LightType::kPoint, world::LightType::kSpot}) {
    for (int i = 0; i < 5; ++i) {
      LightingContext all = context();
      add(all, type);
      add(all, type);
      const ClassicShading shading(all);
      for (int k = 0; k < 300; ++k) {
        const Point p = point();
        EXPECT_LT((found(shading, p) - seen(all, p)).cwiseAbs().maxCoeff(), 2e-4);
      }
    }
  }
}

TEST_F(ClassicLight, IsMixedWithTheFogsColourAsItIsEncoded) {
  LightingContext all = context();
  add(all, world::LightType::kDirectional);
  const Point p = point();
  const Vector3d clear = found(ClassicShading(all), p);
  all.fog = world::Fog{world::FogType::kExponential, {0.8F, 0.6F, 0.4F}, 1.0, 5.0, 0.3};
  const double passes = std::exp(-0.3 * p.position.norm());
  const Vector3d wanted = passes * clear + (1.0 - passes) * Vector3d(0.8, 0.6, 0.4);
  EXPECT_LT((found(ClassicShading(all), p) - wanted).cwiseAbs().maxCoeff(), 1e-5);
}

TEST_F(ClassicLight, BeyondWhiteIsKeptWhereTheExposureIsShort) {
  LightingContext all = context();
  Point p = point();
  p.around = {1.5, 0.5, 3.0};
  p.picture.setOnes();
  EXPECT_EQ(found(ClassicShading(all), p), Vector3d(1.0, 0.5, 1.0));
  all.exposure = 0.3F;
  EXPECT_EQ(found(ClassicShading(all), p).x(), 1.5);
}

}  // namespace classic_shading_test
}  // namespace synthetic_dataset::render
