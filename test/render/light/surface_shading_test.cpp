/// Light in lanes, against the same formulas in double precision.

#include "render/light/surface_shading.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace surface_shading_test {

using Eigen::Vector3d;

constexpr double kPi = 3.14159265358979;

struct Point {
  Vector3d position, normal, base, glow;
  double reflectance, roughness, metalness;
  bool is_lit = true;
};

Vector3d fresnel(const Vector3d& f0, double cosine) {
  return f0 + (Vector3d::Ones() - f0) * std::pow(1.0 - cosine, 5.0);
}

Vector3d sent(const LightInView& light, const Point& p, const Vector3d& to_eye) {
  Vector3d to_light = -light.direction_C.cast<double>();
  Vector3d arriving = light.intensity.cast<double>();
  if (light.type != world::LightType::kDirectional) {
    const Vector3d way = light.position_C.cast<double>() - p.position;
    const double d = way.norm();
    to_light = way / d;
    const Vector3d fading = light.attenuation.cast<double>();
    arriving *= d > light.range ? 0.0 : 1.0 / (fading[0] + fading[1] * d + fading[2] * d * d);
    if (light.type == world::LightType::kSpot) {
      const double cosine = -to_light.dot(light.direction_C.cast<double>());
      const double inside = (cosine - light.cone[1]) / double{light.cone[0] - light.cone[1]};
      arriving *= std::pow(std::clamp(inside, 0.0, 1.0), double{light.cone[2]});
    }
  }
  const double n_dot_l = p.normal.dot(to_light);
  if (n_dot_l <= 0.0) return Vector3d::Zero();
  const double n_dot_v = std::max(p.normal.dot(to_eye), 1e-3);
  const Vector3d halfway = (to_light + to_eye).normalized();
  const double n_dot_h = std::max(p.normal.dot(halfway), 0.0);
  const Vector3d f0 =
      Vector3d::Constant(p.reflectance) * (1.0 - p.metalness) + p.base * p.metalness;
  const double alpha = std::max(p.roughness * p.roughness, 0.01);
  const double bell = n_dot_h * n_dot_h * (alpha * alpha - 1.0) + 1.0;
  const double distribution = alpha * alpha / (kPi * bell * bell);
  const double mixed = (1.0 - alpha) * 2.0 * n_dot_l * n_dot_v + alpha * (n_dot_l + n_dot_v);
  const Vector3d specular =
      kPi * distribution * 0.5 / mixed * fresnel(f0, std::max(to_eye.dot(halfway), 0.0));
  return arriving.cwiseProduct(p.base * (1.0 - p.metalness) + specular) * n_dot_l;
}

Vector3d seen(const LightingContext& all, const Point& p) {
  const Vector3d to_eye = -p.position.normalized();
  const double n_dot_v = std::max(p.normal.dot(to_eye), 1e-3);
  const Vector3d f0 =
      Vector3d::Constant(p.reflectance) * (1.0 - p.metalness) + p.base * p.metalness;
  const double sky = 0.5 + 0.5 * p.normal.dot(all.up_C.cast<double>());
  const Vector3d around = all.ambient.cast<double>() * (0.55 + 0.45 * sky);
  const Vector3d matte = p.base * (1.0 - p.metalness);
  Vector3d sum =
      around.cwiseProduct(matte + fresnel(f0, n_dot_v) * (1.0 - 0.6 * p.roughness)) + p.glow;
  for (const LightInView& light : all.lights) sum += sent(light, p, to_eye);
  sum = (all.exposure * sum).unaryExpr([](double x) {
    return x > 0.8 ? 1.0 - 0.2 * std::exp((0.8 - x) / 0.2) : x;
  });
  if (!p.is_lit) sum = all.exposure * p.base;
  if (all.fog) {
    const double d = p.position.norm();
    const double thickness = all.fog->density * d;
    const double clear =
        all.fog->type == world::FogType::kLinear
            ? std::clamp((all.fog->end - d) / (all.fog->end - all.fog->start), 0.0, 1.0)
        : all.fog->type == world::FogType::kExponential ? std::exp(-thickness)
                                                        : std::exp(-thickness * thickness);
    const Eigen::Vector3f colour = linearFromSrgb(all.fog->colour);
    sum = clear * sum + (1.0 - clear) * all.exposure * colour.cast<double>();
  }
  return sum.cwiseMin(1.0);
}

class SurfaceLight : public testing::Test {
 protected:
  double number(double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random_);
  }
  Vector3d vector(double low, double high) {
    return {number(low, high), number(low, high), number(low, high)};
  }

  LightInView light(world::LightType type) {
    return {type,
            vector(-3.0, 3.0).cast<float>(),
            vector(-1.0, 1.0).normalized().cast<float>(),
            vector(0.1, 1.0).cast<float>(),
            vector(0.1, 1.0).cast<float>(),
            {1.0F, 0.2F, 0.05F},
            5.0F,
            {0.95F, 0.5F, 1.7F}};
  }

  Point point() {
    const Vector3d position(number(-2, 2), number(-2, 2), number(0.5, 6));
    return {position,         vector(-1, 1).normalized(), vector(0, 1),
            vector(0, 0.1),   number(0.0, 0.16),          number(0.05, 1.0),
            number(0.0, 1.0), number(0.0, 1.0) < 0.9};
  }

  void expectSame(const LightingContext& all) {
    const SurfaceShading shading(all);
    for (int i = 0; i < 500; ++i) {
      const Point p = point();
      const Eigen::Vector3f normal = p.normal.cast<float>();
      const Lanes3 result = shading.seen(
          {lanes(Eigen::Vector3f(p.position.cast<float>())), lanes(normal), lanes(normal),
           lanes(Eigen::Vector3f(p.base.cast<float>())), lanes(static_cast<float>(p.reflectance)),
           lanes(static_cast<float>(p.roughness)), lanes(static_cast<float>(p.metalness)),
           lanes(Eigen::Vector3f(p.glow.cast<float>())), lanes(1.0F),
           p.is_lit ? lanes(0.0F) >= lanes(0.0F) : lanes(0.0F)},
          shading.lights().all());
      const Vector3d found(result.x.get0(), result.y.get0(), result.z.get0());
      EXPECT_LT((found - seen(all, p)).cwiseAbs().maxCoeff(), 2e-4) << i;
    }
  }

  LightingContext plain() {
    return {{},   {},           {0.3F, 0.4F, 0.5F},   {0.0F, -1.0F, 0.0F},
            0.9F, std::nullopt, world::Simulator::kGz};
  }

  void add(LightingContext& all, world::LightType type) {
    all.lights.push_back(light(type));
    all.shadows.emplace_back();
  }

 private:
  std::mt19937 random_{8};
};

