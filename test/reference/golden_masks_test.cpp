/// Masks against those of the original tool, from the pictures that it saw.

#include <algorithm>
#include <array>
#include <cmath>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "label/mask.h"
#include "label/mog2_segmenter.h"
#include "reference/golden_case.h"

namespace synthetic_dataset {
namespace golden_masks_test {

namespace fs = std::filesystem;

/// The part of [floor(left), ceil(right)) by [floor(top), ceil(bottom)) that is in the image.
cv::Rect pixelsOf(const std::array<double, 4>& box, const cv::Size& image) {
  const auto index = [](double edge, int limit) {
    return static_cast<int>(std::clamp(edge, 0.0, static_cast<double>(limit)));
  };
  const cv::Point first(index(std::floor(box[0]), image.width),
                        index(std::floor(box[1]), image.height));
  const cv::Point end(index(std::ceil(box[2]), image.width),
                      index(std::ceil(box[3]), image.height));
  return first.x < end.x && first.y < end.y ? cv::Rect(first, end) : cv::Rect();
}

class GoldenMasks : public ::testing::TestWithParam<std::string> {};

TEST_P(GoldenMasks, AreTheOriginalsPixelByPixel) {
  const test::GoldenCase golden(GetParam());
  const fs::path inputs = golden.folder() / "mask_inputs";
  // The case's own settings; simtime_trunc uses the defaults.
  const bool defaults = GetParam() == "simtime_trunc";
  label::Mog2Segmenter segmenter({defaults ? 100 : 1, 500.0, false});
  segmenter.train(cv::imread((inputs / "background.png").string()));
  int compared = 0;
  for (const auto& object : fs::directory_iterator(inputs)) {
    if (!object.is_directory()) continue;
    const std::string name = object.path().filename().string();
    for (const auto& file : fs::directory_iterator(object.path())) {
      const std::string stem = file.path().stem().string();
      if (stem.rfind("alone_", 0) != 0) continue;
      const std::string number = stem.substr(6);
      const auto read = [](const fs::path& path) {
        return cv::imread(path.string(), cv::IMREAD_GRAYSCALE);
      };
      const cv::Mat image = cv::imread(file.path().string());
      const cv::Mat raw = segmenter.segment(image, cv::Rect(cv::Point(), image.size()));
      EXPECT_EQ(cv::norm(raw, read(object.path() / ("rawmask_" + number + ".png")), cv::NORM_INF),
                0)
          << name << " " << number;

      const auto& box = golden.frames().at(std::stoul(number)).objects.at(name).box;
      const cv::Rect inside = pixelsOf(box, raw.size());
      cv::Mat mask = cv::Mat::zeros(raw.size(), raw.type());
      if (!inside.empty()) raw(inside).copyTo(mask(inside));
      const fs::path relative = fs::path("masks") / name / (number + ".png");
      const fs::path mended = golden.folder() / "expected_fixed" / relative;
      const cv::Mat original = read(fs::exists(mended) ? mended : golden.folder() / relative);
      ASSERT_FALSE(original.empty()) << relative;
      EXPECT_EQ(cv::norm(mask, original, cv::NORM_INF), 0) << name << " " << number;
      ++compared;
    }
  }
  EXPECT_GT(compared, 0);
}

INSTANTIATE_TEST_SUITE_P(Cases, GoldenMasks,
                         ::testing::Values("example", "nested_late_early", "simtime_trunc"),
                         [](const auto& golden) { return golden.param; });

}  // namespace golden_masks_test
}  // namespace synthetic_dataset
