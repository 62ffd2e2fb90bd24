#include "randomize/placement/map_file.h"

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace map_file_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A file as written by map_saver.
constexpr char kSaved[] = R"(image: office.pgm
resolution: 0.050000
origin: [-12.5, 3.25, 0.5]
negate: 0
occupied_thresh: 0.65
free_thresh: 0.196
)";

class MapFileTest : public ::testing::Test {
 protected:
  [[nodiscard]] MapFile read(const std::string& text) const {
    return readMapYaml(folder.write("maps/office.yaml", text).string());
  }

  [[nodiscard]] std::vector<std::string> faultsOf(const std::string& text) const {
    return test::messagesOf([&] { static_cast<void>(read(text)); });
  }

  /// The only fault of a file, without the file's name, with which its message has to begin.
  [[nodiscard]] std::string faultOf(const std::string& text) const {
    const std::vector<std::string> faults = faultsOf(text);
    const std::string start = (folder / "maps/office.yaml").string() + ": ";
    if (faults.size() != 1 || faults[0].rfind(start, 0) != 0) {
      return "not one fault: " + ::testing::PrintToString(faults);
    }
    return faults[0].substr(start.size());
  }

  static std::string with(const std::string& old_text, const std::string& new_text) {
    std::string text = kSaved;
    return text.replace(text.find(old_text), old_text.size(), new_text);
  }

  test::TemporaryFolder folder;
};

TEST_F(MapFileTest, IsReadAsMapSaverWritesIt) {
  const MapFile map = read(kSaved);
  EXPECT_EQ(map.resolution, 0.05);
  EXPECT_EQ(map.x, -12.5);
  EXPECT_EQ(map.y, 3.25);
  EXPECT_EQ(map.yaw, 0.5);
  EXPECT_FALSE(map.negate);
  EXPECT_EQ(map.occupied_threshold, 0.65);
  EXPECT_EQ(map.free_threshold, 0.196);
  EXPECT_EQ(map.mode, MapMode::kTrinary);
}

TEST_F(MapFileTest, LooksForTheImageFromItsOwnFolder) {
  EXPECT_EQ(read(kSaved).image, (folder / "maps/office.pgm").string());
  EXPECT_EQ(read(with("office.pgm", "../pictures/a.png")).image,
            (folder / "pictures/a.png").string());
  EXPECT_EQ(read(with("office.pgm", "/srv/a.png")).image, "/srv/a.png");
}

TEST_F(MapFileTest, KnowsTheModes) {
  EXPECT_EQ(read(kSaved + std::string("mode: trinary\n")).mode, MapMode::kTrinary);
  EXPECT_EQ(read(kSaved + std::string("mode: scale\n")).mode, MapMode::kScale);
  EXPECT_EQ(read(kSaved + std::string("mode: raw\n")).mode, MapMode::kRaw);
}

TEST_F(MapFileTest, TakesNegateAsANumberOrAsYesOrNo) {
  EXPECT_TRUE(read(with("negate: 0", "negate: 1")).negate);
  EXPECT_TRUE(read(with("negate: 0", "negate: true")).negate);
  EXPECT_FALSE(read(with("negate: 0", "negate: false")).negate);
}

TEST_F(MapFileTest, PassesOverFieldsOfOtherPrograms) {
  EXPECT_EQ(read(kSaved + std::string("cost_scale: [1, 2]\n")).resolution, 0.05);
}

TEST_F(MapFileTest, NamesAllThatIsMissing) {
  EXPECT_THAT(
      faultsOf("{}"),
      ElementsAre(HasSubstr("image: required"), HasSubstr("resolution: required"),
                  HasSubstr("origin: required"), HasSubstr("negate: required"),
                  HasSubstr("occupied_thresh: required"), HasSubstr("free_thresh: required")));
}

TEST_F(MapFileTest, NamesAllThatIsWrong) {
  EXPECT_THAT(
      faultsOf("image: ''\nresolution: 0\norigin: [1, 2]\nnegate: 2\n"
               "occupied_thresh: 1.5\nfree_thresh: -1\nmode: grey\n"),
      ElementsAre(HasSubstr("image: found an empty text"), HasSubstr("resolution: "),
                  HasSubstr("origin: "), HasSubstr("negate: "), HasSubstr("occupied_thresh: "),
                  HasSubstr("free_thresh: "), HasSubstr("mode: ")));
}

TEST_F(MapFileTest, RefusesCellsWithoutASize) {
  const std::string should = "it should be above 0: the metres of a cell";
  EXPECT_EQ(faultOf(with("0.050000", "0")), "resolution: found 0.0; " + should);
  EXPECT_EQ(faultOf(with("0.050000", "-0.05")), "resolution: found -0.05; " + should);
  EXPECT_THAT(faultOf(with("0.050000", ".nan")), HasSubstr("resolution: found"));
}

TEST_F(MapFileTest, RefusesAnOriginOfOtherNumbersThanThree) {
  EXPECT_EQ(faultOf(with("3.25, 0.5", "3.25")),
            "origin: found 2 numbers; it should be 3: [x, y, yaw] in metres and radians");
  EXPECT_THAT(faultOf(with("[-12.5, 3.25, 0.5]", "home")), HasSubstr("origin: found home"));
}

TEST_F(MapFileTest, RefusesThresholdsThatAreNotInOrder) {
  EXPECT_EQ(faultOf(with("0.196", "0.65")),
            "free_thresh: found 0.65; it should be less than occupied_thresh, 0.65");
  EXPECT_EQ(faultOf(with("0.65", "65")), "occupied_thresh: found 65.0; it should be 0 to 1");
}

TEST_F(MapFileTest, RefusesAModeThatMapServerDoesNotHave) {
  EXPECT_EQ(faultOf(kSaved + std::string("mode: grey\n")),
            "mode: found 'grey'; it should be trinary, scale or raw");
}

TEST_F(MapFileTest, RefusesAnotherNegate) {
  EXPECT_EQ(faultOf(with("negate: 0", "negate: 2")), "negate: found 2; it should be 0 or 1");
}

TEST_F(MapFileTest, ThatIsNotThereIsNamed) {
  try {
    static_cast<void>(readMapYaml("/no/such/map.yaml"));
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("/no/such/map.yaml: no such file"));
  }
}

}  // namespace map_file_test
}  // namespace synthetic_dataset::randomize