TEST_F(SurfaceLight, OfEachKindIsThatOfTheFormulas) {
  for (const auto type :
       {world::LightType::kDirectional, world::LightType::kPoint, world::LightType::kSpot}) {
    for (int i = 0; i < 5; ++i) {
      LightingContext all = plain();
      add(all, type);
      add(all, type);
      expectSame(all);
    }
  }
}

TEST_F(SurfaceLight, IsAmbientWithoutLights) { expectSame(plain()); }

/// The formulas have a pole where light comes through a surface from straight behind it.
TEST_F(SurfaceLight, FromBehindIsNone) {
  LightingContext all = plain();
  add(all, world::LightType::kDirectional);
  all.lights[0].direction_C = {0.0F, 0.0F, -1.0F};  // into the camera
  const SurfaceShading shading(all);
  LightingContext dark = plain();
  const SurfaceShading without(dark);
  // The second surface faces the light, so that all four lanes are computed.
  const SurfaceLanes surfaces{lanes(0.0F, 0.0F, 2.0F),
                              {lanes(0.0F), lanes(0.0F), Lanes(-1.0F, 1.0F, -1.0F, -1.0F)},
                              {lanes(0.0F), lanes(0.0F), Lanes(-1.0F, 1.0F, -1.0F, -1.0F)},
                              lanes(0.5F, 0.5F, 0.5F),
                              lanes(0.04F),
                              lanes(1.0F),
                              lanes(0.0F),
                              lanes(0.0F, 0.0F, 0.0F),
                              lanes(1.0F),
                              lanes(0.0F) >= lanes(0.0F)};
  EXPECT_EQ(shading.seen(surfaces, shading.lights().all()).x.get0(),
            without.seen(surfaces, {}).x.get0());
}

TEST_F(SurfaceLight, FadesInFog) {
  for (const auto type : {world::FogType::kLinear, world::FogType::kExponential,
                          world::FogType::kSquaredExponential}) {
    LightingContext all = plain();
    add(all, world::LightType::kDirectional);
    all.fog = world::Fog{type, {0.8F, 0.7F, 0.6F}, 1.0, 5.0, 0.3};
    expectSame(all);
  }
}

/// The share of a square of 3 x 3 texels around a place that holds nothing nearer to the light.
double passingAt(const cv::Mat& depths, double column, double row, float depth) {
  double sum = 0.0;
  for (int v = -3; v < depths.rows + 3; ++v) {
    for (int u = -3; u < depths.cols + 3; ++u) {
      const auto overlap = [](double middle, int texel) {
        return std::max(
            0.0, std::min(middle + 1.5, texel + 1.0) - std::max(middle - 1.5, double(texel)));
      };
      const float there =
          depths.at<float>(std::clamp(v, 0, depths.rows - 1), std::clamp(u, 0, depths.cols - 1));
      if (depth <= there) sum += overlap(column, u) * overlap(row, v);
    }
  }
  return sum / 9.0;
}

TEST(ShadowLookup, IsTheMeanOfTheTexelsRoundAPlace) {
  constexpr int kSize = 12;
  cv::Mat depths(kSize, kSize, CV_32FC1);
  cv::theRNG().state = 6;
  cv::randu(depths, 0.0F, 1.0F);
  // Maps metres to clip coordinates; with texels of size 0, no point is raised.
  Eigen::Matrix4d shadow_from_camera = Eigen::Matrix4d::Identity();
  const CastShadow shadow{MapDepths(std::make_shared<MapDepths::Standing>(depths)),
                          shadow_from_camera, 0.0, Eigen::Vector2d::Zero()};
  const MapDepths::Assembled assembled = shadow.map.assemble();
  const ShadowLookup lookup(shadow, assembled, false);
  std::mt19937 random(2);
  std::uniform_real_distribution<float> place(-1.0F, 1.0F);
  const Lanes all = lanes(0.0F) >= lanes(0.0F);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3f at(place(random), place(random), 0.5F + 0.5F * place(random));
    const Lanes passing =
        lookup.passing(lanes(at), lanes(0.0F, 0.0F, 1.0F), lanes(1.0F), lanes(0.0F), all);
    const double half = 0.5 * kSize;
    EXPECT_NEAR(passing.get0(),
                passingAt(depths, half * at.x() + half, half * at.y() + half, at.z()), 1e-5);
  }
  for (const float beside : {-1.01F, 1.01F}) {
    const Lanes passing = lookup.passing(lanes(beside, 0.0F, 0.9F), lanes(0.0F, 0.0F, 1.0F),
                                         lanes(1.0F), lanes(0.0F), all);
    EXPECT_EQ(passing.get0(), 1.0F) << "nothing is in the shadow of what is beside the map";
  }
}

}  // namespace surface_shading_test
}  // namespace synthetic_dataset::render
