#include "plugins/shared/mask_rle.h"

namespace synthetic_dataset::masks {

std::vector<std::int64_t> columnRuns(const Mask& mask) {
  const std::int64_t width = mask.imageSize().width;
  const std::int64_t height = mask.imageSize().height;
  if (mask.empty()) return {width * height};
  const cv::Rect extent = mask.bounds();
  const cv::Mat columns = mask.pixels().t();  // transposed: its rows are the extent's columns
  std::vector<std::int64_t> runs;
  std::int64_t run_start = 0;
  bool in_mask = false;
  const auto meet = [&](std::int64_t pixel, bool on) {
    if (on == in_mask) return;
    runs.push_back(pixel - run_start);
    run_start = pixel;
    in_mask = on;
  };
  for (int column = 0; column < columns.rows; ++column) {
    const std::int64_t top = (extent.x + column) * height;
    if (extent.y > 0) meet(top, false);
    const auto* pixels = columns.ptr<std::uint8_t>(column);
    for (int row = 0; row < extent.height; ++row) meet(top + extent.y + row, pixels[row] != 0);
    if (extent.br().y < height) meet(top + extent.br().y, false);
  }
  if (extent.br().x < width) meet(extent.br().x * height, false);
  runs.push_back(width * height - run_start);
  return runs;
}

std::string cocoCounts(const std::vector<std::int64_t>& runs) {
  // rleToString: each number in groups of 5 bits, lowest first, two's complement; bit 5 says that
  // more follow. From the fourth on, it is the difference from the second to last number.
  constexpr std::int64_t kGroup = 0x1f;
  constexpr std::int64_t kSign = 0x10;
  constexpr std::int64_t kMore = 0x20;
  constexpr char kFirstLetter = 48;
  std::string counts;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    std::int64_t rest = i > 2 ? runs[i] - runs[i - 2] : runs[i];
    for (bool more = true; more;) {
      const std::int64_t group = rest & kGroup;
      rest >>= 5;
      more = rest != ((group & kSign) != 0 ? -1 : 0);
      counts += static_cast<char>(kFirstLetter + (more ? group | kMore : group));
    }
  }
  return counts;
}

}  // namespace synthetic_dataset::masks
