#include "render/lens_library.h"

#include <utility>

namespace synthetic_dataset::render {
namespace {

/// All that tells one camera's pictures from another's.
std::vector<double> keyOf(const CameraModel& camera) {
  const Intrinsics& k = camera.intrinsics();
  const Distortion& distortion = camera.distortion();
  std::vector<double> key = {static_cast<double>(camera.width()),
                             static_cast<double>(camera.height()),
                             k.fx,
                             k.fy,
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

const LensMap& LensLibrary::get(const CameraModel& camera) {
  std::vector<double> key = keyOf(camera);
  const auto known = maps_.find(key);
  if (known != maps_.end()) return known->second;
  return maps_.emplace(std::move(key), makeLensMap(camera)).first->second;
}

std::vector<View> faceViews(const LensMap& lens, const View& view) {
  std::vector<View> views;
  for (const LensFace& face : lens.faces) views.push_back({face.camera, view.X_WC * face.X_CF});
  return views;
}

}  // namespace synthetic_dataset::render
