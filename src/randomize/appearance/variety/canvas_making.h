#pragma once

#include <memory>

#include "randomize/appearance/variety/model_parts.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// Whether a surface can be repainted: it is not transparent and has no overlay.
[[nodiscard]] bool isPaintable(const world::Surface& surface);

/// Replaces a material's texture with another one of the same things. If it glows in its texture's
/// colours, as in some mesh files, it then glows in those of the new one.
void setTexture(const std::shared_ptr<const world::Texture>& texture, world::Material& material);

/// Gives the large surfaces of a model textures that can be painted place by place, as far as
/// possible: those that show the same texels in several places, and those in a single colour. Their
/// look does not change. Afterwards, no picture is larger than 1024 pixels a side.
void makeCanvases(world::Model& model);

}  // namespace synthetic_dataset::randomize
