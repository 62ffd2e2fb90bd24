/// Edge pixels, against a check of each pixel's neighbours one by one.

#include "render/edges/edge_pixels.h"

#include <random>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

namespace synthetic_dataset::render {
namespace edge_pixels_test {

const Intrinsics kIntrinsics = {100.0, 100.0, 75.0, 20.0};

/// The geometry of a wall that faces the camera and has spots of a second item.
GeometryImages spots(const cv::Size& size) {
  GeometryImages images;
  images.items = cv::Mat(size, CV_32SC1, cv::Scalar(1));
  images.depth = cv::Mat(size, CV_32FC1, cv::Scalar(2.0));
  constexpr int kMinusOne = 0xBC00;  // as a 16-bit float
  images.normals = cv::Mat(size, CV_16UC4, cv::Scalar(0, 0, kMinusOne, 0));
  std::mt19937 random(3);
  for (int i = 0; i < 40; ++i) {
    const cv::Point spot(static_cast<int>(random() % static_cast<unsigned>(size.width)),
                         static_cast<int>(random() % static_cast<unsigned>(size.height)));
    images.items(cv::Rect(spot, cv::Size(3, 2)) & cv::Rect({}, size)).setTo(2);
  }
  return images;
}

/// Whether a pixel sees another part than one of its four neighbours.
bool isEdge(const cv::Mat& items, const cv::Point& pixel) {
  for (const cv::Point& step : {cv::Point(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
    const cv::Point other = pixel + step;
    if (!cv::Rect({}, items.size()).contains(other)) continue;
    if (items.at<int>(other) != items.at<int>(pixel)) return true;
  }
  return false;
}

class EdgePixelsOfWidth : public testing::TestWithParam<int> {};

TEST_P(EdgePixelsOfWidth, AreThoseWantedWhoseNeighboursSeeAnotherSurface) {
  const cv::Rect place(7, 5, GetParam(), 31);  // in the picture
  const GeometryImages images = spots(place.size());
  const cv::Rect region(place.x + 1, place.y + 2, place.width - 1, place.height - 4);
  cv::Mat wanted(100, 200, CV_8UC1);
  cv::randu(wanted, 0, 2);
  wanted *= 255;
  const EdgePixels edges(images, place, {region}, wanted, kIntrinsics);
  std::vector<cv::Point> expected;
  for (int v = region.y; v < region.br().y; ++v) {
    for (int u = region.x; u < region.br().x; ++u) {
      if (wanted.at<std::uint8_t>(v, u) == 0) continue;
      if (isEdge(images.items, cv::Point(u, v) - place.tl())) expected.emplace_back(u, v);
    }
  }
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(edges.pixels(), expected);
}

TEST_P(EdgePixelsOfWidth, AreVisitedInAnyRectangle) {
  const cv::Rect place(7, 5, GetParam(), 31);
  const cv::Mat wanted(100, 200, CV_8UC1, cv::Scalar(255));
  const EdgePixels edges(spots(place.size()), place, {place}, wanted, kIntrinsics);
  std::mt19937 random(5);
  const auto anyOf = [&](int from, int count) {
    return std::uniform_int_distribution<int>(from, from + count)(random);
  };
  for (int i = 0; i < 2000; ++i) {
    const cv::Rect rectangle(anyOf(place.x - 3, place.width), anyOf(place.y - 3, place.height),
                             anyOf(0, place.width + 5), anyOf(0, 9));
    std::vector<cv::Point> expected;
    for (const cv::Point& pixel : edges.pixels()) {
      if (rectangle.contains(pixel)) expected.push_back(pixel);
    }
    std::vector<cv::Point> visited;
    edges.visit(rectangle, [&](std::size_t pixel) { visited.push_back(edges.pixels()[pixel]); });
    ASSERT_EQ(visited, expected) << rectangle;
  }
}

INSTANTIATE_TEST_SUITE_P(EdgePixels, EdgePixelsOfWidth,
                         testing::Values(2, 3, 8, 63, 64, 65, 128, 150));

}  // namespace edge_pixels_test
}  // namespace synthetic_dataset::render
