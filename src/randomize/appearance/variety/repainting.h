#pragma once

#include <opencv2/core/mat.hpp>

#include "base/random/random_source.h"
#include "randomize/appearance/variety/paint_canvas.h"
#include "randomize/appearance/variety/variant_paint.h"

namespace synthetic_dataset::randomize {

/// The paint that a variant has in the place of a model's.
/// @param colour  of the model, sRGB-encoded
[[nodiscard]] Eigen::Vector3f repainted(const Eigen::Vector3f& colour, const PaintedModel& model,
                                        const VariantPaint& paint);

/// A canvas of the model as the variant has it. Alpha stays.
/// @param random  says where scratches are
[[nodiscard]] cv::Mat repainted(const PaintCanvas& canvas, const PaintedModel& model,
                                const VariantPaint& paint, base::RandomSource& random);

}  // namespace synthetic_dataset::randomize
