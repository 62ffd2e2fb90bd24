#include "render/lens/lens_library.h"

#include <algorithm>

namespace synthetic_dataset::render {
namespace {

/// Everything that distinguishes one camera's pictures from another's, except the focal lengths.
std::vector<double> keyOf(const CameraModel& camera) {
  const Intrinsics& k = camera.intrinsics();
  const Distortion& distortion = camera.distortion();
  std::vector<double> key = {static_cast<double>(camera.width()),
                             static_cast<double>(camera.height()),
                             k.cx,
                             k.cy,
                             camera.near(),
                             camera.far(),
                             static_cast<double>(distortion.model),
                             distortion.cutoff_angle};
  key.insert(key.end(), distortion.coefficients.begin(), distortion.coefficients.end());
  return key;
}

}  // namespace

std::shared_ptr<const LensMap> LensLibrary::get(const CameraModel& camera) {
  std::deque<Zoom>& zooms = lenses_[keyOf(camera)];
  const Intrinsics& k = camera.intrinsics();
  const auto known = std::find_if(zooms.begin(), zooms.end(), [&](const Zoom& zoom) {
    return zoom.fx == k.fx && zoom.fy == k.fy;
  });
  if (known != zooms.end()) {
    std::rotate(zooms.begin(), known, known + 1);
  } else {
    if (zooms.size() == kMostZooms) zooms.pop_back();
    zooms.push_front({k.fx, k.fy, std::make_shared<const LensMap>(makeLensMap(camera))});
  }
  return zooms.front().map;
}

std::vector<View> faceViews(const LensMap& lens, const View& view) {
  std::vector<View> views;
  for (const LensFace& face : lens.faces) {
    views.push_back({face.camera, view.X_WC * face.X_CF, face.near_limit});
  }
  return views;
}

}  // namespace synthetic_dataset::render
