#pragma once

#include <cstdint>
#include <vector>

#include "base/scene_facts.h"
#include "output/manifest/run_description.h"
#include "synthetic_dataset/label_writer.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// A scene with its image, all labels, and further facts about it.
struct FinishedScene {
  Scene scene;
  base::SceneFacts facts;
  bool is_left_out = false;  ///< its labels do not fit its recorded picture well enough
  std::vector<std::uint8_t> image_file = {};  ///< the JPEG that its image was decoded from, if any
};

/// How a run ends.
enum class RunEnd {
  kAllMade,  ///< every scene that the sink wanted was added
  kStopped,  ///< the user stopped the run before that
};

/// Receives the finished scenes of a run: a dataset, or anything else that shows or keeps scenes.
///
/// Life cycle: `begin`, then `add` for each scene, then `finish`. `add` is called in a background
/// thread, by one caller at a time, in the order of the scenes, while the next ones are drawn; all
/// other methods are called in the thread that runs, none of them while `add` runs. So a sink needs
/// no locks. When a method throws, the run ends with its error, and nothing more is called.
class SceneSink {
 public:
  SceneSink() = default;
  SceneSink(const SceneSink&) = delete;
  SceneSink& operator=(const SceneSink&) = delete;
  virtual ~SceneSink() = default;

  /// What has to be computed for each scene; nothing else is computed. The same at every call.
  [[nodiscard]] virtual Requirements requirements() const = 0;

  /// Called once everything else is ready for the first scene.
  virtual void begin(const DatasetInfo& dataset) = 0;

  /// Whether a scene is to be made. Asked after `begin`, for every scene of the run.
  /// @param scene  its Scene::index
  [[nodiscard]] virtual bool wants(std::int64_t scene) const = 0;

  /// Takes a wanted scene. To keep it, copy it: copies share their pixels.
  /// @return warnings about the scene in addition to those in its facts
  [[nodiscard]] virtual std::vector<base::Warning> add(const FinishedScene& finished) = 0;

  /// Called after the last scene, unless the run failed.
  virtual void finish(RunEnd end) = 0;
};

}  // namespace synthetic_dataset::run
