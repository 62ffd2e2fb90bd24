#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "support/error_messages.h"

namespace synthetic_dataset::formats {
namespace bounding_shape_reader_test {

using testing::HasSubstr;

class BoundingShapeReader : public ReaderTest {
 protected:
  BoundingShapeReader() : ReaderTest("BoundingShape") {}

  [[nodiscard]] std::vector<DrawnLabel> read(const std::string& text) const {
    return readScene({image("00000000.png"), folder_.write("00000000.txt", text)}).labels;
  }
};

TEST_F(BoundingShapeReader, ReadsALabelOfEachLine) {
  const auto labels = read("rover 0.25000 -1.50000 2.00000 1.00000 1.00000 1.00000\n7\n");
  ASSERT_EQ(labels.size(), 2U);
  EXPECT_EQ(labels[0].object_name, "rover");
  EXPECT_EQ(labels[0].caption, "rover: 2 vertices");
  EXPECT_EQ(labels[1].object_name, "7");
  EXPECT_EQ(labels[1].caption, "7: 0 vertices");
}

TEST_F(BoundingShapeReader, ReadsIdsOfSeveralWordsAndOfNone) {
  EXPECT_EQ(read("fork lift v1.5 0.25000 -1.50000 2.00000\n")[0].object_name, "fork lift v1.5");
  EXPECT_EQ(read(" 0.25000 -1.50000 2.00000\n")[0].object_name, "");
}

TEST_F(BoundingShapeReader, NamesAFileWithWhatIsNoNumber) {
  EXPECT_THAT(test::messagesOf([&] { (void)read("rover 0.25000 -1.5.000 2.00000\n"); }),
              testing::ElementsAre(HasSubstr("found '-1.5.000'; it should be a number")));
}

}  // namespace bounding_shape_reader_test
}  // namespace synthetic_dataset::formats
