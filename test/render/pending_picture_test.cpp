#include "render/pending_picture.h"

#include <future>

#include <gtest/gtest.h>
#include <opencv2/core.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace pending_picture_test {

TEST(BegunPicture, IsMadeOnceBeforeAnybodyAsksForIt) {
  std::promise<void> made;
  const PendingPicture picture = begun([&] {
    made.set_value();
    return cv::Mat(1, 1, CV_8UC1, cv::Scalar(7));
  });
  made.get_future().wait();
  EXPECT_EQ(picture().at<unsigned char>(0), 7);
  EXPECT_EQ(picture().data, picture().data);
}

TEST(BegunPicture, FailsWhereItIsAskedFor) {
  const PendingPicture picture = begun([]() -> cv::Mat { throw Error("no memory"); });
  EXPECT_THROW((void)picture(), Error);
}

}  // namespace pending_picture_test
}  // namespace synthetic_dataset::render
