#include "scene/exposure.h"

#include <future>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::scene {
namespace exposure_test {

render::PendingPicture grey(int value) {
  return [value] { return cv::Mat(3, 4, CV_8UC3, cv::Scalar::all(value)); };
}

TEST(Exposure, IsTheMeanOfItsPictures) {
  render::PictureMakers makers;
  Exposure exposure(makers);
  exposure.add(grey(255), 0.5);
  exposure.add(grey(0), 0.5);
  const render::PendingPicture first = exposure.develop();
  exposure.add(grey(10), 1.0);
  EXPECT_EQ(cv::norm(first(), grey(188)(), cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(exposure.develop()(), grey(10)(), cv::NORM_INF), 0.0);
}

TEST(Exposure, FinishesAPictureWhileTheOneBeforeIsInWork) {
  std::promise<void> begins;
  render::PictureMakers makers;
  Exposure exposure(makers);
  exposure.add(
      [&] {
        begins.get_future().wait();
        return grey(255)();
      },
      0.25);
  exposure.add(
      [&] {
        begins.set_value();
        return grey(0)();
      },
      0.75);
  EXPECT_EQ(cv::norm(exposure.develop()(), grey(137)(), cv::NORM_INF), 0.0);
}

TEST(Exposure, FailsWithAPictureThatFails) {
  render::PictureMakers makers;
  Exposure exposure(makers);
  exposure.add([]() -> cv::Mat { throw Error("no memory"); }, 1.0);
  EXPECT_THROW((void)exposure.develop()(), Error);
}

}  // namespace exposure_test
}  // namespace synthetic_dataset::scene
