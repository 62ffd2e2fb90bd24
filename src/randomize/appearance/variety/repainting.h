#pragma once

#include <opencv2/core/mat.hpp>

#include "base/random/random_source.h"
#include "randomize/appearance/variety/paint_canvas.h"
#include "randomize/appearance/variety/variant_paint.h"

namespace synthetic_dataset::randomize {

/// The paint that a variant has in place of one of the model's.
/// @param colour  of the model, sRGB-encoded
[[nodiscard]] Eigen::Vector3f repainted(const Eigen::Vector3f& colour, const PaintedModel& model,
                                        const VariantPaint& paint);

/// The variant's version of one of the model's canvases. Alpha stays.
/// @param random  decides where scratches are
[[nodiscard]] cv::Mat repainted(const PaintCanvas& canvas, const PaintedModel& model,
                                const VariantPaint& paint, base::RandomSource& random);

}  // namespace synthetic_dataset::randomize
