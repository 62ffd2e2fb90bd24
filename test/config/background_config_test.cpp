#include "config/readers.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "base/yaml_value.h"
#include "config/config.h"

namespace synthetic_dataset::config {
namespace background_config_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

Parameters settings(const std::string& background) {
  return Parameters(base::parseYaml("background: " + background, "test"));
}

/// Reads a background in which nothing should be wrong or unknown.
randomize::BackgroundRandomization read(const std::string& background) {
  Parameters group = settings(background);
  randomize::BackgroundRandomization given = readBackground(group);
  EXPECT_THAT(group.errors(), IsEmpty()) << background;
  EXPECT_THAT(group.unknownNames(), IsEmpty()) << background;
  return given;
}

std::vector<std::string> errorsOf(const std::string& background) {
  Parameters group = settings(background);
  (void)readBackground(group);
  return group.errors();
}

TEST(BackgroundConfig, IsNothingWhereNothingIsGiven) {
  const randomize::BackgroundRandomization none = readBackground(Parameters(Value(Value::Map{})));
  EXPECT_FALSE(none.colour || none.pictures);
}

TEST(BackgroundConfig, ReadsAColourAloneOrInAGroup) {
  for (const char* text : {"[0.1, 0.2, 0.3]", "0.5", "{uniform: [0, 1]}",
                           "{normal: [0.5, 0.1], min: 0, max: 1}", "{choice: [0.1, 0.2]}"}) {
    const randomize::BackgroundRandomization alone = read(text);
    ASSERT_TRUE(alone.colour) << text;
    EXPECT_EQ(alone.colour->dimension(), 3U);
    EXPECT_EQ(alone.colour_name, "background");
    const randomize::BackgroundRandomization grouped = read(std::string("{colour: ") + text + "}");
    ASSERT_TRUE(grouped.colour) << text;
    EXPECT_EQ(grouped.colour->highest(), alone.colour->highest());
    EXPECT_EQ(grouped.colour_name, "background/colour");
    EXPECT_FALSE(grouped.pictures);
  }
}

TEST(BackgroundConfig, ReadsAFolderOfBackdrops) {
  const auto pictures = read("{pictures: /data/x/../photographs}").pictures;
  ASSERT_TRUE(pictures);
  EXPECT_EQ(pictures->folder, "/data/photographs");
  EXPECT_EQ(pictures->projection, randomize::BackgroundProjection::kBackdrop);
  EXPECT_FALSE(pictures->present || pictures->yaw || pictures->brightness);
}

TEST(BackgroundConfig, TakesNaturalForPicturesThatAreMadeUp) {
  const auto pictures = read("{pictures: natural, present: 0.5, brightness: 2}").pictures;
  ASSERT_TRUE(pictures);
  EXPECT_EQ(pictures->folder, "natural");
  EXPECT_EQ(read("{pictures: ./natural}").pictures->folder,
            (std::filesystem::current_path() / "natural").string());
}

TEST(BackgroundConfig, KnowsNoPanoramasThatAreMadeUp) {
  EXPECT_THAT(errorsOf("{pictures: natural, projection: panorama}"),
              ElementsAre(HasSubstr("background/projection: found panorama beside `pictures: "
                                    "natural`")));
}

TEST(BackgroundConfig, ReadsAllOfPanoramas) {
  const randomize::BackgroundRandomization given = read(
      "{colour: 0.5, pictures: skies, present: 0.75, projection: panorama, yaw: {uniform: [-3, "
      "3]}, brightness: {uniform: [0.5, 2]}}");
  ASSERT_TRUE(given.pictures);
  EXPECT_EQ(given.pictures->folder, (std::filesystem::current_path() / "skies").string());
  EXPECT_EQ(given.pictures->projection, randomize::BackgroundProjection::kPanorama);
  EXPECT_EQ(given.pictures->present, 0.75);
  EXPECT_EQ(given.pictures->yaw->lowest(), -3.0);
  EXPECT_EQ(given.pictures->brightness->highest(), 2.0);
  EXPECT_TRUE(given.colour);
}

TEST(BackgroundConfig, RefusesAColourThatIsNeverSeen) {
  const auto message =
      ElementsAre(HasSubstr("background/colour: found a colour behind pictures that cover it"));
  EXPECT_THAT(errorsOf("{colour: 0.5, pictures: /data}"), message);
  EXPECT_THAT(errorsOf("{colour: 0.5, pictures: /data, present: 1}"), message);
}

TEST(BackgroundConfig, RefusesWhatIsOutOfRange) {
  EXPECT_THAT(
      errorsOf("{pictures: /data, projection: dome}"),
      ElementsAre("background/projection: found 'dome'; it should be backdrop or panorama"));
  EXPECT_THAT(errorsOf("{pictures: /data, present: 2}"),
              ElementsAre("background/present: found 2.0; it should be 0.0 to 1.0"));
  EXPECT_THAT(errorsOf("{pictures: /data, brightness: -1}"),
              ElementsAre("background/brightness: found -1; it should be 0.0 to 1000000.0"));
  EXPECT_THAT(errorsOf("{pictures: /data, projection: panorama, yaw: 90}"),
              ElementsAre(HasSubstr("background/yaw: found 90; it should be -6.28")));
  EXPECT_THAT(errorsOf("{pictures: [a, b]}"),
              ElementsAre(HasSubstr("background/pictures: found ")));
}

/// Entries that apply only to pictures, or only to panoramas, mean nothing without them.
TEST(BackgroundConfig, KnowsNoEntryThatWouldMeanNothing) {
  const auto unknownIn = [](const std::string& background) {
    Parameters group = settings(background);
    (void)readBackground(group);
    return group.unknownNames();
  };
  EXPECT_THAT(errorsOf("{pictures: /data, yaw: 1}"),
              ElementsAre("background/yaw: has a meaning with projection: panorama alone"));
  EXPECT_THAT(unknownIn("{colour: 0.5, projection: panorama}"),
              ElementsAre("background/projection"));
  EXPECT_THAT(unknownIn("{picturs: /data}"), ElementsAre("background/picturs"));
}

TEST(BackgroundConfig, TellsAMisspeltDistributionFromAGroup) {
  EXPECT_THAT(errorsOf("{unifrom: [0, 1]}"),
              ElementsAre(HasSubstr("background: found 'unifrom'; it should be a group with "
                                    "uniform, log_uniform, normal or choice")));
}

}  // namespace background_config_test
}  // namespace synthetic_dataset::config
