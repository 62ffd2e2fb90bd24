#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

/// A picture that is seen where no surface is.
struct BackgroundPicture {
  /// A backdrop fills the image. A panorama surrounds the world: it is equirectangular, with its
  /// upper edge at +z and its centre along +x; columns to the right of the centre turn towards -y.
  enum class Projection { kBackdrop, kPanorama };

  std::shared_ptr<const Texture> picture;
  Projection projection = Projection::kBackdrop;
  double yaw = 0.0;         ///< rotation of a panorama about z, from x towards y [rad]
  double brightness = 1.0;  ///< factor on its light
};

/// How a world is lit and painted for a while: the part of its description that may differ from
/// scene to scene while its models stay the same.
struct Look {
  explicit Look(const Description& description)
      : lights(description.lights),
        ambient(description.ambient),
        background(description.background) {}

  std::vector<Light> lights;   ///< the same number, types and order as in the description
  Eigen::Vector3f ambient;     ///< sRGB-encoded
  Eigen::Vector3f background;  ///< sRGB-encoded

  /// Replaces the background colour and the sky. With full light, a panorama also replaces the
  /// ambient light.
  std::optional<BackgroundPicture> background_picture;

  /// Materials that replace the surfaces' original ones. Each is as transparent as the one it
  /// replaces, double-sided and lit if that one is, and has a normal or an emissive map only if
  /// that one has one.
  std::map<const Material*, Material> materials;
};

}  // namespace synthetic_dataset::world
