#pragma once

#include <memory>
#include <string>
#include <utility>

#include "base/random/random_source.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A pattern in random colours that tiles: checkers, stripes, dots, a gradient or clouds.
/// @return the kind of pattern ("stripes") and its picture
[[nodiscard]] std::pair<std::string, std::shared_ptr<const world::Texture>> drawPattern(
    base::RandomSource& random);

}  // namespace synthetic_dataset::randomize
