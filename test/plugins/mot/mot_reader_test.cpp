#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "support/error_messages.h"

namespace synthetic_dataset::formats {
namespace mot_reader_test {

using testing::ElementsAre;
using testing::HasSubstr;

class MotReader : public ReaderTest {
 protected:
  MotReader() : ReaderTest("Mot") {}
};

TEST_F(MotReader, FindsAScenesFrame) {
  const auto file = image("scenes/00000007.png");
  image("val/camera/img1/000002.png");
  folder_.write("frames.txt",
                "val/camera 1 scenes/00000006.png\nval/camera 2 scenes/00000007.png\n");
  folder_.write("val/camera/gt/labels.txt", "rover\nfork lift\n");
  folder_.write("val/camera/gt/gt.txt",
                "1,1,5,5,5,5,1,1,1\n2,9,11,21,30,40,1,2,0.5\n2,3,1,1,2,2,0,1,0.1\n");
  const LabelledPicture read = readScene({file}, "00000007");
  ASSERT_EQ(read.labels.size(), 2U);
  EXPECT_EQ(read.labels[0].caption, "fork lift 9");
  EXPECT_THAT(read.labels[0].class_names, ElementsAre("fork lift"));
  // Pixels 10 to 39 and 20 to 59, counted from 0.
  EXPECT_EQ(read.labels[0].box->left, 9.5);
  EXPECT_EQ(read.labels[0].box->bottom, 59.5);
  EXPECT_EQ(read.labels[1].caption, "rover 3 (0)");
}

TEST_F(MotReader, NamesWhatIsNotAsItShouldBe) {
  const auto file = image("scenes/00000007.png");
  folder_.write("frames.txt", "val/camera 1 scenes/00000006.png\n");
  EXPECT_THAT(test::messagesOf([&] { (void)readScene({file}); }),
              ElementsAre(HasSubstr("frames.txt': it does not list 'scenes/00000007.png'")));
}

}  // namespace mot_reader_test
}  // namespace synthetic_dataset::formats
