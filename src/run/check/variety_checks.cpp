#include "run/check/variety_checks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <set>
#include <tuple>
#include <utility>

#include <opencv2/core/mat.hpp>
#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset::run {
namespace {

constexpr int kWidth = 64;  ///< of the small image in which detail is measured [px]

/// Mask of the small image's pixels that show no label.
cv::Mat surroundingsOf(const Scene& scene, const cv::Size& size) {
  cv::Mat surroundings(size, CV_8U, cv::Scalar::all(1));
  const double scale = static_cast<double>(size.width) / scene.image.cols;
  for (const SceneObject& object : scene.objects) {
    const std::optional<Box> box = object.visibleBox();
    if (!object.labelled() || !box) continue;
    const cv::Point first(static_cast<int>(std::floor(box->left * scale)),
                          static_cast<int>(std::floor(box->top * scale)));
    const cv::Point last(static_cast<int>(std::floor(box->right * scale)) + 2,
                         static_cast<int>(std::floor(box->bottom * scale)) + 2);
    surroundings(cv::Rect(first, last) & cv::Rect({}, size)).setTo(0);
  }
  return surroundings;
}

std::map<std::string, std::size_t> looksOf(const RunSetup& setup) {
  std::map<std::string, std::set<std::tuple<std::string, randomize::Variety, int>>> looks;
  for (const MotionSetup& motion : setup.motions) {
    for (std::size_t i = 0; i < motion.config.objects.size(); ++i) {
      const scene::ObjectOptions& object = motion.config.objects[i];
      if (!object.takes_part || object.is_distractor) continue;
      for (const scene::ObjectVariant& each : motion.variants[i].all()) {
        const std::string own = object.model.value_or(object.name);
        looks[object.class_name].insert({each.model.value_or(own), each.variety, each.number});
      }
    }
  }
  std::map<std::string, std::size_t> counts;
  for (const auto& [name, of_class] : looks) counts[name] = of_class.size();
  return counts;
}

std::string percent(double share) { return fixed(100.0 * share, 0) + " %"; }

}  // namespace

std::optional<double> surroundingDetail(const Scene& scene) {
  constexpr int kPlain = 8;  // of 255
  if (scene.image.empty()) return std::nullopt;
  const int height =
      std::max(2, static_cast<int>(std::lround(static_cast<double>(scene.image.rows) * kWidth /
                                               scene.image.cols)));
  cv::Mat grey;
  cv::cvtColor(scene.image, grey, cv::COLOR_BGR2GRAY);
  cv::resize(grey, grey, {kWidth, height}, 0, 0, cv::INTER_AREA);
  const cv::Mat surroundings = surroundingsOf(scene, grey.size());
  std::int64_t all = 0;
  std::int64_t detailed = 0;
  for (int y = 0; y + 1 < height; ++y) {
    const std::uint8_t* row = grey.ptr(y);
    const std::uint8_t* below = grey.ptr(y + 1);
    for (int x = 0; x + 1 < kWidth; ++x) {
      if (surroundings.at<std::uint8_t>(y, x) == 0) continue;
      ++all;
      const int difference = std::max(std::abs(row[x + 1] - row[x]), std::abs(below[x] - row[x]));
      if (difference > kPlain) ++detailed;
    }
  }
  if (all == 0) return std::nullopt;
  return static_cast<double>(detailed) / static_cast<double>(all);
}

std::optional<SceneVariety> varietyOf(const RunSetup& setup,
                                      const std::vector<FinishedScene>& scenes) {
  double detail = 0.0;
  int images = 0;
  bool has_labels = false;
  for (const FinishedScene& each : scenes) {
    has_labels |= std::any_of(each.scene.objects.begin(), each.scene.objects.end(),
                              [](const SceneObject& object) { return object.labelled(); });
    if (const auto found = surroundingDetail(each.scene)) {
      detail += *found;
      ++images;
    }
  }
  if (images == 0 || !has_labels) return std::nullopt;
  return SceneVariety{detail / images, looksOf(setup)};
}

std::string varietyLine(const SceneVariety& variety) {
  std::string looks;
  for (const auto& [name, count] : variety.looks) {
    looks += (looks.empty() ? "" : ", ") + name + " " + std::to_string(count);
  }
  return "variety: " + percent(variety.detail) +
         " of what surrounds labels is not plain; looks: " + looks;
}

std::vector<Finding> checkVariety(const SceneVariety& variety) {
  constexpr double kPlain = 0.1;  // a plain ground has 3 %, one with things on it 25 %
  const bool is_one_look = std::all_of(variety.looks.begin(), variety.looks.end(),
                                       [](const auto& of_class) { return of_class.second == 1; });
  if (!is_one_look || variety.detail > kPlain) return {};
  return {{"learnt by heart", "pictures",
           "one model of each class, and nothing else in view (" + percent(variety.detail) +
               " of what surrounds labels is not plain), which a network learns by heart",
           "add `randomize: {preset: transfer}`"}};
}

}  // namespace synthetic_dataset::run
