#include "annotate/instance_map.h"

#include <algorithm>
#include <numeric>

namespace synthetic_dataset::annotate {

std::optional<Box> InstancePixels::box() const {
  if (count == 0) return std::nullopt;
  return Box{bounds.x - 0.5, bounds.y - 0.5, bounds.br().x - 0.5, bounds.br().y - 0.5};
}

cv::Mat instanceMap(const cv::Mat& ids) {
  cv::Mat map;
  ids.convertTo(map, CV_16UC1);
  return map;
}

cv::Mat layeredInstanceMap(const std::vector<cv::Mat>& masks, const cv::Mat& ids,
                           const std::vector<double>& distances) {
  cv::Mat map = cv::Mat::zeros(ids.size(), CV_16UC1);
  std::vector<std::size_t> nearest_last(masks.size());
  std::iota(nearest_last.begin(), nearest_last.end(), std::size_t{0});
  std::stable_sort(nearest_last.begin(), nearest_last.end(),
                   [&](std::size_t a, std::size_t b) { return distances[a] > distances[b]; });
  for (const std::size_t i : nearest_last) {
    const auto instance = static_cast<int>(i) + 1;
    map.setTo(instance, (masks[i] != 0) & ((ids == 0) | (ids == instance)));
  }
  return map;
}

std::vector<InstancePixels> instancePixels(const cv::Mat& instance_map, std::size_t object_count) {
  struct Extent {
    int left, top, right, bottom;
  };
  std::vector<Extent> extents(object_count, {instance_map.cols, instance_map.rows, -1, -1});
  std::vector<InstancePixels> pixels(object_count);
  for (int v = 0; v < instance_map.rows; ++v) {
    const auto* row = instance_map.ptr<std::uint16_t>(v);
    for (int u = 0; u < instance_map.cols; ++u) {
      if (row[u] == 0) continue;
      const std::size_t object = row[u] - std::size_t{1};
      Extent& extent = extents[object];
      extent = {std::min(extent.left, u), std::min(extent.top, v), std::max(extent.right, u),
                std::max(extent.bottom, v)};
      ++pixels[object].count;
    }
  }
  for (std::size_t i = 0; i < object_count; ++i) {
    if (pixels[i].count == 0) continue;
    const Extent& e = extents[i];
    pixels[i].bounds = {e.left, e.top, e.right - e.left + 1, e.bottom - e.top + 1};
  }
  return pixels;
}

cv::Mat instanceMask(const cv::Mat& instance_map, int instance, const cv::Rect& bounds) {
  cv::Mat mask = cv::Mat::zeros(instance_map.size(), CV_8UC1);
  if (!bounds.empty()) cv::Mat(instance_map(bounds) == instance).copyTo(mask(bounds));
  return mask;
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
  for (int v = 0; v < exact.rows; ++v) {
    const auto* a = found.ptr<std::uint16_t>(v);
    const auto* b = exact.ptr<std::uint16_t>(v);
    for (int u = 0; u < exact.cols; ++u) {
      if (b[u] != 0 && a[u] == b[u]) ++both[b[u] - std::size_t{1}];
    }
  }
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

}  // namespace synthetic_dataset::annotate
