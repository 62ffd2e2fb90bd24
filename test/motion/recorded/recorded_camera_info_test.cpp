#include "motion/recorded/recorded_camera_info.h"

#include <gmock/gmock.h>

#include "support/bag_builder.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace recorded_camera_info_test {

using test::milliseconds;
using ::testing::AllOf;
using ::testing::HasSubstr;

class RecordedCameraInfoTest : public ::testing::Test {
 protected:
  [[nodiscard]] std::string failure(const std::string& topic) const {
    try {
      (void)readCameraInfo({file}, topic);
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder;
  std::string file = test::BagBuilder(folder / "run.bag")
                         .say("/chatter", milliseconds(900))
                         .calibrate("/front/camera_info", "/front_optical", milliseconds(1000), 140,
                                    {0.1, 0.2, 0.3, 0.4, 0.5})
                         .calibrate("/front/camera_info", "other", milliseconds(1100), 150)
                         .calibrate("/rear/camera_info", "rear_optical", milliseconds(1000), 99)
                         .close();
};

TEST_F(RecordedCameraInfoTest, GivesTheFirstMessageUnderItsOwnNames) {
  const RecordedCameraInfo recorded = readCameraInfo({file}, "/front/camera_info");
  const auto& info = *recorded.info.as<Value::Map>();
  EXPECT_EQ(info.at("width"), Value(160));
  EXPECT_EQ(info.at("height"), Value(120));
  EXPECT_EQ(info.at("distortion_model"), Value("plumb_bob"));
  EXPECT_EQ(info.at("K").as<Value::List>()->at(0), Value(140.0));
  EXPECT_EQ(info.at("D").as<Value::List>()->at(4), Value(0.5));
  EXPECT_EQ(info.at("P").as<Value::List>()->size(), 12U);
}

TEST_F(RecordedCameraInfoTest, TakesTheFrameWithoutItsLeadingSlash) {
  EXPECT_EQ(readCameraInfo({file}, "front/camera_info").frame, "front_optical");
}

TEST_F(RecordedCameraInfoTest, SaysWhenACalibrationChanges) {
  EXPECT_THAT(readCameraInfo({file}, "/rear/camera_info").notes, ::testing::IsEmpty());
  EXPECT_THAT(readCameraInfo({file}, "/front/camera_info").notes,
              ::testing::ElementsAre("the calibration '/front/camera_info' of 160 x 120 pixels "
                                     "changes in its numbers at 1.100000000 s; all scenes have the "
                                     "first one"));
}

TEST_F(RecordedCameraInfoTest, SaysWhenACalibrationChangesItsSize) {
  const std::string changing = test::BagBuilder(folder / "changing.bag")
                                   .calibrate("/camera_info", "camera", milliseconds(1000), 140)
                                   .resizeCamera(320, 240)
                                   .calibrate("/camera_info", "camera", milliseconds(2000), 280)
                                   .calibrate("/camera_info", "camera", milliseconds(3000), 280)
                                   .close();
  EXPECT_THAT(readCameraInfo({changing}, "/camera_info").notes,
              ::testing::ElementsAre(HasSubstr("of 160 x 120 pixels changes to 320 x 240 pixels at "
                                               "2.000000000 s;")));
}

TEST_F(RecordedCameraInfoTest, LooksIntoAllBags) {
  const std::string other =
      test::BagBuilder(folder / "other.bag").say("/chatter", milliseconds(1)).close();
  EXPECT_EQ(readCameraInfo({other, file}, "/rear/camera_info").frame, "rear_optical");
}

TEST_F(RecordedCameraInfoTest, NamesTheTopicsThatThereAre) {
  EXPECT_THAT(failure("/left/camera_info"),
              AllOf(HasSubstr("'/left/camera_info'"),
                    HasSubstr("it has /front/camera_info, /rear/camera_info")));
}

TEST_F(RecordedCameraInfoTest, NamesTheTypeOfATopicThatIsNoCalibration) {
  EXPECT_THAT(failure("/chatter"),
              AllOf(HasSubstr("std_msgs/String"), HasSubstr("sensor_msgs/CameraInfo")));
}

}  // namespace recorded_camera_info_test
}  // namespace synthetic_dataset::motion
