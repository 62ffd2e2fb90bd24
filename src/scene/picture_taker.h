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
/// with the effects of lens and sensor.
///
/// For each instant: move the world to each of `offsets` from the instant and `expose` each camera,
/// then `develop` each camera's picture.
class PictureTaker {
 public:
  /// All references have to outlive this.
  PictureTaker(const world::World& world, render::Renderer& renderer,
               const std::vector<CameraRig>& cameras, std::int64_t seed);

  /// The times around an instant at which a shutter lets light in, ascending; 0 is among them.
  [[nodiscard]] const std::vector<Duration>& offsets() const { return offsets_; }

  /// Lets the world as it stands at `offset` from the instant fall on a camera's sensor.
  /// @param poses  of the cameras then
  void expose(std::size_t camera, Duration offset, CameraPoses& poses);

  /// What a camera has seen, to be made in any thread as long as the renderer lives: CV_8UC3, blue
  /// green red. Its sensor is dark again then.
  /// @param scene_index  its noise belongs to this scene
  [[nodiscard]] render::PendingPicture develop(std::size_t camera, std::int64_t scene_index);

  /// Puts what the camera measures in the place of a scene's depth, where that is known; in any
  /// thread.
  void measureDepth(Scene& scene) const;

 private:
  /// A camera's plan, and what has fallen on its sensor so far.
  struct Sensor {
    std::vector<Shot> shots;

    /// Moments so far: of each shot that rolls, or of all other shots together.
    std::vector<std::vector<render::RollingMoment>> moments;

    render::LinkSelection present;                ///< at all of these moments
    std::optional<Exposure> exposure;             ///< where a picture takes several shots
    render::PendingPicture picture;               ///< where it takes one
    std::optional<render::TakenView> in_weather;  ///< at the instant, unless the air is clear

    /// Whether the picture is that of one moment.
    [[nodiscard]] bool isSimple() const { return shots.size() == 1 && !shots.front().rolls(); }
  };

  [[nodiscard]] static render::ColourPass passOf(const CameraRig& camera,
                                                 const render::LinkSelection& present);
  void wait(const CameraRig& camera, const Pose& X_GC, std::size_t shot, const ShotMoment& moment,
            Sensor& sensor);
  [[nodiscard]] render::TakenView lookThroughWeather(const CameraRig& camera, const Pose& X_GC);

  const world::World& world_;
  render::Renderer& renderer_;
  const std::vector<CameraRig>& cameras_;
  std::uint64_t seed_;
  std::vector<Sensor> sensors_;  ///< of cameras_
  std::vector<Duration> offsets_;
};

}  // namespace synthetic_dataset::scene
