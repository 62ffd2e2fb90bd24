#include "render/lens/lens_resampling.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <opencv2/core/utility.hpp>

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {
namespace {

/// Calls work(u, v) for each pixel of a region that looks at the face. Rows are processed in
/// parallel; no two calls share a pixel.
template <class Work>
void forEachPixel(const LensMap& map, std::size_t face, const cv::Rect& region, const Work& work) {
  const auto wanted = static_cast<std::int16_t>(face);
  cv::parallel_for_(cv::Range(region.y, region.y + region.height), [&](const cv::Range& rows) {
    for (int v = rows.start; v < rows.end; ++v) {
      const auto* faces = map.face.ptr<std::int16_t>(v);
      for (int u = region.x; u < region.x + region.width; ++u) {
        if (faces[u] == wanted) work(u, v);
      }
    }
  });
}

/// The step on the face from a pixel to the next one or, at the lens's rim, from the previous one
/// to it.
cv::Point2f stepOf(const LensMap& map, const LensFace& face, int u, int v, int du, int dv) {
  const int side = neighbourSide(map, face.X_CF, u, v, du, dv);
  const cv::Point2f here = placeOn(face, map.rays.at<cv::Vec3f>(v, u));
  const cv::Point2f there = placeOn(face, map.rays.at<cv::Vec3f>(v + side * dv, u + side * du));
  return static_cast<float>(side) * (there - here);
}

/// The light at a place between pixels, interpolated bilinearly from the four around it.
cv::Vec3f lightAt(const cv::Mat& drawn, cv::Point2f place) {
  const auto& linear = render::linearFromSrgb();
  const float x = std::clamp(place.x, 0.0F, static_cast<float>(drawn.cols - 1));
  const float y = std::clamp(place.y, 0.0F, static_cast<float>(drawn.rows - 1));
  const int u = std::min(static_cast<int>(x), std::max(drawn.cols - 2, 0));
  const int v = std::min(static_cast<int>(y), std::max(drawn.rows - 2, 0));
  const int next_u = std::min(u + 1, drawn.cols - 1);
  const float a = x - static_cast<float>(u);
  const float b = y - static_cast<float>(v);
  const auto* top = drawn.ptr<cv::Vec3b>(v);
  const auto* bottom = drawn.ptr<cv::Vec3b>(std::min(v + 1, drawn.rows - 1));
  cv::Vec3f light;
  for (int i = 0; i < 3; ++i) {
    const float above = (1.0F - a) * linear[top[u][i]] + a * linear[top[next_u][i]];
    const float below = (1.0F - a) * linear[bottom[u][i]] + a * linear[bottom[next_u][i]];
    light[i] = (1.0F - b) * above + b * below;
  }
  return light;
}

cv::Point nearestPixel(const cv::Size& face, cv::Point2f place) {
  return {std::clamp(static_cast<int>(std::lround(place.x)), 0, face.width - 1),
          std::clamp(static_cast<int>(std::lround(place.y)), 0, face.height - 1)};
}

}  // namespace

cv::Rect neededOf(const LensMap& map, std::size_t face, const cv::Rect& region) {
  constexpr int kRoom = 8;  // [px]
  const LensFace& f = map.faces[face];
  const auto wanted = static_cast<std::int16_t>(face);
  cv::Point2f low(1e9F, 1e9F);
  cv::Point2f high(-1e9F, -1e9F);
  for (int v = region.y; v < region.y + region.height; ++v) {
    for (int u = region.x; u < region.x + region.width; ++u) {
      if (map.face.at<std::int16_t>(v, u) != wanted) continue;
      const cv::Point2f place = placeOn(f, map.rays.at<cv::Vec3f>(v, u));
      low = {std::min(low.x, place.x), std::min(low.y, place.y)};
      high = {std::max(high.x, place.x), std::max(high.y, place.y)};
    }
  }
  if (low.x > high.x) return {};
  const cv::Rect bounds(
      cv::Point(static_cast<int>(low.x) - kRoom, static_cast<int>(low.y) - kRoom),
      cv::Point(static_cast<int>(high.x) + kRoom + 1, static_cast<int>(high.y) + kRoom + 1));
  return bounds & cv::Rect(0, 0, f.camera.width(), f.camera.height());
}

void resampleSmooth(const LensMap& map, std::size_t face, const cv::Mat& drawn,
                    const cv::Rect& region, cv::Mat& picture) {
  constexpr float kMostTaps = 8.0F;
  const LensFace& f = map.faces[face];
  forEachPixel(map, face, region, [&](int u, int v) {
    const cv::Point2f place = placeOn(f, map.rays.at<cv::Vec3f>(v, u));
    const cv::Point2f right = stepOf(map, f, u, v, 1, 0);
    const cv::Point2f down = stepOf(map, f, u, v, 0, 1);
    // Enough places in each direction that they are about one face pixel apart.
    const auto taps = [&](cv::Point2f step) {
      return static_cast<int>(std::clamp(std::round(std::hypot(step.x, step.y)), 1.0F, kMostTaps));
    };
    const int across = taps(right);
    const int along = taps(down);
    cv::Vec3f light(0.0F, 0.0F, 0.0F);
    for (int j = 0; j < along; ++j) {
      const float b = (static_cast<float>(j) + 0.5F) / static_cast<float>(along) - 0.5F;
      for (int i = 0; i < across; ++i) {
        const float a = (static_cast<float>(i) + 0.5F) / static_cast<float>(across) - 0.5F;
        light += lightAt(drawn, place + a * right + b * down);
      }
    }
    const float share = 1.0F / static_cast<float>(across * along);
    for (int i = 0; i < 3; ++i) {
      picture.at<cv::Vec3b>(v, u)[i] = render::srgbFromLinear(share * light[i]);
    }
  });
}

void resampleCentres(const LensMap& map, std::size_t face, const cv::Mat& drawn,
                     const cv::Rect& region, cv::Mat& picture) {
  const LensFace& f = map.faces[face];
  forEachPixel(map, face, region, [&](int u, int v) {
    const cv::Point2f place = placeOn(f, map.rays.at<cv::Vec3f>(v, u));
    picture.at<cv::Vec3b>(v, u) = drawn.at<cv::Vec3b>(nearestPixel(drawn.size(), place));
  });
}

}  // namespace synthetic_dataset::render
