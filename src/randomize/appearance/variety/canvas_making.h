#pragma once

#include <memory>

#include "randomize/appearance/variety/model_parts.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// Whether a surface can be painted anew: nothing is seen through it or laid over it.
[[nodiscard]] bool isPaintable(const world::Surface& surface);

/// Gives a surface another texture of the same things. Where it shines in its texture's colours, as
/// some mesh files have it, it shines in those of the new one.
void setTexture(const std::shared_ptr<const world::Texture>& texture, world::Material& material);

/// Gives the large surfaces of a model textures that can be painted place by place, as far as that
/// is possible: of those that show the same texels in several places, and of those in one colour.
/// What they look like stays. Pictures are no larger than 1024 pixels a side afterwards.
void makeCanvases(world::Model& model);

}  // namespace synthetic_dataset::randomize
