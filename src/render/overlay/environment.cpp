#include "render/overlay/environment.h"

#include <algorithm>
#include <utility>

#include "render/light/surface_shading.h"
#include "render/overlay/sky_painter.h"
#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// The luminance of linear light (ITU-R BT.709).
float luminance(const Eigen::Vector3f& light) {
  return light.dot(Eigen::Vector3f(0.2126F, 0.7152F, 0.0722F));
}

/// The factors that make arriving light as bright as another colour.
Eigen::Vector3f levelFor(const Eigen::Vector3f& wanted, const Eigen::Vector3f& arriving) {
  return wanted / std::max(luminance(arriving), 1e-6F);
}

}  // namespace

Environment::Environment(const GlFunctions& gl, const world::Description& description)
    : gl_(gl),
      simulator_(description.simulator),
      sky_(description.sky),
      ambient_(description.ambient),
      lights_(description.lights) {}

void Environment::setLook(const world::Look& look) {
  ambient_ = look.ambient;
  lights_ = look.lights;
  picture_ = look.background_picture;
  light_ = nullptr;
}

std::shared_ptr<const EnvironmentLight> Environment::light() {
  using Projection = world::BackgroundPicture::Projection;
  if (light_ != nullptr) return light_;
  if (picture_) {
    if (picture_->projection == Projection::kPanorama) light_ = lightOfPicture();
  } else if (sky_) {
    light_ = lightOfSky();
  }
  return light_;
}

std::shared_ptr<const EnvironmentLight> Environment::lightOfPicture() {
  auto known = std::find_if(
      known_pictures_.begin(), known_pictures_.end(),
      [&](const KnownPicture& each) { return each.picture.lock() == picture_->picture; });
  if (known == known_pictures_.end()) {
    auto light = std::make_shared<PanoramaLight>(panoramaOf(*picture_->picture));
    known = known_pictures_.insert(known_pictures_.begin(), {picture_->picture, std::move(light)});
  }
  known_pictures_.splice(known_pictures_.begin(), known_pictures_, known);
  forgetOldest();
  const auto brightness = static_cast<float>(picture_->brightness);
  const Eigen::Vector3f all = Eigen::Vector3f::Constant(brightness);
  return std::make_shared<EnvironmentLight>(known_pictures_.front().light, picture_->yaw,
                                            EnvironmentLevels{all, all, brightness});
}

/// Floors and ceilings receive as much light as from the hemispheric ambient light
/// (SurfaceShading); for surfaces between them, the sky determines how it is distributed.
/// Reflections are as bright as the visible sky.
std::shared_ptr<const EnvironmentLight> Environment::lightOfSky() {
  const Eigen::Vector3d sun = sunDirection(*sky_, lights_);
  if (known_sky_ == nullptr || known_sun_ != sun) {
    if (!sky_panorama_) sky_panorama_.emplace(gl_, *sky_);
    known_sky_ = std::make_shared<PanoramaLight>(sky_panorama_->draw(sun));
    known_sun_ = sun;
  }
  // ClassicShading takes the square root of light as its encoded number.
  const Eigen::Vector3f ambient = simulator_ == world::Simulator::kClassic
                                      ? Eigen::Vector3f(ambient_.cwiseProduct(ambient_))
                                      : linearFromSrgb(ambient_);
  EnvironmentLevels levels;
  levels.above = levelFor(ambient, known_sky_->above().arriving(Eigen::Vector3f(0, 0, 1)));
  levels.below = levelFor(kAmbientFromBelow * ambient,
                          known_sky_->below().arriving(Eigen::Vector3f(0, 0, -1)));
  return std::make_shared<EnvironmentLight>(known_sky_, 0.0, levels);
}

void Environment::forgetOldest() {
  constexpr std::size_t kMemory = 256U << 20U;  // [byte]
  known_pictures_.remove_if([](const KnownPicture& each) { return each.picture.expired(); });
  std::size_t memory = 0;
  auto each = known_pictures_.begin();
  for (; each != known_pictures_.end(); ++each) {
    memory += each->light->memory();
    if (memory > kMemory && each != known_pictures_.begin()) break;
  }
  known_pictures_.erase(each, known_pictures_.end());
}

}  // namespace synthetic_dataset::render
