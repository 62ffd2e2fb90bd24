#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "world/description.h"

namespace synthetic_dataset::world {

/// A picture that is seen where nothing is.
struct BackgroundPicture {
  /// A picture fills the image, or lies around the world: then it is equirectangular, its upper
  /// edge at +z and its middle along x, from which the columns to its right turn towards -y.
  enum class Projection { kBackdrop, kPanorama };

  std::shared_ptr<const Texture> picture;
  Projection projection = Projection::kBackdrop;
  double yaw = 0.0;         ///< of a panorama: it is turned about z, from x to y [rad]
  double brightness = 1.0;  ///< times its light
};

/// How a world is lit and painted for a while: what of its description may differ from scene to
/// scene while its things stay the same.
struct Look {
  explicit Look(const Description& description)
      : lights(description.lights),
        ambient(description.ambient),
        background(description.background) {}

  std::vector<Light> lights;   ///< as many as the description has, of the same types, in its order
  Eigen::Vector3f ambient;     ///< sRGB-encoded
  Eigen::Vector3f background;  ///< sRGB-encoded

  /// In place of the background's colour, and of the sky. With full light a panorama is also in
  /// place of the ambient light.
  std::optional<BackgroundPicture> background_picture;

  /// The materials of surfaces instead of those that they were made with. Each is as transparent
  /// as what it replaces, double-sided and lit if that is, and has a normal or an emissive map only
  /// if that has one.
  std::map<const Material*, Material> materials;
};

}  // namespace synthetic_dataset::world
