#pragma once

#include <optional>
#include <vector>

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "randomize/appearance/randomize_options.h"
#include "randomize/appearance/variety/paint_canvas.h"
#include "randomize/appearance/variety/print.h"
#include "randomize/appearance/variety/wear.h"

namespace synthetic_dataset::randomize {

/// A stripe around a part, by relative height: 0 at its foot .. 1 at its top.
struct Band {
  float low;
  float high;
  Eigen::Vector3f colour;
};

/// How a part is painted.
struct PartPaint {
  std::optional<Eigen::Vector3f> colour;  ///< replacing its own pattern
  float detail = 0.0F;                    ///< how much of its own pattern shows through, 0 .. 1
  std::vector<Band> bands;
  std::optional<Print> print;
};

/// How a variant of a model is painted. Colours are sRGB-encoded.
struct VariantPaint {
  std::vector<Eigen::Vector3f> colours;  ///< one per paint of the palette
  float contrast = 1.0F;                 ///< of the variation within a paint
  std::vector<PartPaint> parts;
  Wear wear;
  float roughness = 0.0F;  ///< to be added
};

/// @param variety  not kNone
[[nodiscard]] VariantPaint drawPaint(const PaintedModel& model, Variety variety,
                                     base::RandomSource& random);

}  // namespace synthetic_dataset::randomize
