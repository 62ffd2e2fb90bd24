#include "run/check/scene_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

constexpr std::int64_t kTinyLabel = 25;  ///< visible pixels: 5 x 5

/// Brightness percentiles of a picture, 0 to 255.
struct Brightness {
  double highest = 0.0;  ///< not exceeded by 98 % of the pixels
  double lowest = 0.0;   ///< not undercut by 98 % of the pixels
};

/// Measures a few thousand pixels spread over the picture.
Brightness brightnessOf(const cv::Mat& image) {
  constexpr int kSteps = 64;
  std::array<std::int64_t, 256> histogram{};
  std::int64_t count = 0;
  for (int i = 0; i < kSteps; ++i) {
    const auto* row = image.ptr<cv::Vec3b>((2 * i + 1) * image.rows / (2 * kSteps));
    for (int j = 0; j < kSteps; ++j) {
      const cv::Vec3b& pixel = row[(2 * j + 1) * image.cols / (2 * kSteps)];
      const int grey = (pixel[0] + 2 * pixel[1] + pixel[2]) / 4;
      ++histogram[static_cast<std::size_t>(grey)];
      ++count;
    }
  }
  const std::int64_t few = count / 50;
  const auto firstOfMany = [&](auto begin, auto end) {
    std::int64_t passed = 0;
    return std::find_if(begin, end, [&](std::int64_t each) { return (passed += each) > few; });
  };
  const auto lowest = firstOfMany(histogram.begin(), histogram.end()) - histogram.begin();
  const auto highest = firstOfMany(histogram.rbegin(), histogram.rend()) - histogram.rbegin();
  return {255.0 - static_cast<double>(highest), static_cast<double>(lowest)};
}

/// Whether an object is visible: even a small one on a plain ground keeps a picture from being
/// plain.
bool seesAnObject(const Scene& scene) {
  return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
    return object.pixels.visible.isKnown() ? object.pixels.visible() > 0
                                           : object.inView(scene.camera);
  });
}

std::string scenesText(std::int64_t count, std::int64_t of) {
  return std::to_string(count) + " of " + std::to_string(of) + " scenes";
}

}  // namespace

void SceneStatistics::add(const Scene& scene) {
  ++scenes_;
  addPicture(scene);
  addLabels(scene);
}

void SceneStatistics::addPicture(const Scene& scene) {
  if (scene.image.empty()) return;
  constexpr double kDark = 24.0;  // nothing stands out in the dark
  constexpr double kBright = 250.0;
  constexpr double kPlain = 4.0;  // less than an object's shading or a sensor's noise
  const Brightness found = brightnessOf(scene.image);
  const auto count = [&](Pictures& pictures) {
    if (pictures.count++ == 0) pictures.first = scene.name;
  };
  if (found.highest < kDark) {
    count(dark_);
  } else if (found.lowest > kBright) {
    count(bright_);
  } else if (found.highest - found.lowest < kPlain && !seesAnObject(scene)) {
    count(plain_);
  }
}

void SceneStatistics::addLabels(const Scene& scene) {
  for (const SceneObject& object : scene.objects) {
    if (!object.pixels.visible.isKnown() || !object.labelled()) continue;
    ++labels_;
    if (object.pixels.visible() < kTinyLabel) ++tiny_labels_;
  }
}

bool SceneStatistics::areMany(std::int64_t count, std::int64_t of) const {
  constexpr double kMany = 0.2;  // share of all; fewer may be intended, for example at dawn
  return count > 0 && static_cast<double>(count) >= kMany * static_cast<double>(of);
}

void SceneStatistics::findPictures(const Pictures& pictures, const std::string& kind,
                                   const std::string& are, const std::string& cure,
                                   std::vector<Finding>& findings) const {
  if (!areMany(pictures.count, scenes_)) return;
  findings.push_back({kind, "pictures",
                      scenesText(pictures.count, scenes_) + " are " + are + ", the first one '" +
                          pictures.first + "'",
                      cure});
}

std::vector<Finding> SceneStatistics::findings() const {
  std::vector<Finding> findings;
  findPictures(dark_, "dark", "nearly black",
               "the world may lack a light, or randomize or camera/effects/exposure may remove it",
               findings);
  findPictures(bright_, "bright", "nearly white",
               "lights may be too strong, or camera/effects/exposure too high", findings);
  findPictures(plain_, "plain", "of one colour all over",
               "the camera may look into the sky or at a wall; `camera/pose: {position: [x, y, z], "
               "look_at: OBJECT}` aims it",
               findings);
  if (!has_thresholds_ && areMany(tiny_labels_, labels_)) {
    findings.push_back({"tiny labels", "labels",
                        std::to_string(tiny_labels_) + " of " + std::to_string(labels_) +
                            " labels have fewer than " + std::to_string(kTinyLabel) +
                            " visible pixels",
                        "`labels/min_pixels: " + std::to_string(kTinyLabel) +
                            "` leaves them out, a nearer camera makes them larger"});
  }
  return findings;
}

}  // namespace synthetic_dataset::run
