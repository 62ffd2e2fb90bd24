#include "render/kept_picture.h"

#include <cstddef>
#include <utility>

namespace synthetic_dataset::render {
namespace {

/// Each rectangle that is drawn again costs a look at all that never moves.
constexpr std::size_t kMostRegions = 8;

/// Puts together what costs about as much in one: rectangles that lie over one another.
std::vector<cv::Rect> merged(std::vector<cv::Rect> regions) {
  constexpr double kGain = 1.2;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    for (std::size_t j = i + 1; j < regions.size();) {
      const cv::Rect both = regions[i] | regions[j];
      if (both.area() > kGain * (regions[i].area() + regions[j].area())) {
        ++j;
        continue;
      }
      regions[i] = both;
      regions.erase(regions.begin() + static_cast<std::ptrdiff_t>(j));
      j = i + 1;
    }
  }
  if (regions.size() <= kMostRegions) return regions;
  cv::Rect all = regions.front();
  for (const cv::Rect& region : regions) all |= region;
  return {all};
}

int areaOf(const std::vector<cv::Rect>& regions) {
  int area = 0;
  for (const cv::Rect& region : regions) area += region.area();
  return area;
}

}  // namespace

bool KeptPicture::Key::operator==(const Key& other) const {
  return clip_from_camera == other.clip_from_camera && X_WC == other.X_WC &&
         shadows == other.shadows && drawn == other.drawn && casting == other.casting &&
         exposure == other.exposure;
}

KeptPicture::KeptPicture(const GlFunctions& gl, const DrawList& parts,
                         const std::vector<world::Light>& lights, ShadowPainter& shadow_painter,
                         ColourPainter& painter, const ColourTarget& target)
    : gl_(gl),
      parts_(parts),
      lights_(lights),
      shadow_painter_(shadow_painter),
      painter_(painter),
      target_(target) {}

void KeptPicture::paint(const ColourScene& scene, const LinkSelection& casting,
                        const float background[3]) {
  Key key{clipFromCamera(scene.view.camera),
          scene.view.X_WC.matrix(),
          {},
          scene.drawn,
          casting,
          scene.exposure};
  for (const ShadowProjection& shadow : scene.shadows) {
    key.shadows.push_back(shadow.shadow_from_world);
  }
  if (!key_ || !(*key_ == key)) {
    // It may not come again: what would be kept is drawn only when it does.
    key_ = std::move(key);
    is_kept_ = false;
    paintAnew(scene, casting, background);
    return;
  }
  if (!is_kept_) keep(scene, casting, background);
  paintChanges(scene, casting, background);
}

void KeptPicture::paintAnew(const ColourScene& scene, const LinkSelection& casting,
                            const float background[3]) {
  shadow_painter_.paint(scene.shadows, scene.X_WL, casting);
  target_.begin(background);
  painter_.paint(scene, shadow_painter_.texture());
}

void KeptPicture::keep(const ColourScene& scene, const LinkSelection& casting,
                       const float background[3]) {
  shadow_painter_.paintStanding(scene.shadows, scene.X_WL, casting);
  target_.begin(background);
  painter_.paintStanding(scene, shadow_painter_.texture());
  if (!kept_) kept_ = target_.makeSamples();
  target_.keep(*kept_);
  changed_.clear();
  is_kept_ = true;
}

void KeptPicture::paintChanges(const ColourScene& scene, const LinkSelection& casting,
                               const float background[3]) {
  constexpr double kMost = 0.6;  // of the image; beyond it, to draw all anew is as quick
  const cv::Rect image(0, 0, scene.view.camera.width(), scene.view.camera.height());
  ChangedRegions regions = changedRegions(parts_.parts(), scene.view, scene.X_WL, scene.drawn,
                                          casting, lights_, scene.shadows);
  regions.shadowed = merged(std::move(regions.shadowed));
  if (areaOf(regions.shadowed) > kMost * image.area()) {
    changed_ = {image};
    paintAnew(scene, casting, background);
    return;
  }
  shadow_painter_.paint(scene.shadows, scene.X_WL, casting);
  target_.bind();
  for (const cv::Rect& region : changed_) target_.restore(*kept_, region);
  for (const cv::Rect& region : regions.shadowed) {
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(region.x, region.y, region.width, region.height);
    target_.begin(background);
    painter_.paintStanding(scene, shadow_painter_.texture());
    gl_.Disable(GL_SCISSOR_TEST);
  }
  painter_.paintTheRest(scene, shadow_painter_.texture());
  changed_ = std::move(regions.shadowed);
  changed_.insert(changed_.end(), regions.covered.begin(), regions.covered.end());
}

}  // namespace synthetic_dataset::render
