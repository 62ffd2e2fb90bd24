#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "support/error_messages.h"

namespace synthetic_dataset::formats {
namespace kitti_reader_test {

using testing::HasSubstr;

class KittiReader : public ReaderTest {
 protected:
  KittiReader() : ReaderTest("Kitti") {}
};

TEST_F(KittiReader, ReadsBoxes) {
  const auto file = image("training/image_2/000000.png");
  folder_.write("training/calib/000000.txt", "P2: 100 0 50 0 0 100 40 0 0 0 1 0\n");
  // Turned by -90 degrees: its length of 4 m lies along the camera's z.
  folder_.write("training/label_2/000000.txt",
                "Car 0 0 0 10 20 30 40 1 2 4 0 1 8 -1.5707963267948966\n"
                "DontCare -1 -1 -10 1 2 3 4 -1 -1 -1 -1000 -1000 -1000 -10\n");
  const LabelledPicture read = readScene({file});
  ASSERT_EQ(read.labels.size(), 2U);
  EXPECT_EQ(read.labels[0].caption, "Car");
  EXPECT_EQ(read.labels[0].box->left, 9.5);
  EXPECT_EQ(read.labels[0].box->bottom, 39.5);
  // The near lower edge: 1 m to each side, 1 m down, 6 m away; the upper far one is 10 m away.
  EXPECT_TRUE(hasLine(read.labels[0], {50.0 - 100.0 / 6, 40.0 + 100.0 / 6},
                      {50.0 + 100.0 / 6, 40.0 + 100.0 / 6}));
  EXPECT_TRUE(hasLine(read.labels[0], {40.0, 40.0}, {60.0, 40.0}));
  EXPECT_TRUE(read.labels[1].lines.empty());
}

TEST_F(KittiReader, NamesAFileThatIsNotAsItShouldBe) {
  const auto file = image("training/image_2/000000.png");
  folder_.write("training/calib/000000.txt", "P0: 1\n");
  folder_.write("training/label_2/000000.txt", "");
  EXPECT_THAT(test::messagesOf([&] { (void)readScene({file}); }),
              testing::ElementsAre(HasSubstr("000000.txt': found no line of 'P2:'")));
}

}  // namespace kitti_reader_test
}  // namespace synthetic_dataset::formats
