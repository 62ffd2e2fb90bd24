#include "motion/recorded/recorded_pictures.h"

#include <functional>
#include <variant>

#include <gmock/gmock.h>

#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::motion {
namespace recorded_pictures_test {

using test::BagBuilder;
using test::milliseconds;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

cv::Mat grey(int value, const cv::Size& size = {4, 2}) {
  return {size, CV_8UC1, cv::Scalar(value)};
}

/// The first pixel's value.
int valueOf(const RecordedPicture& picture) { return std::get<base::RawPicture>(picture).data[0]; }

class RecordedPicturesTest : public ::testing::Test {
 protected:
  std::string write(const std::function<void(BagBuilder&)>& fill,
                    const std::string& name = "run.bag") const {
    BagBuilder bag(folder / name);
    fill(bag);
    return bag.close();
  }

  [[nodiscard]] static std::vector<std::string> errors(const std::vector<std::string>& files,
                                                       const std::string& topic) {
    return test::messagesOf([&] { const RecordedPictures pictures(files, topic); });
  }

  test::TemporaryFolder folder;
};

TEST_F(RecordedPicturesTest, AreReadInTheOrderOfTheirStampsFromAllBags) {
  const std::string late =
      write([](BagBuilder& bag) { bag.picture("/eye", milliseconds(3000), grey(3), "mono8"); });
  const std::string early = write(
      [](BagBuilder& bag) {
        bag.picture("/eye", milliseconds(1000), grey(1), "mono8");
        bag.picture("/other", milliseconds(1000), grey(9), "mono8");
        bag.picture("/eye", milliseconds(2000), grey(2, {6, 5}), "mono8");
      },
      "early.bag");
  const RecordedPictures pictures({late, early}, "eye");
  ASSERT_EQ(pictures.heads().size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(pictures.heads()[i].stamp, milliseconds(1000 * (static_cast<int>(i) + 1)));
    EXPECT_EQ(valueOf(pictures.read(i)), static_cast<int>(i) + 1);
  }
  EXPECT_EQ(pictures.heads()[1].width, 6U);
  EXPECT_EQ(pictures.heads()[1].height, 5U);
}

TEST_F(RecordedPicturesTest, WithTheStampOfAnotherAreLeftOutAndCounted) {
  const RecordedPictures pictures({write([](BagBuilder& bag) {
                                    bag.picture("/eye", milliseconds(1000), grey(1), "mono8");
                                    bag.picture("/eye", milliseconds(1000), grey(2), "mono8");
                                    bag.picture("/eye", milliseconds(1500), grey(3), "mono8");
                                  })},
                                  "/eye");
  ASSERT_EQ(pictures.heads().size(), 2U);
  EXPECT_EQ(valueOf(pictures.read(0)), 1);
  EXPECT_EQ(valueOf(pictures.read(1)), 3);
  EXPECT_EQ(pictures.repeatedCount(), 1);
}

TEST_F(RecordedPicturesTest, ThatCannotBeReadSayWhy) {
  const std::string file = write([](BagBuilder& bag) {
    bag.picture("/eye", milliseconds(1000), grey(1), "mono12");
    bag.pictureFile("/eye/compressed", milliseconds(2000), "jpeg", {0xFF, 0xD8, 0xFF, 0xE0, 0, 16});
  });
  EXPECT_THAT(RecordedPictures({file}, "/eye").heads()[0].problem,
              HasSubstr("has the encoding 'mono12'"));
  EXPECT_THAT(RecordedPictures({file}, "/eye/compressed").heads()[0].problem,
              HasSubstr("of format 'jpeg' cannot be decoded"));
}

TEST_F(RecordedPicturesTest, AreOfATopicThatIsThere) {
  const std::string file = write([](BagBuilder& bag) {
    bag.picture("/eye/image", milliseconds(1000), grey(1), "mono8");
    bag.pictureFile("/eye/image/compressed", milliseconds(1000), "jpeg", {1});
    bag.say("/chatter", milliseconds(1000));
  });
  EXPECT_THAT(errors({file}, "/eye/imag"),
              ElementsAre(AllOf(HasSubstr("a topic that the recording does not have"),
                                HasSubstr("/eye/image, /eye/image/compressed"),
                                HasSubstr("did you mean '/eye/image'"))));
  EXPECT_THAT(
      errors({file}, "/chatter"),
      ElementsAre(AllOf(HasSubstr("whose messages are std_msgs/String"),
                        HasSubstr("sensor_msgs/Image"), HasSubstr("sensor_msgs/CompressedImage"))));
}

TEST_F(RecordedPicturesTest, WhoseTimeGoesBackAreRefused) {
  const std::string reset = write([](BagBuilder& bag) {
    for (const int stamp : {5000, 6000}) {
      bag.picture("/eye", milliseconds(stamp), grey(1), "mono8");
    }
  });
  const std::string again =
      write([](BagBuilder& bag) { bag.pictureAt("/eye", milliseconds(7000), milliseconds(1000)); },
            "again.bag");
  EXPECT_THAT(errors({reset, again}, "/eye"),
              ElementsAre(HasSubstr("go back from 6.000000000 s to 1.000000000 s")));
}

}  // namespace recorded_pictures_test
}  // namespace synthetic_dataset::motion
