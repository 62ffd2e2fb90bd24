#include "render/unfinished_picture.h"

#include "render/srgb.h"

namespace synthetic_dataset::render {

cv::Mat finished(const UnfinishedPicture& picture, const EdgeSmoother& smoother) {
  cv::Mat result = picture.elsewhere.clone();
  for (const cv::Rect& region : picture.regions) {
    srgbFromLinear(picture.seen.light(region - picture.seen.place.tl())).copyTo(result(region));
  }
  if (picture.edges) smoother.smooth(*picture.edges, picture.seen, picture.regions, result);
  return result;
}

}  // namespace synthetic_dataset::render
