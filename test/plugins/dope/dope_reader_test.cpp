#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace dope_reader_test {

class DopeReader : public ReaderTest {
 protected:
  DopeReader() : ReaderTest("Dope") {}
};

TEST_F(DopeReader, ReadsCuboidsInBothStyles) {
  const auto file = image("00000000.png");
  const std::string places = "[[1, 1], [5, 1], [5, 5], [1, 5], [2, 2], [6, 2], [6, 6], [2, 6]";
  for (const std::string& rest :
       {std::string(", [3, 4]], \"bounding_box_minx_maxx_miny_maxy\": [10, 13, 20, 24]"),
        std::string("], \"projected_cuboid_centroid\": [3, 4], \"bounding_box\": {"
                    "\"top_left\": [20, 10], \"bottom_right\": [25, 14]}")}) {
    const auto labels = folder_.write(
        "00000000.json",
        "{\"objects\": [{\"class\": \"a\", \"projected_cuboid\": " + places + rest + "}]}");
    const LabelledPicture read = readScene({labels, file});
    ASSERT_EQ(read.labels.size(), 1U);
    EXPECT_EQ(read.labels[0].lines.size(), 12U);
    EXPECT_TRUE(hasLine(read.labels[0], {1, 5}, {1, 1}));
    EXPECT_TRUE(hasLine(read.labels[0], {5, 5}, {6, 6}));
    EXPECT_EQ(read.labels[0].keypoints.at(0), cv::Point2d(3.0, 4.0));
    EXPECT_EQ(read.labels[0].box->left, 9.5);
    EXPECT_EQ(read.labels[0].box->right, 13.5);
    EXPECT_EQ(read.labels[0].box->top, 19.5);
    EXPECT_EQ(read.labels[0].box->bottom, 24.5);
  }
}

}  // namespace dope_reader_test
}  // namespace synthetic_dataset::formats
