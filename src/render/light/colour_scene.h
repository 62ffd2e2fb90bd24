#pragma once

#include <vector>

#include "render/parts/draw_list.h"
#include "render/render_options.h"
#include "render/shadows/held_casters.h"
#include "render/shadows/shadow_projection.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// What all surfaces of a picture have in common. The references have to outlive it.
struct ColourScene {
  const View& view;
  const std::vector<Pose>& X_WL;
  const LinkSelection& drawn;
  const std::vector<ShadowProjection>& shadows;
  float exposure = 1.0F;

  /// Through a lens: what it sees, of which `view` is a face.
  const View* whole = nullptr;

  LightDetail detail = LightDetail::kSimple;

  /// Where links cast their shadows, where that is not quite X_WL.
  const CasterPoses* casters = nullptr;
};

}  // namespace synthetic_dataset::render
