#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "render/renderer.h"
#include "render/weather/through_weather.h"
#include "scene/camera_poses.h"
#include "scene/camera_rig.h"
#include "scene/exposure.h"
#include "scene/shutter.h"
#include "synthetic_dataset/scene.h"
#include "world/world.h"

namespace synthetic_dataset::scene {

/// Takes the cameras' pictures as their sensors would: over the time that their shutters are open,
/// and with the effects of lens and sensor.
///
/// For each instant: move the world to each of `offsets` from the instant and `expose` each camera,
/// then `develop` each camera's picture.
class PictureTaker {
 public:
  /// All references have to outlive this.
  PictureTaker(const world::World& world, render::Renderer& renderer,
               const std::vector<CameraRig>& cameras, std::int64_t seed);

  /// The offsets from an instant at which pictures are exposed, ascending; 0 is among them.
  [[nodiscard]] const std::vector<Duration>& offsets() const { return offsets_; }

  /// Exposes a camera's sensor to the world as it stands at `offset` from the instant.
  /// @param poses  of the cameras at that time
  void expose(std::size_t camera, Duration offset, CameraPoses& poses);

  /// The picture that a camera has taken: CV_8UC3, blue green red. May be evaluated in any thread
  /// as long as the renderer lives. Resets the sensor for the next instant.
  /// @param scene_index  determines the noise
  [[nodiscard]] render::PendingPicture develop(std::size_t camera, std::int64_t scene_index);

  /// Replaces a scene's depth, if it is known, by what the camera would measure. May be called in
  /// any thread.
  void measureDepth(Scene& scene) const;

 private:
  /// A camera's planned shots, and what its sensor has recorded so far.
  struct Sensor {
    std::vector<Shot> shots;

    /// Moments so far: of each rolling shot, or of all other shots together.
    std::vector<std::vector<render::RollingMoment>> moments;

    render::LinkSelection present;                   ///< at all of these moments
    std::optional<Exposure> exposure;                ///< if a picture takes several shots
    render::PendingPicture picture;                  ///< if it takes one
    std::optional<render::CapturedView> in_weather;  ///< at the instant, unless the air is clear

    /// Whether the picture is of a single moment.
    [[nodiscard]] bool isSimple() const { return shots.size() == 1 && !shots.front().rolls(); }
  };

  [[nodiscard]] static render::ColourPass passOf(const CameraRig& camera,
                                                 const render::LinkSelection& present);
  void wait(const CameraRig& camera, const Pose& X_GC, std::size_t shot, const ShotMoment& moment,
            Sensor& sensor);
  [[nodiscard]] render::CapturedView lookThroughWeather(const CameraRig& camera, const Pose& X_GC);

  const world::World& world_;
  render::Renderer& renderer_;
  const std::vector<CameraRig>& cameras_;
  std::uint64_t seed_;
  std::vector<Sensor> sensors_;  ///< of cameras_
  std::vector<Duration> offsets_;
};

}  // namespace synthetic_dataset::scene
