#pragma once

#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "render/light/environment_light.h"
#include "render/overlay/sky_painter.h"
#include "world/description.h"
#include "world/look.h"

namespace synthetic_dataset::render {

/// Finds the light of what is seen behind the world: of a panorama, else of the sky. Whatever is
/// expensive to compute is kept for when the same background is used again.
class Environment {
 public:
  Environment(const GlFunctions& gl, const world::Description& description);

  /// Sets what is behind the world from now on.
  void setLook(const world::Look& look);

  /// The background's light; null if it is neither a panorama nor the sky. May draw with OpenGL.
  [[nodiscard]] std::shared_ptr<const EnvironmentLight> light();

 private:
  struct KnownPicture {
    std::weak_ptr<const world::Texture> picture;
    std::shared_ptr<const PanoramaLight> light;
  };

  [[nodiscard]] std::shared_ptr<const EnvironmentLight> lightOfPicture();
  [[nodiscard]] std::shared_ptr<const EnvironmentLight> lightOfSky();
  void forgetOldest();

  const GlFunctions& gl_;
  world::Simulator simulator_;
  std::optional<world::Sky> sky_;
  Eigen::Vector3f ambient_;  ///< sRGB-encoded
  std::vector<world::Light> lights_;
  std::optional<world::BackgroundPicture> picture_;
  std::shared_ptr<const EnvironmentLight> light_;  ///< of the members above, once requested

  std::list<KnownPicture> known_pictures_;  ///< the most recently used first
  std::optional<SkyPanorama> sky_panorama_;
  Eigen::Vector3d known_sun_{0.0, 0.0, 0.0};
  std::shared_ptr<const PanoramaLight> known_sky_;  ///< with known_sun_
};

}  // namespace synthetic_dataset::render
