#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "support/error_messages.h"

namespace synthetic_dataset::formats {
namespace kitti_tracking_reader_test {

using testing::ElementsAre;
using testing::HasSubstr;

class KittiTrackingReader : public ReaderTest {
 protected:
  KittiTrackingReader() : ReaderTest("KittiTracking") {
    file_ = image("scenes/00000007.png");
    image("training/image_02/0003/000001.png");
    folder_.write("frames.txt", "0003 1 scenes/00000007.png\n");
    folder_.write("training/calib/0003.txt", "P2: 100 0 50 0 0 100 40 0 0 0 1 0\n");
  }

  std::filesystem::path file_;
};

TEST_F(KittiTrackingReader, ReadsAFramesBoxes) {
  folder_.write("training/label_02/0003.txt",
                "0 5 Van 0 0 0 1 2 3 4 1 2 4 0 1 8 0\n"
                "1 5 Car 0 0 0 10 20 30 40 1 2 4 0 1 8 -1.5707963267948966\n"
                "1 -1 DontCare -1 -1 -10 1 2 3 4 -1000 -1000 -1000 -10 -1 -1 -1\n");
  const LabelledPicture read = readScene({file_}, "00000007");
  ASSERT_EQ(read.labels.size(), 2U);
  EXPECT_EQ(read.labels[0].caption, "Car 5");
  EXPECT_EQ(read.labels[0].box->left, 9.5);
  // As for KITTI's objects, the upper far edge is 10 m away.
  EXPECT_TRUE(hasLine(read.labels[0], {40.0, 40.0}, {60.0, 40.0}));
  EXPECT_TRUE(read.labels[1].lines.empty());
}

TEST_F(KittiTrackingReader, NamesAFileThatIsNotAsItShouldBe) {
  folder_.write("training/label_02/0003.txt", "1 5 Car 0 0\n");
  EXPECT_THAT(test::messagesOf([&] { (void)readScene({file_}); }),
              ElementsAre(HasSubstr("0003.txt': found a line of 5 columns")));
}

}  // namespace kitti_tracking_reader_test
}  // namespace synthetic_dataset::formats
