#include "world/material/default_paint.h"

namespace synthetic_dataset::world {

void paintDefaults(Simulator simulator, Model& model) {
  constexpr float kGrey = 0.7F;  // gz-sim, SceneManager::CreateVisual
  for (Link& link : model.links) {
    for (Visual& visual : link.visuals) {
      for (Surface& surface : visual.surfaces) {
        if (!surface.material.is_default || simulator != Simulator::kGz) continue;
        surface.material.diffuse.head<3>().setConstant(kGrey);
      }
    }
  }
}

}  // namespace synthetic_dataset::world
