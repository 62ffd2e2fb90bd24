#pragma once

#include "render/labels/label_painter.h"
#include "render/lens/lens_sight.h"

namespace synthetic_dataset::render {

/// What a look through a lens tells of labels.
[[nodiscard]] LabelImages labelsOf(const LensSight& sight, const DrawList& draw_list,
                                   const LabelPass& pass);

}  // namespace synthetic_dataset::render
