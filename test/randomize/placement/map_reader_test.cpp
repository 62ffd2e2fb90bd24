#include "randomize/placement/map_reader.h"

#include <filesystem>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace map_reader_test {

using ::testing::AllOf;
using ::testing::HasSubstr;

/// A row of cells from left to right: F free, O occupied, U unknown.
std::string rowOf(const OccupancyMap& map, std::size_t row) {
  std::string text;
  for (std::size_t column = 0; column < map.width(); ++column) {
    text += "FOU"[static_cast<int>(map.cell(column, row))];
  }
  return text;
}

/// A picture with the bytes of a PGM file (netpbm's pgm(5)).
std::string pgm(int width, int height, const std::string& bytes) {
  return "P5\n" + std::to_string(width) + " " + std::to_string(height) + "\n255\n" + bytes;
}

std::string bytes(const std::vector<int>& numbers) { return {numbers.begin(), numbers.end()}; }

class MapReader : public ::testing::Test {
 protected:
  /// map.yaml beside a picture, with map_saver's thresholds.
  [[nodiscard]] std::string yaml(const std::string& image, const std::string& more = "") const {
    const std::string negate = more.find("negate") == std::string::npos ? "negate: 0\n" : "";
    return folder
        .write("map.yaml", "image: " + image +
                               "\nresolution: 0.05\norigin: [-1, 2, 0.5]\n"
                               "occupied_thresh: 0.65\nfree_thresh: 0.196\n" +
                               negate + more)
        .string();
  }

  [[nodiscard]] OccupancyMap readPgm(int width, int height, const std::vector<int>& shades,
                                     const std::string& more = "") const {
    folder.write("map.pgm", pgm(width, height, bytes(shades)));
    return readMapFile(yaml("map.pgm", more));
  }

  /// The cells of a PNG picture of one row.
  template <class Pixel>
  [[nodiscard]] std::string rowOfPng(const std::vector<Pixel>& pixels,
                                     const std::string& more = "") const {
    cv::imwrite((folder / "map.png").string(), cv::Mat(pixels).reshape(0, 1));
    return rowOf(readMapFile(yaml("map.png", more)), 0);
  }

