#include "plugins/readback/depth_values.h"

#include <algorithm>
#include <cmath>

#include <opencv2/core.hpp>

#include "plugins/readback/found_files.h"

namespace synthetic_dataset::formats {

std::string depthProblem(const cv::Mat& depth, const DepthNumbers& numbers,
                         const std::vector<float>& cells) {
  constexpr int kCell = TrueScene::kDepthCell;
  constexpr double kSingle = 1e-6;  // of sums in single precision
  std::size_t at = 0;
  for (int top = 0; top < depth.rows; top += kCell) {
    for (int left = 0; left < depth.cols; left += kCell, at += 3) {
      const cv::Rect square(left, top, std::min(kCell, depth.cols - left),
                            std::min(kCell, depth.rows - top));
      if (at + 3 > cells.size()) return "the manifest does not say what is in it";
      const double right = cells[at];
      // What is behind the camera or farther than a pixel can say has no depth in the file.
      if (cells[at + 1] < 0.0F || cells[at + 2] > numbers.greatest) continue;
      const double found = numbers.unit * cv::sum(depth(square))[0];
      const double rounding = numbers.rounding * cv::countNonZero(depth(square));
      if (std::abs(found - right) <= rounding + kSingle * (1.0 + right)) continue;
      return "found depths of " + std::to_string(found) + " m together in the square at " +
             std::to_string(left) + ", " + std::to_string(top) + "; it should be " +
             std::to_string(right);
    }
  }
  return "";
}

}  // namespace synthetic_dataset::formats
