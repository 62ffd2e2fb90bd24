#pragma once

#include <functional>

#include "output/manifest/scene_facts.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset {

/// A scene with its picture and all labels, and what its manifest is told.
struct FinishedScene {
  Scene scene;
  output::SceneFacts facts;
};

/// Finishes a scene from what was drawn for it, once, in any thread, as long as what drew it lives.
using PendingScene = std::function<FinishedScene()>;

}  // namespace synthetic_dataset
