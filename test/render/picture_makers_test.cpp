#include "render/picture_makers.h"

#include <future>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace picture_makers_test {

TEST(PictureMakers, MakeAPictureOnceBeforeAnybodyAsksForIt) {
  std::promise<void> made;
  PictureMakers makers;
  const PendingPicture picture = makers.begun([&] {
    made.set_value();
    return cv::Mat(1, 1, CV_8UC1, cv::Scalar(7));
  });
  made.get_future().wait();
  EXPECT_EQ(picture().at<unsigned char>(0), 7);
  EXPECT_EQ(picture().data, picture().data);
}

TEST(PictureMakers, FailWhereThePictureIsAskedFor) {
  PictureMakers makers;
  const PendingPicture picture = makers.begun([]() -> cv::Mat { throw Error("no memory"); });
  EXPECT_THROW((void)picture(), Error);
}

TEST(PictureMakers, LetAPictureWaitForThoseBefore) {
  PictureMakers makers;
  PendingPicture last = makers.begun([] { return cv::Mat(1, 1, CV_8UC1, cv::Scalar(0)); });
  for (int i = 0; i < 20; ++i) {
    last = makers.begun([before = last]() -> cv::Mat { return before() + 1; });
  }
  EXPECT_EQ(last().at<unsigned char>(0), 20);
}

}  // namespace picture_makers_test
}  // namespace synthetic_dataset::render
