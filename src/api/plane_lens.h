#pragma once

#include "api/lens_model.h"

namespace synthetic_dataset::lens {

/// A pinhole whose picture nothing bends.
extern const LensFunctions kPinhole;

/// A pinhole whose picture OpenCV's polynomials bend (cv::projectPoints).
extern const LensFunctions kBentPinhole;

}  // namespace synthetic_dataset::lens
