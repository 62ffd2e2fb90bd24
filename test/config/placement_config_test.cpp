#include "config/readers.h"

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace placement_config_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Reading {
  explicit Reading(const std::string& text) : root(base::parseYaml(text, "test")) {
    placement = readPlacement(root);
  }
  Parameters root;
  randomize::PlacementOptions placement;
};

TEST(ReadPlacement, TakesAMapForEnough) {
  const Reading reading("placement: {map: /maps/hall.yaml}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  const randomize::PlacementOptions& placement = reading.placement;
  EXPECT_EQ(placement.mode, randomize::PlacementMode::kMap);
  EXPECT_EQ(placement.map_file, "/maps/hall.yaml");
  EXPECT_EQ(placement.map_topic, std::nullopt);
  EXPECT_TRUE(placement.on_surface);
  EXPECT_EQ(placement.surface.highest, 2.0);
  EXPECT_EQ(placement.surface.steepest, 0.35);
  EXPECT_EQ(placement.surface.unevenness, 0.05);
  EXPECT_EQ(placement.tries, 1000);
}

TEST(ReadPlacement, ReadsHowThingsStandOnAMap) {
  const Reading reading(
      "placement: {mode: map, map_topic: /map, surface: below, highest_surface: -1.5, steepest: "
      "0, unevenness: 0, tries: 7}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_THAT(reading.root.unknownNames(), IsEmpty());
  const randomize::PlacementOptions& placement = reading.placement;
  EXPECT_EQ(placement.map_file, std::nullopt);
  EXPECT_EQ(placement.map_topic, "/map");
  EXPECT_EQ(placement.surface.highest, -1.5);
  EXPECT_EQ(placement.surface.steepest, 0.0);
  EXPECT_EQ(placement.surface.unevenness, 0.0);
  EXPECT_EQ(placement.tries, 7);
}

TEST(ReadPlacement, ReadsAHeightInsteadOfASurface) {
  const Reading reading("placement: {map: /a.yaml, surface: none, height: 1.25}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_FALSE(reading.placement.on_surface);
  EXPECT_EQ(reading.placement.height, 1.25);
  EXPECT_EQ(Reading("placement: {map: /a.yaml, surface: none}").placement.height, 0.0);
}

TEST(ReadPlacement, ReadsTheGround) {
  const Reading all("placement: {mode: ground}");
  EXPECT_THAT(all.root.errors(), IsEmpty());
  EXPECT_EQ(all.placement.mode, randomize::PlacementMode::kGround);
  EXPECT_FALSE(all.placement.area.has_value());
  const Reading part(
      "placement: {mode: ground, area: {min: [-1, 2], max: [3, 4.5]}, highest_surface: 9}");
  EXPECT_THAT(part.root.errors(), IsEmpty());
  EXPECT_EQ(part.placement.area->low, Eigen::Vector2d(-1, 2));
  EXPECT_EQ(part.placement.area->high, Eigen::Vector2d(3, 4.5));
  EXPECT_EQ(part.placement.surface.highest, 9.0);
}

TEST(ReadPlacement, ReadsAVolume) {
  const Reading reading("placement: {mode: volume, volume: {min: [-1, 2, 0.5], max: [1, 2, 3]}}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.placement.mode, randomize::PlacementMode::kVolume);
  EXPECT_EQ(reading.placement.volume.low, Eigen::Vector3d(-1, 2, 0.5));
  EXPECT_EQ(reading.placement.volume.high, Eigen::Vector3d(1, 2, 3));
  EXPECT_FALSE(reading.placement.upright);
}

TEST(ReadPlacement, ReadsHowThingsAreTurnedInAVolume) {
  const std::string volume = "placement: {mode: volume, volume: {min: [0, 0, 0], max: [1, 1, 1]}";
  EXPECT_TRUE(Reading(volume + ", orientation: upright}").placement.upright);
  EXPECT_FALSE(Reading(volume + ", orientation: random}").placement.upright);
  EXPECT_EQ(Reading(volume + "}").placement.rows, 0.0);
  EXPECT_EQ(Reading(volume + ", rows: 0.25}").placement.rows, 0.25);
}

TEST(ReadPlacement, ReadsADrop) {
  const std::string drop = "placement: {mode: drop, volume: {min: [0, 0, 1], max: [1, 1, 2]}";
  const Reading reading(drop + ", fall_time: 4}");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_EQ(reading.placement.mode, randomize::PlacementMode::kDrop);
  EXPECT_EQ(reading.placement.fall_time, 4.0);
  EXPECT_EQ(Reading(drop + "}").placement.fall_time, 10.0);
}

TEST(ReadPlacement, TellsTheDefaultsThatItTook) {
  EXPECT_THAT(
      Reading("placement: {map: /a.yaml}").root.defaultsTaken(),
      ::testing::UnorderedElementsAre("placement/mode: map", "placement/surface: below",
                                      "placement/highest_surface: 2.0", "placement/steepest: 0.35",
                                      "placement/unevenness: 0.05", "placement/tries: 1000"));
}

struct BadPlacement {
  std::string text;
  std::string message;
};

class BadPlacements : public ::testing::TestWithParam<BadPlacement> {};

TEST_P(BadPlacements, AreNamedWithWhatWouldBeRight) {
  EXPECT_THAT(Reading("placement: {" + GetParam().text + "}").root.errors(),
              ElementsAre(HasSubstr(GetParam().message)));
}

const char kVolume[] = "mode: volume, volume: {min: [0, 0, 0], max: [1, 1, 1]}";
const char kDrop[] = "mode: drop, volume: {min: [0, 0, 0], max: [1, 1, 1]}";

INSTANTIATE_TEST_SUITE_P(
    ReadPlacement, BadPlacements,
    ::testing::Values(
        BadPlacement{
            "mode: mep, map: /a.yaml",
            "placement/mode: found 'mep'; it should be map, ground, volume or drop; did you mean "
            "'map'?"},
        BadPlacement{"",
                     "placement/map: no map; it should name map_server's YAML file, or "
                     "map_topic a topic of the bag or of the running system"},
        BadPlacement{"map: /a.yaml, map_topic: /map",
                     "placement/map: found together with map_topic"},
        BadPlacement{"map: /a.yaml, received_map: {width: 3}",
                     "placement/received_map: found without map_topic"},
        BadPlacement{"map: 3", "placement/map: found 3"},
        BadPlacement{"map: /a.yaml, surface: above",
                     "placement/surface: found 'above'; it should be below or none"},
        BadPlacement{"map: /a.yaml, steepest: -0.1",
                     "placement/steepest: found -0.1; it should be 0.0 to 1.5"},
        BadPlacement{"map: /a.yaml, steepest: 1.6", "placement/steepest: found 1.6"},
        BadPlacement{"map: /a.yaml, unevenness: -1", "placement/unevenness: found -1.0"},
        BadPlacement{"map: /a.yaml, highest_surface: low", "placement/highest_surface: found low"},
        BadPlacement{"map: /a.yaml, surface: none, height: low", "placement/height: found low"},
        BadPlacement{"map: /a.yaml, height: 0.3",
                     "placement/height: has a meaning with surface: none alone"},
        BadPlacement{"map: /a.yaml, surface: none, steepest: 0.1",
                     "placement/steepest: has a meaning with surface: below alone"},
        BadPlacement{"map: /a.yaml, volume: {min: [0, 0, 0], max: [1, 1, 1]}",
                     "placement/volume: has a meaning with mode: volume or drop alone"},
        BadPlacement{"map: /a.yaml, rows: 0.5",
                     "placement/rows: has a meaning with mode: volume or drop alone"},
        BadPlacement{std::string(kVolume) + ", rows: 2",
                     "placement/rows: found 2.0; it should be 0.0 to 1.0"},
        BadPlacement{"map: /a.yaml, orientation: upright",
                     "placement/orientation: has a meaning with mode: volume or drop alone"},
        BadPlacement{"map: /a.yaml, fall_time: 3",
                     "placement/fall_time: has a meaning with mode: drop alone"},
        BadPlacement{std::string(kVolume) + ", fall_time: 3",
                     "placement/fall_time: has a meaning with mode: drop alone"},
        BadPlacement{std::string(kVolume) + ", map: /a.yaml",
                     "placement/map: has a meaning with mode: map alone"},
        BadPlacement{std::string(kDrop) + ", steepest: 0.1",
                     "placement/steepest: has a meaning with mode: map or ground alone"},
        BadPlacement{"map: /a.yaml, tries: 0", "placement/tries: found 0; it should be 1 to"},
        BadPlacement{"mode: volume", "placement/volume: missing; it should be {min: [x, y, z]"},
        BadPlacement{"mode: drop", "placement/volume: missing"},
        BadPlacement{"mode: volume, volume: {min: [0, 0], max: [1, 1, 1]}",
                     "placement/volume/min: found 2 numbers; it should be [x, y, z] in metres"},
        BadPlacement{"mode: volume, volume: {min: [], max: [1, 1, 1]}",
                     "placement/volume/min: found 0 numbers"},
        BadPlacement{"mode: volume, volume: {min: [0, 0, 0]}",
                     "placement/volume/max: required, but missing"},
        BadPlacement{"mode: volume, volume: {min: [0, 0, 2], max: [1, 1, 1]}",
                     "placement/volume: found a min above the max"},
        BadPlacement{std::string(kVolume) + ", orientation: up",
                     "placement/orientation: found 'up'; it should be random or upright"},
        BadPlacement{std::string(kDrop) + ", fall_time: 0",
                     "placement/fall_time: found 0.0; it should be above 2.5"}));

}  // namespace placement_config_test
}  // namespace synthetic_dataset::config
