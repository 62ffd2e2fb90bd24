#include "scene/picture_taker.h"

#include <algorithm>
#include <utility>

#include "base/random/random_seed.h"
#include "render/sensor/depth_noise.h"
#include "render/weather/lens_dust.h"

namespace synthetic_dataset::scene {

PictureTaker::PictureTaker(const world::World& world, render::Renderer& renderer,
                           const std::vector<CameraRig>& cameras, std::int64_t seed)
    : world_(world),
      renderer_(renderer),
      cameras_(cameras),
      seed_(static_cast<std::uint64_t>(seed)),
      offsets_{Duration{0}} {
  for (const CameraRig& camera : cameras_) {
    Sensor sensor;
    sensor.shots = shotsOf(camera.shutter, camera.model.height());
    for (const Shot& shot : sensor.shots) {
      for (const ShotMoment& moment : shot.moments) offsets_.push_back(moment.offset);
    }
    sensor.moments.resize(sensor.shots.size());
    if (sensor.shots.size() > 1) sensor.exposure.emplace(renderer.makers());
    sensors_.push_back(std::move(sensor));
  }
  std::sort(offsets_.begin(), offsets_.end());
  offsets_.erase(std::unique(offsets_.begin(), offsets_.end()), offsets_.end());
}

void PictureTaker::expose(std::size_t camera, Duration offset, CameraPoses& poses) {
  const CameraRig& rig = cameras_[camera];
  Sensor& sensor = sensors_[camera];
  for (std::size_t i = 0; i < sensor.shots.size(); ++i) {
    for (const ShotMoment& moment : sensor.shots[i].moments) {
      if (moment.offset != offset) continue;
      if (sensor.isSimple()) {
        sensor.picture = renderer_.draw(render::View{rig.model, poses.of(camera).X_GC},
                                        world_.linkPoses(), passOf(rig, world_.presentLinks()));
      } else {
        wait(rig, poses.of(camera).X_GC, i, moment, sensor);
      }
    }
  }
  if (offset == Duration{0} && !rig.weather.isClear()) {
    sensor.in_weather = lookThroughWeather(rig, poses.of(camera).X_GC);
  }
}

/// Remembers where everything is; draws once the last moment of a group that is drawn together has
/// come.
void PictureTaker::wait(const CameraRig& camera, const Pose& X_GC, std::size_t shot,
                        const ShotMoment& moment, Sensor& sensor) {
  const bool rolls = sensor.shots[shot].rolls();
  // Shots that do not roll are drawn one after the other, but with the same shadow maps.
  std::vector<render::RollingMoment>& moments = sensor.moments[rolls ? shot : 0];
  const std::size_t count = rolls ? sensor.shots[shot].moments.size() : sensor.shots.size();
  const render::LinkSelection present = world_.presentLinks();
  if (sensor.present.empty()) sensor.present = present;
  for (std::size_t link = 0; link < present.size(); ++link) {
    sensor.present[link] = sensor.present[link] && present[link];
  }
  moments.push_back({moment.row, X_GC, world_.linkPoses()});
  if (moments.size() < count) return;
  const render::ColourPass pass = passOf(camera, sensor.present);
  if (!rolls) {
    renderer_.drawExposure(camera.model, std::exchange(moments, {}), pass,
                           [&](render::PendingPicture picture) {
                             sensor.exposure->add(std::move(picture), sensor.shots[shot].weight);
                           });
    return;
  }
  const int bands = static_cast<int>(count) - 1;
  render::PendingPicture picture =
      renderer_.draw(render::RollingView{camera.model, std::exchange(moments, {}), bands}, pass);
  if (sensor.exposure) {
    sensor.exposure->add(std::move(picture), sensor.shots[shot].weight);
  } else {
    sensor.picture = std::move(picture);
  }
}

render::ColourPass PictureTaker::passOf(const CameraRig& camera,
                                        const render::LinkSelection& present) {
  render::ColourPass pass{present, present};
  pass.exposure = static_cast<float>(render::gainOf(camera.effects));
  return pass;
}

/// What the weather hides is computed from the middle of the exposure.
render::CapturedView PictureTaker::lookThroughWeather(const CameraRig& camera, const Pose& X_GC) {
  constexpr double kUnblurred = 0.005;  // [s]: drops are streaks in every picture
  const double exposure = toSeconds(camera.shutter.exposure_time);
  const render::View view{camera.model, X_GC};
  return {view, renderer_.distances(view, world_.linkPoses(), world_.presentLinks()),
          render::gainOf(camera.effects), exposure > 0.0 ? exposure : kUnblurred};
}

render::PendingPicture PictureTaker::develop(std::size_t camera, std::int64_t scene_index) {
  Sensor& sensor = sensors_[camera];
  if (sensor.exposure) sensor.picture = sensor.exposure->develop();
  sensor.present.clear();
  render::PendingPicture seen = std::exchange(sensor.picture, {});
  if (sensor.in_weather) {
    // All cameras of an instant see the same drops.
    const std::int64_t instant = scene_index / static_cast<std::int64_t>(cameras_.size());
    seen = [picture = std::move(seen), taken = std::move(*sensor.in_weather),
            weather = cameras_[camera].weather,
            seed = base::randomSeed(seed_, instant, "weather")] {
      return render::throughWeather(picture(), taken, weather, seed);
    };
    sensor.in_weather.reset();
  }
  if (cameras_[camera].dust.share > 0.0) {
    seen = [picture = std::move(seen), model = cameras_[camera].model,
            dust = cameras_[camera].dust] { return render::throughDust(picture(), model, dust); };
  }
  return [picture = std::move(seen), effects = cameras_[camera].effects,
          seed = base::randomSeed(seed_, scene_index, "sensor noise")] {
    return render::applyEffects(picture(), effects, seed);
  };
}

void PictureTaker::measureDepth(Scene& scene) const {
  if (!scene.depth.isKnown()) return;
  scene.depth =
      render::measuredDepth(scene.depth(), scene.camera, cameras_[scene.camera_index].depth_noise,
                            base::randomSeed(seed_, scene.index, "depth noise"));
}

}  // namespace synthetic_dataset::scene
