#include <filesystem>
#include <vector>

#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace yolo_reader_test {

class YoloReader : public ReaderTest {
 protected:
  YoloReader() : ReaderTest("Yolo") {}
};

TEST_F(YoloReader, GivesBoxesInOpenCvsCoordinatesWhereverFractionsBegin) {
  // The left half of the image, whose first column's centre is 0 and whose edge is -0.5.
  const std::vector<std::filesystem::path> files = {
      image("00000000.png"), folder_.write("00000000.txt", "cup 0.25 0.5 0.5 1\n")};
  const auto boxOf = [&](const Value::Map& settings) {
    const Box box = *readScene(files, "00000000", settings).labels.at(0).box;
    return std::vector<double>{box.left, box.top, box.right, box.bottom};
  };
  EXPECT_THAT(boxOf({}), testing::ElementsAre(0.0, 0.0, 50.0, 80.0));
  EXPECT_THAT(boxOf({{"pixel_origin", "edge"}}), testing::ElementsAre(-0.5, -0.5, 49.5, 79.5));
}

}  // namespace yolo_reader_test
}  // namespace synthetic_dataset::formats
