#include <filesystem>
#include <vector>

#include <gmock/gmock.h>

#include "plugins/reader_harness.h"

namespace synthetic_dataset::formats {
namespace stvnet_reader_test {

class StvNetReader : public ReaderTest {
 protected:
  StvNetReader() : ReaderTest("StvNet") {}
};

TEST_F(StvNetReader, GivesKeypointsInOpenCvsCoordinatesWhereverFractionsBegin) {
  const std::vector<std::filesystem::path> files = {image("cup/JPEGImages/00000000.png")};
  picture("cup/mask/00000000.png", cv::Mat(80, 100, CV_8UC1, cv::Scalar::all(0)));
  folder_.write("cup/labels/00000000.txt", "7 0.50000 0.25000 ");
  const auto pointOf = [&](const Value::Map& settings) {
    return readScene(files, "00000000", settings).labels.at(0).keypoints.at(0);
  };
  EXPECT_EQ(pointOf({}), cv::Point2d(50.0, 20.0));
  EXPECT_EQ(pointOf({{"pixel_origin", "edge"}}), cv::Point2d(49.5, 19.5));
}

}  // namespace stvnet_reader_test
}  // namespace synthetic_dataset::formats
