#pragma once

#include <limits>
#include <string>
#include <vector>

#include <opencv2/core/mat.hpp>

namespace synthetic_dataset::formats {

/// What numbers of a file can say of a depth.
struct DepthNumbers {
  double unit = 1.0;      ///< what 1 is [m]
  double rounding = 0.0;  ///< how far a pixel's depth may be off [m]
  double greatest = std::numeric_limits<double>::infinity();  ///< [m]
};

/// What is wrong with a depth image; empty for nothing. The sum of each square of
/// TrueScene::kDepthCell pixels is known, so that a wrong depth is seen that adds more to it than
/// rounding can.
/// @param depth  of one channel; 0 for no depth
/// @param cells  as TrueScene::depth_cells
[[nodiscard]] std::string depthProblem(const cv::Mat& depth, const DepthNumbers& numbers,
                                       const std::vector<float>& cells);

}  // namespace synthetic_dataset::formats
