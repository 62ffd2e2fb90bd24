#pragma once

#include "api/lens_model.h"

namespace synthetic_dataset::lens {

/// A pinhole without distortion.
extern const LensFunctions kPinhole;

/// A pinhole with the distortion of OpenCV's polynomials (cv::projectPoints).
extern const LensFunctions kBentPinhole;

}  // namespace synthetic_dataset::lens
