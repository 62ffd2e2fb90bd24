#pragma once

#include <vector>

#include "render/parts/draw_list.h"
#include "render/render_options.h"
#include "render/shadows/held_casters.h"
#include "render/shadows/shadow_projection.h"
#include "render/view.h"

namespace synthetic_dataset::render {

/// What all surfaces of a picture have in common. What it refers to has to outlive it.
struct ColourScene {
  const View& view;
  const std::vector<Pose>& X_WL;
  const LinkSelection& drawn;
  const std::vector<ShadowProjection>& shadows;
  float exposure = 1.0F;

  /// The view of the lens of which `view` is a face; null if it is not a face.
  const View* whole = nullptr;

  LightDetail detail = LightDetail::kSimple;

  /// The poses in which links cast their shadows, if they differ from X_WL.
  const CasterPoses* casters = nullptr;
};

}  // namespace synthetic_dataset::render
