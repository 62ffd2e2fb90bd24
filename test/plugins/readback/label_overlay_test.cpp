#include "plugins/readback/label_overlay.h"

#include <limits>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace label_overlay_test {

using testing::HasSubstr;

LabelledPicture pictureWith(const DrawnLabel& label, const cv::Size& size = {64, 48}) {
  return {cv::Mat(size, CV_8UC3, cv::Scalar::all(9)), {label}};
}

TEST(DrawLabels, RefusesAMaskOfAnotherSize) {
  DrawnLabel label;
  label.caption = "robot";
  label.mask = cv::Mat(4, 5, CV_8UC1, cv::Scalar(255));
  EXPECT_THAT(
      test::messagesOf([&] { static_cast<void>(drawLabels(pictureWith(label))); }),
      testing::ElementsAre(HasSubstr("a mask of 'robot' has 5 x 4 pixels; its image has 64 x 48")));
}

TEST(DrawLabels, EndsForPlacesThatAreFarAwayOrNoNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  for (const double far : {nan, infinity, -infinity, 1e300, -1e15}) {
    DrawnLabel label;
    label.caption = "robot";
    label.box = Box{far, far, -far, 5.0};
    label.keypoints = label.hidden_keypoints = {{far, 1.0}, {1.0, far}};
    label.lines = {{cv::Point2d(far, far), cv::Point2d(1.0, 2.0)}};
    label.polygons = {{{far, 0.0}, {1.0, far}, {2.0, 2.0}, {3.0, 1.0}, {-far, 5.0}}};
    EXPECT_EQ(drawLabels(pictureWith(label)).size(), cv::Size(64, 48)) << far;
  }
}

TEST(DrawLabels, WritesOnAPictureThatIsSmallerThanTheWords) {
  DrawnLabel label;
  label.caption = "a long caption";
  label.box = Box{0.0, 0.0, 2.0, 2.0};
  EXPECT_EQ(drawLabels(pictureWith(label, {3, 3})).size(), cv::Size(3, 3));
}

}  // namespace label_overlay_test
}  // namespace synthetic_dataset::formats
