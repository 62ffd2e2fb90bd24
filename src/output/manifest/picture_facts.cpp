#include "output/manifest/picture_facts.h"

#include <algorithm>
#include <cstdint>
#include <string_view>

#include <opencv2/core.hpp>

#include "output/files/digest.h"

namespace synthetic_dataset::output {
namespace {

/// @param depth  CV_32FC1
std::vector<float> depthCells(const cv::Mat& depth) {
  std::vector<float> cells;
  for (int top = 0; top < depth.rows; top += kDepthCell) {
    for (int left = 0; left < depth.cols; left += kDepthCell) {
      const cv::Mat cell = depth(cv::Rect(left, top, std::min(kDepthCell, depth.cols - left),
                                          std::min(kDepthCell, depth.rows - top)));
      double least = 0.0;
      double greatest = 0.0;
      cv::minMaxLoc(cell, &least, &greatest);
      cells.push_back(static_cast<float>(cv::sum(cell)[0]));
      cells.push_back(static_cast<float>(least));
      cells.push_back(static_cast<float>(greatest));
    }
  }
  return cells;
}

/// @param labels  of a point cloud (base::cloudPictures)
std::vector<float> pointCounts(const cv::Mat_<cv::Vec3w>& labels) {
  std::vector<float> counts;
  for (const cv::Vec3w& label : labels) {
    if (label[0] == 0) continue;
    if (counts.size() < label[0]) counts.resize(label[0], 0.0F);
    counts[label[0] - std::size_t{1}] += 1.0F;
  }
  return counts;
}

}  // namespace

PictureFacts pictureFacts(const std::string& name, const cv::Mat& pixels) {
  PictureFacts facts{name, digestOfPixels(pixels), {}};
  if (name == "depth") facts.cells = depthCells(pixels);
  if (name.rfind("cloud_", 0) == 0 && pixels.type() == CV_16UC3) facts.cells = pointCounts(pixels);
  return facts;
}

cv::Mat normalColours(const cv::Mat& normals) {
  const auto byteOf = [](float coordinate) {
    return cv::saturate_cast<uchar>((coordinate + 1.0F) * 0.5F * 255.0F);
  };
  const cv::Mat_<cv::Vec3f> from = normals;
  cv::Mat_<cv::Vec3b> colours(from.size());
  std::transform(from.begin(), from.end(), colours.begin(), [&](const cv::Vec3f& n) {
    const bool is_nothing = n == cv::Vec3f(0.0F, 0.0F, 0.0F);
    return is_nothing ? cv::Vec3b() : cv::Vec3b(byteOf(n[2]), byteOf(n[1]), byteOf(n[0]));
  });
  return colours;
}

cv::Mat depthNumbers(const cv::Mat& depth, double per_metre) {
  constexpr double kTooGreat = 65536.0;
  cv::Mat_<std::uint16_t> numbers(depth.size());
  for (int row = 0; row < depth.rows; ++row) {
    const auto* from = depth.ptr<float>(row);
    std::uint16_t* to = numbers[row];
    for (int column = 0; column < depth.cols; ++column) {
      // Truncation turns this into the nearest integer; results below 1 count as no depth.
      const double number = double{from[column]} * per_metre + 0.5;
      to[column] = number >= 1.0 && number < kTooGreat
                       ? static_cast<std::uint16_t>(static_cast<int>(number))
                       : std::uint16_t{0};
    }
  }
  return numbers;
}

std::string digestOfPixels(const cv::Mat& pixels) {
  Digest digest;
  const std::size_t size = pixels.elemSize() * static_cast<std::size_t>(pixels.cols);
  for (int row = 0; row < pixels.rows; ++row) {
    // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): bytes are bytes
    digest.add(std::string_view(reinterpret_cast<const char*>(pixels.ptr(row)), size));
  }
  return digest.text();
}

}  // namespace synthetic_dataset::output
