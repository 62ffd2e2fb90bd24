#include "motion/recorded/recorded_depths.h"

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "support/bag_builder.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace recorded_depths_test {

using test::BagBuilder;
using test::milliseconds;
using ::testing::HasSubstr;

class RecordedDepthsTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
};

TEST_F(RecordedDepthsTest, AreReadByTheirStamps) {
  const cv::Mat near(2, 3, CV_16UC1, cv::Scalar(1000));
  const cv::Mat far(2, 3, CV_32FC1, cv::Scalar(7.0));
  const std::string file = BagBuilder(folder / "run.bag")
                               .from("eye")
                               .picture("/depth", milliseconds(2000), far, "32FC1")
                               .picture("/depth", milliseconds(1000), near, "16UC1")
                               .picture("/depth", milliseconds(3000), near, "bgr8")
                               .close();
  const RecordedDepths depths({file}, "/depth");
  ASSERT_EQ(depths.heads().size(), 3U);
  EXPECT_EQ(depths.read(0).at<float>(1, 2), 1.0F);
  EXPECT_EQ(depths.read(1).at<float>(1, 2), 7.0F);
  EXPECT_EQ(depths.heads()[1].width, 3U);
  EXPECT_EQ(depths.heads()[1].frame, "eye");
  EXPECT_THAT(depths.heads()[2].problem, HasSubstr("has the encoding 'bgr8'"));
}

}  // namespace recorded_depths_test
}  // namespace synthetic_dataset::motion
