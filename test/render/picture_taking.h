#pragma once

#include <memory>

#include "render/renderer.h"
#include "support/box_world.h"

namespace synthetic_dataset::test {

/// A small camera at the origin of the world that looks along +z; the pixel (32, 24) is its middle.
inline const CameraModel kSmallCamera(65, 49, {60.0, 60.0, 32.0, 24.0}, 0.05, 100.0);

/// A square of two triangles at depth `z` that faces the camera: +x is right, +y down. The texture
/// coordinates u and v go from 0 to 1 rightwards and downwards.
[[nodiscard]] inline std::shared_ptr<world::Mesh> screen(float half_width, float z) {
  auto mesh = std::make_shared<world::Mesh>();
  for (const auto& [u, v] : {std::pair{0.0F, 0.0F}, {0.0F, 1.0F}, {1.0F, 1.0F}, {1.0F, 0.0F}}) {
    mesh->positions.emplace_back((2 * u - 1) * half_width, (2 * v - 1) * half_width, z);
    mesh->normals.emplace_back(0.0F, 0.0F, -1.0F);
    mesh->texture_coordinates.emplace_back(u, v);
  }
  mesh->indices = {0, 1, 2, 0, 2, 3};
  return mesh;
}

/// A picture of one colour: blue, green, red, alpha.
[[nodiscard]] inline std::shared_ptr<world::Texture> plainTexture(const cv::Scalar& pixel) {
  auto texture = std::make_shared<world::Texture>();
  texture->pixels = cv::Mat(8, 8, CV_8UC4, pixel);
  return texture;
}

/// A picture whose left half has one colour and whose right half another.
[[nodiscard]] inline std::shared_ptr<world::Texture> halvedTexture(const cv::Scalar& left,
                                                                   const cv::Scalar& right) {
  auto texture = plainTexture(right);
  texture->pixels.create(64, 64, CV_8UC4);
  texture->pixels.setTo(right);
  texture->pixels(cv::Rect(0, 0, 32, 64)).setTo(left);
  return texture;
}

/// One picture from the origin, each pixel sampled at its centre.
[[nodiscard]] inline cv::Mat takePicture(const world::Description& description, const Stage& stage,
                                         const Pose& X_WC = Pose::Identity(),
                                         const CameraModel& camera = kSmallCamera) {
  render::Renderer renderer(description, stage.links(), {});
  return renderer.colour({camera, X_WC}, stage.poses(),
                         {stage.all(), stage.all(), render::Sampling::kCentre});
}

}  // namespace synthetic_dataset::test
