#include "render/picture/unfinished_picture.h"

#include "render/pixels/srgb.h"

namespace synthetic_dataset::render {

cv::Mat finished(const UnfinishedPicture& picture, const EdgeSmoother& smoother) {
  cv::Mat result = picture.elsewhere.clone();
  const SeenSurfaces& seen = picture.unlit.seen;
  const cv::Mat light = picture.unlit.light();
  for (const cv::Rect& region : picture.regions) {
    cv::Mat pixels = result(region);
    encodeSrgb(light(region - seen.place.tl()), picture.pixels(region), pixels);
  }
  if (picture.edges) {
    smoother.smooth(*picture.edges, {seen.geometry, light, seen.place}, picture.regions,
                    picture.pixels, result);
  }
  return result;
}

}  // namespace synthetic_dataset::render
