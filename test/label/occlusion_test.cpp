#include "label/occlusion.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::label {
namespace occlusion_test {

constexpr OcclusionMargin kMargin{0.1, 0.02};

/// A picture of one row, with the world's depths or the measured ones.
cv::Mat row(const std::vector<float>& values) { return cv::Mat(values, true).reshape(1, 1); }

std::vector<int> covered(const std::vector<float>& known, const std::vector<float>& measured) {
  const cv::Mat found = coveredPixels(row(known), row(measured), kMargin);
  std::vector<int> values;
  for (int i = 0; i < found.cols; ++i) values.push_back(found.at<std::uint8_t>(0, i) / 255);
  return values;
}

TEST(Occlusion, BeginsInFrontOfTheMargin) {
  // 10 m away, the margin is 0.1 + 0.2 m.
  const std::vector<float> known(4, 10.0F);
  EXPECT_EQ(covered(known, {9.71F, 9.69F, 12.0F, 0.0F}), (std::vector<int>{0, 1, 0, 0}));
}

TEST(Occlusion, IsByWhatIsInFrontOfTheSky) {
  EXPECT_EQ(covered({0.0F, 0.0F}, {50.0F, 0.0F}), (std::vector<int>{1, 0}));
}

TEST(Occlusion, IsNotByWhatTheWorldHasTwoPixelsAway) {
  // The outline of something that is known, 2 m away, is measured two pixels farther to the right.
  const std::vector<float> known = {2, 2, 5, 5, 5, 5};
  EXPECT_EQ(covered(known, {2, 2, 2, 2, 2, 5}), (std::vector<int>{0, 0, 0, 0, 1, 0}));
}

TEST(Occlusion, IsCountedByObject) {
  const cv::Mat ids = (cv::Mat_<int>(1, 6) << 0, 1, 1, 1, 1, 2);
  const cv::Mat measured = row({1, 1, 0, 5, 5, 0});
  const cv::Mat hidden = (cv::Mat_<std::uint8_t>(1, 6) << 255, 255, 0, 0, 0, 0);
  const auto covers = objectCovers(ids, measured, hidden, 3);
  EXPECT_EQ(covers[0].unmeasuredShare(), 0.25);
  EXPECT_EQ(covers[0].coveredShare(), 0.25);
  EXPECT_EQ(covers[1].unmeasuredShare(), 1.0);
  EXPECT_EQ(covers[2].pixels, 0);
  EXPECT_EQ(objectCovers(ids, {}, {}, 3)[0].unmeasuredShare(), 1.0) << "nothing was measured";
}

}  // namespace occlusion_test
}  // namespace synthetic_dataset::label
