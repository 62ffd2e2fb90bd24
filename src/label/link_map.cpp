#include "label/link_map.h"

#include <algorithm>
#include <cstddef>

namespace synthetic_dataset::label {

cv::Mat mapOfLinks(const cv::Mat& links, const std::vector<std::uint16_t>& numbers) {
  cv::Mat map(links.size(), CV_16UC1);
  for (int row = 0; row < links.rows; ++row) {
    const auto* from = links.ptr<std::int32_t>(row);
    std::transform(from, from + links.cols, map.ptr<std::uint16_t>(row), [&](std::int32_t link) {
      return link == 0 ? std::uint16_t{0} : numbers[static_cast<std::size_t>(link) - 1];
    });
  }
  return map;
}

}  // namespace synthetic_dataset::label