  [[nodiscard]] std::string errorOf(const std::string& file) const {
    try {
      static_cast<void>(readMapFile(file));
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  test::TemporaryFolder folder;
};

/// The picture's upper row, then its lower row: map_saver's shades for free, unknown and occupied,
/// and the shades next to the thresholds. (255 - shade) / 255 is 0.192 for 206, which is free; just
/// above 0.196 for 205 and 0.647 for 90, both unknown; and 0.651 for 89, which is occupied.
const std::vector<int> kShades = {254, 205, 0, 89, 90, 206};

TEST_F(MapReader, HasThePicturesLowestRowFirst) {
  const OccupancyMap map = readPgm(3, 2, kShades);
  EXPECT_EQ(map.width(), 3U);
  EXPECT_EQ(map.height(), 2U);
  EXPECT_EQ(rowOf(map, 0), "OUF");
  EXPECT_EQ(rowOf(map, 1), "FUO");
}

TEST_F(MapReader, TakesResolutionAndOriginFromTheFile) {
  const OccupancyMap map = readPgm(3, 2, kShades);
  EXPECT_EQ(map.resolution(), 0.05);
  EXPECT_EQ(map.pose().x, -1.0);
  EXPECT_EQ(map.pose().y, 2.0);
  EXPECT_EQ(map.pose().z, 0.0);
  EXPECT_EQ(map.pose().yaw, 0.5);
}

TEST_F(MapReader, NegatesShades) {
  // 255 less the shades: 1, 50, 255 above; 166, 165, 49 below.
  const OccupancyMap map = readPgm(3, 2, kShades, "negate: 1\n");
  EXPECT_EQ(rowOf(map, 0), "UUO");
  EXPECT_EQ(rowOf(map, 1), "OOF");
}

TEST_F(MapReader, ReadsTextPgm) {
  folder.write("map.pgm", "P2\n# drawn by hand\n3 2\n255\n254 205 0\n89 90 206\n");
  const OccupancyMap map = readMapFile(yaml("map.pgm"));
  EXPECT_EQ(rowOf(map, 0), "OUF");
  EXPECT_EQ(rowOf(map, 1), "FUO");
}

TEST_F(MapReader, TakesWhatScaleGradesForUnknown) {
  const OccupancyMap map = readPgm(3, 2, kShades, "mode: scale\n");
  EXPECT_EQ(rowOf(map, 0), "OUF");
  EXPECT_EQ(rowOf(map, 1), "FUO");
}

TEST_F(MapReader, TakesRawShadesForPercentages) {
  // 19 % and 66 % are beyond the thresholds, 20 % and 65 % are not; above 100 is not a percentage.
  const OccupancyMap map = readPgm(8, 1, {0, 19, 20, 65, 66, 100, 101, 255}, "mode: raw\n");
  EXPECT_EQ(rowOf(map, 0), "FFUUOOUU");
}

TEST_F(MapReader, NegatesRawShades) {
  const OccupancyMap map = readPgm(4, 1, {255, 236, 155, 0}, "mode: raw\nnegate: 1\n");
  EXPECT_EQ(rowOf(map, 0), "FFOU");
}

TEST_F(MapReader, AveragesColours) {
  // Means of 205.33 and 205: 0.1948 and 0.1961.
  EXPECT_EQ(rowOfPng<cv::Vec3b>({{255, 255, 106}, {106, 255, 255}, {255, 105, 255}}), "FFU");
}

TEST_F(MapReader, AveragesAlphaInTrinaryModeOnly) {
  // Means of all four channels: 213.75, 191.25 and 63.75, or 0.162, 0.25 and 0.75; means of three
  // channels: 200, 255 and 0.
  const std::vector<cv::Vec4b> pixels = {{200, 200, 200, 255}, {255, 255, 255, 0}, {0, 0, 0, 255}};
  EXPECT_EQ(rowOfPng(pixels), "FUO");
  EXPECT_EQ(rowOfPng(pixels, "mode: scale\n"), "UFO");
}

TEST_F(MapReader, AveragesRawColoursDownToWholeNumbers) {
  // Means of 19.67 and 20 without alpha.
  EXPECT_EQ(rowOfPng<cv::Vec4b>({{20, 20, 19, 90}, {20, 20, 20, 0}}, "mode: raw\n"), "FU");
}

TEST_F(MapReader, TakesTheUpperByteOfSixteenBits) {
  constexpr int kByte = 256;
  EXPECT_EQ(rowOfPng<std::uint16_t>({206 * kByte, 205 * kByte + 255, 65535, 255}), "FUFO");
}

TEST_F(MapReader, NamesAPictureThatIsNotThere) {
  const std::string file = yaml("none.pgm");
  EXPECT_EQ(errorOf(file), file + ": image: picture '" + (folder / "none.pgm").string() +
                               "' is not a file; a relative path starts at the folder of the "
                               "YAML file");
  std::filesystem::create_directory(folder / "none.pgm");
  EXPECT_THAT(errorOf(file), HasSubstr("is a folder; a file is needed"));
}

TEST_F(MapReader, NamesWhatIsNoPicture) {
  for (const std::string& content :
       {std::string("no picture"), std::string(), pgm(0, 0, ""), pgm(3, 2, "abc")}) {
    folder.write("map.pgm", content);
    EXPECT_THAT(errorOf(yaml("map.pgm")),
                AllOf(HasSubstr("map.yaml: image: picture '" + (folder / "map.pgm").string()),
                      HasSubstr("cannot be decoded")))
        << content;
  }
}

TEST_F(MapReader, NamesAllFaultsOfTheFile) {
  const std::string file = folder.write("map.yaml", "image: map.pgm\n").string();
  EXPECT_THAT(errorOf(file),
              AllOf(HasSubstr("resolution: required"), HasSubstr("origin: required")));
}

motion::RecordedMap recordedRow(const std::vector<std::int8_t>& cells) {
  motion::RecordedMap recorded;
  recorded.width = cells.size();
  recorded.height = 1;
  recorded.resolution = 0.25;
  recorded.frame = "map";
  recorded.cells = cells;
  return recorded;
}

TEST(MapOfRecording, TakesNumbersForPercentages) {
  EXPECT_EQ(rowOf(mapOf(recordedRow({0, 19, 20, 65, 66, 100, -1, 101, -128})), 0), "FFUUOOUUU");
}

TEST(MapOfRecording, IsFreeUpToTheThreshold) {
  // 100 * 0.29 is less than 29 in floating point.
  EXPECT_EQ(rowOf(mapOf(recordedRow({28, 29, 30}), {0.29, 0.295}), 0), "FFO");
}

TEST(MapOfRecording, KeepsRowsAndPlace) {
  motion::RecordedMap recorded = recordedRow({0, 100, 100, 0, -1, 0});
  recorded.width = 3;
  recorded.height = 2;
  recorded.X_FM =
      makePose({1, 2, 3}, Eigen::Quaterniond(Eigen::AngleAxisd(-2.5, Eigen::Vector3d::UnitZ())));
  const OccupancyMap map = mapOf(recorded);
  EXPECT_EQ(rowOf(map, 0), "FOO");
  EXPECT_EQ(rowOf(map, 1), "FUF");
  EXPECT_EQ(map.resolution(), 0.25);
  EXPECT_EQ(map.pose().x, 1.0);
  EXPECT_EQ(map.pose().y, 2.0);
  EXPECT_EQ(map.pose().z, 3.0);
  EXPECT_NEAR(map.pose().yaw, -2.5, 1e-12);
}

TEST(MapOfRecording, LiesFlat) {
  motion::RecordedMap recorded = recordedRow({0});
  recorded.X_FM.linear() = Eigen::AngleAxisd(0.1, Eigen::Vector3d::UnitX()).toRotationMatrix();
  EXPECT_THAT(test::messagesOf([&] { static_cast<void>(mapOf(recorded)); }),
              testing::ElementsAre(
                  HasSubstr("found a map that is tilted in 'map'; it should be turned about z")));
}

TEST_F(MapReader, SaysHowManyUnknownCellsCountAsFree) {
  folder.write("map.pgm", pgm(4, 1, bytes({205, 205, 254, 0})));
  const auto file = folder.write("map.yaml",
                                 "image: map.pgm\nresolution: 0.05\norigin: [0, 0, 0]\nnegate: 0\n"
                                 "occupied_thresh: 0.65\nfree_thresh: 0.25\n");
  std::vector<std::string> notes;
  const OccupancyMap map =
      readMapFile(file.string(), [&](const std::string& note) { notes.push_back(note); });
  EXPECT_EQ(rowOf(map, 0), "FFFO");
  EXPECT_THAT(notes, testing::ElementsAre(
                         testing::AllOf(testing::HasSubstr("50 % of its cells have the shade 205"),
                                        testing::HasSubstr("`free_thresh: 0.196`"))));
}

}  // namespace map_reader_test
}  // namespace synthetic_dataset::randomize
