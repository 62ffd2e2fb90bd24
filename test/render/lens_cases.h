#pragma once

/// Lenses to test with, and helpers that their tests share.

#include <cstdlib>
#include <ostream>
#include <string>

#include <opencv2/imgcodecs.hpp>

#include "synthetic_dataset/camera_model.h"
#include "world/description.h"

namespace synthetic_dataset::test {

[[nodiscard]] inline world::Material coloured(float red, float green, float blue) {
  world::Material material;
  material.diffuse = {red, green, blue, 1.0F};
  material.specular = {0.0F, 0.0F, 0.0F};
  return material;
}

/// A world with ambient light only and a black background.
[[nodiscard]] inline world::Description dark() {
  world::Description description;
  description.simulator = world::Simulator::kGz;
  description.ambient = {1.0F, 1.0F, 1.0F};
  description.background = {0.0F, 0.0F, 0.0F};
  return description;
}

struct LensCase {
  const char* name;
  CameraModel camera;
};

inline void PrintTo(const LensCase& lens, std::ostream* stream) { *stream << lens.name; }

inline const LensCase kPlumbBob{"plumb_bob",
                                {640,
                                 480,
                                 {420.4, 418.1, 321.7, 238.2},
                                 0.05,
                                 100.0,
                                 {DistortionModel::kPlumbBob, {-0.28, 0.09, 1e-3, -8e-4, -0.01}}}};
inline const LensCase kRational{
    "rational",
    {640,
     480,
     {352.4, 350.1, 318.7, 242.2},
     0.05,
     100.0,
     {DistortionModel::kRationalPolynomial, {0.3, 0.05, 5e-4, -3e-4, 0.01, 0.6, 0.1, 0.02}}}};
inline const LensCase kFisheye170{"fisheye_170",
                                  {640,
                                   480,
                                   {215.4, 214.9, 319.1, 240.4},
                                   0.05,
                                   100.0,
                                   {DistortionModel::kEquidistant, {0.02, -0.008, 0.003, -5e-4}}}};
inline const LensCase kFisheye190{"fisheye_190",
                                  {600,
                                   600,
                                   {180.3, 180.7, 299.1, 300.4},
                                   0.05,
                                   100.0,
                                   {DistortionModel::kEquidistant, {-0.01, 0.003}, 1.6581}}};

inline const LensCase kTiltedPrism{
    "tilted_prism",
    {640,
     480,
     {352.4, 350.1, 318.7, 242.2},
     0.05,
     100.0,
     {DistortionModel::kRationalPolynomial,
      {0.2, 0.05, 5e-4, -3e-4, 0.01, 0.5, 0.1, 0.02, 4e-3, -2e-3, -3e-3, 1e-3, 0.03, -0.05}}}};
inline const LensCase kOmnidirectional{
    "omnidirectional",
    {600,
     480,
     {420.3, 421.7, 301.1, 238.4},
     0.05,
     100.0,
     {DistortionModel::kOmnidirectional, {1.1, -0.12, 0.03, 1e-3, -8e-4, 4e-3}}}};
inline const LensCase kDoubleSphere{"double_sphere",
                                    {600,
                                     480,
                                     {165.3, 165.7, 299.1, 240.4},
                                     0.05,
                                     100.0,
                                     {DistortionModel::kDoubleSphere, {-0.21, 0.58}}}};

/// Saves a picture for inspection if the environment names a folder for it.
inline void keep(const cv::Mat& picture, const std::string& name) {
  const char* folder = std::getenv("SYNTHETIC_DATASET_KEEP_PICTURES");
  if (folder != nullptr) cv::imwrite(std::string(folder) + "/" + name + ".png", picture);
}

}  // namespace synthetic_dataset::test
