#pragma once

#include "api/lens_model.h"

namespace synthetic_dataset::lens {

/// theta_d = theta (1 + k1 theta^2 + k2 theta^4 + k3 theta^6 + k4 theta^8), as in cv::fisheye.
extern const LensFunctions kFisheye;

}  // namespace synthetic_dataset::lens
