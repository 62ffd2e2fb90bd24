#include "label/instance_map.h"

#include <algorithm>
#include <cstring>
#include <numeric>

namespace synthetic_dataset::label {
namespace {

/// Calls visit(instance, row, first column, column after the last) for each run of pixels of one
/// instance in a row.
template <class Visit>
void visitRuns(const cv::Mat& instance_map, const Visit& visit) {
  constexpr int kAtOnce = 4;  // pixels; most of a picture belongs to no object
  for (int row = 0; row < instance_map.rows; ++row) {
    const auto* pixels = instance_map.ptr<std::uint16_t>(row);
    for (int u = 0; u < instance_map.cols;) {
      std::uint64_t several = 1;
      if (u + kAtOnce <= instance_map.cols) std::memcpy(&several, pixels + u, sizeof several);
      if (several == 0) {
        u += kAtOnce;
        continue;
      }
      const int first = u;
      while (u < instance_map.cols && pixels[u] == pixels[first]) ++u;
      if (pixels[first] != 0) visit(pixels[first], row, first, u);
    }
  }
}

}  // namespace

cv::Mat instanceMap(const cv::Mat& ids) {
  cv::Mat map;
  ids.convertTo(map, CV_16UC1);
  return map;
}

cv::Mat layeredInstanceMap(const std::vector<Mask>& masks, const cv::Mat& ids,
                           const std::vector<double>& distances) {
  cv::Mat map = cv::Mat::zeros(ids.size(), CV_16UC1);
  std::vector<std::size_t> nearest_last(masks.size());
  std::iota(nearest_last.begin(), nearest_last.end(), std::size_t{0});
  std::stable_sort(nearest_last.begin(), nearest_last.end(),
                   [&](std::size_t a, std::size_t b) { return distances[a] > distances[b]; });
  for (const std::size_t i : nearest_last) {
    const auto instance = static_cast<int>(i) + 1;
    if (masks[i].empty()) continue;
    const cv::Rect bounds = masks[i].bounds();
    const cv::Mat of_others = (ids(bounds) != 0) & (ids(bounds) != instance);
    map(bounds).setTo(instance, (masks[i].pixels() != 0) & ~of_others);
  }
  return map;
}

std::vector<InstancePixels> instancePixels(const cv::Mat& instance_map, std::size_t object_count) {
  struct Extent {
    int left, top, right, bottom;
  };
  std::vector<Extent> extents(object_count, {instance_map.cols, instance_map.rows, -1, -1});
  std::vector<InstancePixels> pixels(object_count);
  visitRuns(instance_map, [&](int instance, int row, int first, int end) {
    const auto object = static_cast<std::size_t>(instance) - 1;
    Extent& extent = extents[object];
    extent = {std::min(extent.left, first), std::min(extent.top, row),
              std::max(extent.right, end - 1), std::max(extent.bottom, row)};
    pixels[object].count += end - first;
  });
  for (std::size_t i = 0; i < object_count; ++i) {
    if (pixels[i].count == 0) continue;
    const Extent& e = extents[i];
    pixels[i].bounds = {e.left, e.top, e.right - e.left + 1, e.bottom - e.top + 1};
  }
  return pixels;
}

Mask instanceMask(const cv::Mat& instance_map, int instance, const cv::Rect& bounds) {
  if (bounds.empty()) return Mask(instance_map.size());
  return {instance_map(bounds) == instance, bounds.tl(), instance_map.size()};
}

cv::Mat renumbered(const cv::Mat& instance_map, const std::vector<std::uint16_t>& numbers) {
  cv::Mat result(instance_map.size(), CV_16UC1);
  std::transform(instance_map.begin<std::uint16_t>(), instance_map.end<std::uint16_t>(),
                 result.begin<std::uint16_t>(), [&](std::uint16_t instance) {
                   return instance == 0 ? std::uint16_t{0} : numbers[instance - std::size_t{1}];
                 });
  return result;
}

std::vector<std::optional<double>> intersectionOverUnion(const cv::Mat& found, const cv::Mat& exact,
                                                         std::size_t object_count) {
  std::vector<std::int64_t> both(object_count, 0);
  visitRuns(exact, [&](int instance, int row, int first, int end) {
    const auto* pixels = found.ptr<std::uint16_t>(row);
    both[static_cast<std::size_t>(instance) - 1] +=
        std::count(pixels + first, pixels + end, static_cast<std::uint16_t>(instance));
  });
  const auto in_found = instancePixels(found, object_count);
  const auto in_exact = instancePixels(exact, object_count);
  std::vector<std::optional<double>> result(object_count);
  for (std::size_t i = 0; i < object_count; ++i) {
    if (in_exact[i].count == 0) continue;
    const std::int64_t either = in_found[i].count + in_exact[i].count - both[i];
    result[i] = static_cast<double>(both[i]) / static_cast<double>(either);
  }
  return result;
}

}  // namespace synthetic_dataset::label
