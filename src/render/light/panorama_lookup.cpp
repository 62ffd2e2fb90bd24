#include "render/light/panorama_lookup.h"

#include <cmath>

#include "render/pixels/lane_angles.h"

namespace synthetic_dataset::render {

PanoramaPlaces placesOf(const Lanes3& directions) {
  constexpr auto kTurn = static_cast<float>(2.0 * M_PI);
  const Lanes half = lanes(0.5F);
  const Lanes level_sides = cv::v_sqrt(directions.x * directions.x + directions.y * directions.y);
  return {clamped(half - angleOf(directions.y, directions.x) * lanes(1.0F / kTurn), 0.0F, 1.0F),
          clamped(half - angleOf(directions.z, level_sides) * lanes(2.0F / kTurn), 0.0F, 1.0F)};
}

cv::Mat bordered(const cv::Mat& panorama) {
  const cv::Size size = panorama.size();
  cv::Mat all(size.height + 2, size.width + 2, panorama.type());
  panorama.copyTo(all({1, 1, size.width, size.height}));
  const int half = size.width / 2;
  for (const int row : {0, size.height + 1}) {
    const cv::Mat pole = panorama.row(row == 0 ? 0 : size.height - 1);
    cv::Mat beyond = all({1, row, size.width, 1});
    pole.colRange(half, size.width).copyTo(beyond.colRange(0, size.width - half));
    pole.colRange(0, half).copyTo(beyond.colRange(size.width - half, size.width));
  }
  all.col(size.width).copyTo(all.col(0));
  all.col(1).copyTo(all.col(size.width + 1));
  return all;
}

}  // namespace synthetic_dataset::render
