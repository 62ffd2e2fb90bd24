#include "plugins/coco/coco_rle.h"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::coco {
namespace {

/// As rleFrString of common/maskApi.c in https://github.com/cocodataset/cocoapi: letters hold five
/// bits, lowest first; a sixth bit says that the number continues; the highest bit of the last
/// letter is the sign. From the fourth on, a number is the difference from the second to last one.
std::vector<std::int64_t> runsOf(const std::string& counts) {
  constexpr int kFirstLetter = 48;
  constexpr int kMostGroups = 12;  // of five bits, in 64 bits
  std::vector<std::int64_t> runs;
  std::int64_t run = 0;
  int groups = 0;
  for (const char letter : counts) {
    const int value = letter - kFirstLetter;
    if (value < 0 || value >= 64 || groups == kMostGroups) {
      throw Error("found '" + counts + "'; it should be COCO's run lengths");
    }
    run += static_cast<std::int64_t>(value % 32) << (5 * groups);
    ++groups;
    if (value >= 32) continue;
    if (value >= 16) run -= std::int64_t{1} << (5 * groups);
    if (runs.size() > 2) run += runs[runs.size() - 2];
    runs.push_back(run);
    run = 0;
    groups = 0;
  }
  return runs;
}

}  // namespace

cv::Mat maskOfCocoCounts(const std::string& counts, const cv::Size& size) {
  cv::Mat columns(size.width, size.height, CV_8UC1, cv::Scalar(0));  // transposed
  const auto total = static_cast<std::int64_t>(columns.total());
  std::int64_t place = 0;
  bool on = false;
  for (const std::int64_t run : runsOf(counts)) {
    if (run < 0 || run > total - place) {
      throw Error("found run lengths of more pixels than the image has");
    }
    if (on) std::fill_n(columns.data + place, run, std::uint8_t{255});
    place += run;
    on = !on;
  }
  if (place != total) throw Error("found run lengths of fewer pixels than the image has");
  return columns.t();
}

}  // namespace synthetic_dataset::formats::coco
