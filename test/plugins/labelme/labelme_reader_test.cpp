#include <gmock/gmock.h>

#include "plugins/reader_harness.h"
#include "support/error_messages.h"

namespace synthetic_dataset::formats {
namespace labelme_reader_test {

using testing::ElementsAre;
using testing::HasSubstr;

class LabelMeReader : public ReaderTest {
 protected:
  LabelMeReader() : ReaderTest("LabelMe") {}

  [[nodiscard]] LabelledPicture read(const std::string& shapes) const {
    image("train/0.png");
    return readScene(
        {folder_.write("train/0.json", R"({"imagePath": "0.png", "shapes": [)" + shapes + "]}")});
  }
};

TEST_F(LabelMeReader, ReadsPolygonsAndRectangles) {
  const LabelledPicture found = read(
      R"({"label": "cup", "description": "a", "shape_type": "polygon",
          "points": [[1, 2], [3, 2], [3, 5]]},
         {"label": "jug", "description": "b", "shape_type": "rectangle",
          "points": [[10, 20], [40, 60]]})");
  ASSERT_EQ(found.labels.size(), 2U);
  EXPECT_EQ(found.labels[0].caption, "cup");
  EXPECT_EQ(found.labels[0].object_name, "a");
  ASSERT_EQ(found.labels[0].polygons.size(), 1U);
  EXPECT_EQ(found.labels[0].polygons[0][2], cv::Point2d(3, 5));
  EXPECT_EQ(found.labels[1].box->left, 9.5);
  EXPECT_EQ(found.labels[1].box->bottom, 59.5);
}

TEST_F(LabelMeReader, NamesAFileThatIsNotAsItShouldBe) {
  EXPECT_THAT(test::messagesOf([&] {
                (void)read(R"({"label": "jug", "description": "b", "shape_type": "rectangle",
                               "points": [[10, 20]]})");
              }),
              ElementsAre(HasSubstr("0.json': found a rectangle that does not have two corners")));
}

}  // namespace labelme_reader_test
}  // namespace synthetic_dataset::formats
