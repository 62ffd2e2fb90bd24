#include "motion/recorded/recorded_ranges.h"

#include <limits>

#include <gmock/gmock.h>
#include <opencv2/core.hpp>

#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace recorded_clouds_test {

using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

class RecordedCloudsTest : public ::testing::Test {
 protected:
  test::TemporaryFolder folder;
};

TEST_F(RecordedCloudsTest, HavePointsAFrameAndAStamp) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const std::string file = BagBuilder(folder / "run.bag")
                               .from("/scanner")
                               .cloud("/points", milliseconds(2000), {{1, 2, 3}})
                               .cloud("/points", milliseconds(1500), {{4, 5, 6}, {nan, 0, 0}})
                               .close();
  const RecordedClouds clouds({file}, "/points");
  ASSERT_EQ(clouds.heads().size(), 2U);
  EXPECT_EQ(clouds.heads()[0].stamp, milliseconds(1500));
  EXPECT_EQ(clouds.heads()[0].frame, "scanner");
  EXPECT_EQ(clouds.heads()[0].problem, "");
  EXPECT_THAT(clouds.read(0), ElementsAre(Eigen::Vector3d(4, 5, 6))) << "what is finite";
  EXPECT_THAT(clouds.read(1), ElementsAre(Eigen::Vector3d(1, 2, 3)));
}

TEST_F(RecordedCloudsTest, AreOfATopicThatIsThere) {
  const std::string file = BagBuilder(folder / "run.bag")
                               .cloud("/points", milliseconds(1000), {{1, 2, 3}})
                               .say("/chatter", milliseconds(1000))
                               .close();
  EXPECT_THAT(test::messagesOf([&] { const RecordedClouds clouds({file}, "/point"); }),
              ElementsAre(AllOf(HasSubstr("it has /points"), HasSubstr("did you mean"))));
  EXPECT_THAT(test::messagesOf([&] { const RecordedClouds clouds({file}, "/chatter"); }),
              ElementsAre(HasSubstr("they should be sensor_msgs/PointCloud2")));
}

TEST_F(RecordedCloudsTest, DepthsAreReadByTheirStamps) {
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

}  // namespace recorded_clouds_test
}  // namespace synthetic_dataset::motion
