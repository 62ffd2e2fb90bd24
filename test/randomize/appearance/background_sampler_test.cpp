#include "randomize/appearance/background_sampler.h"

#include <map>
#include <set>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "base/yaml_value.h"
#include "config/readers.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::randomize {
namespace background_sampler_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Key;
using ::testing::UnorderedElementsAre;
using Projection = world::BackgroundPicture::Projection;

/// A folder of pictures, each in a single shade of blue.
class BackgroundSamplerTest : public ::testing::Test {
 protected:
  void add(const std::string& name, int shade, const cv::Size& size = {8, 4}) const {
    cv::imwrite((folder / name).string(), cv::Mat(size, CV_8UC3, cv::Scalar(shade, 0, 0)));
  }

  [[nodiscard]] BackgroundSampler sampler(const std::string& entries) const {
    Parameters root(base::parseYaml(
        "{background: {pictures: '" + folder.path().string() + "', " + entries + "}}", "test"));
    BackgroundRandomization config = config::readBackground(root);
    EXPECT_THAT(root.errors(), IsEmpty());
    EXPECT_THAT(root.unknownNames(), IsEmpty());
    return BackgroundSampler(config);
  }

  /// The look of a scene, and in `draws` what was drawn for it.
  world::Look sample(BackgroundSampler& sampler, std::int64_t scene) {
    EntryDraws entry_draws(1, scene);
    world::Look look{world::Description()};
    sampler.sample(entry_draws, look);
    draws.clear();
    for (const DrawnValue& drawn : entry_draws.values()) draws.emplace(drawn.name, drawn.value);
    return look;
  }

  [[nodiscard]] double number(const std::string& name) const {
    return std::get<std::vector<double>>(draws.at(name)).at(0);
  }

  [[nodiscard]] std::vector<std::string> errorsOf(const std::string& entries) const {
    return test::messagesOf([&] { (void)sampler(entries); });
  }

  test::TemporaryFolder folder;
  std::map<std::string, std::variant<std::vector<double>, std::string>> draws;
};

TEST_F(BackgroundSamplerTest, DrawsOneOfThePicturesAndNamesIt) {
  add("a.png", 100);
  add("b.png", 200);
  BackgroundSampler backgrounds = sampler("");
  std::set<std::string> names;
  for (int scene = 0; scene < 20; ++scene) {
    const world::Look look = sample(backgrounds, scene);
    ASSERT_TRUE(look.background_picture);
    const world::BackgroundPicture& picture = *look.background_picture;
    EXPECT_THAT(draws, ElementsAre(Key("background/pictures")));
    const auto& name = std::get<std::string>(draws.at("background/pictures"));
    EXPECT_EQ(picture.picture->file, name);
    EXPECT_EQ(picture.picture->pixels.at<cv::Vec4b>(0, 0)[0],
              name == (folder / "a.png").string() ? 100 : 200);
    EXPECT_EQ(picture.projection, Projection::kBackdrop);
    EXPECT_EQ(picture.brightness, 1.0);
    names.insert(name);
  }
  EXPECT_EQ(names.size(), 2U);
}

TEST_F(BackgroundSamplerTest, MakesPicturesUpAndNamesThem) {
  BackgroundRandomization config;
  config.pictures.emplace();
  config.pictures->folder = "natural";
  BackgroundSampler backgrounds(config);
  std::set<std::string> names;
  for (int scene = 0; scene < 10; ++scene) {
    const world::Look look = sample(backgrounds, scene);
    ASSERT_TRUE(look.background_picture);
    EXPECT_THAT(draws, ElementsAre(Key("background/pictures")));
    const auto& name = std::get<std::string>(draws.at("background/pictures"));
    EXPECT_EQ(look.background_picture->picture->file, name);
    EXPECT_THAT(name, testing::MatchesRegex("natural/[a-z]+/[0-9]+"));
    EXPECT_EQ(look.background_picture->projection, Projection::kBackdrop);
    names.insert(name);
  }
  EXPECT_GT(names.size(), 7U);
}

TEST_F(BackgroundSamplerTest, DrawsHowAPanoramaIsTurnedAndHowBrightItIs) {
  add("sky.png", 100);
  BackgroundSampler backgrounds =
      sampler("projection: panorama, yaw: {uniform: [-3, 3]}, brightness: {uniform: [0.5, 0.75]}");
  const world::Look look = sample(backgrounds, 0);
  EXPECT_EQ(look.background_picture->projection, Projection::kPanorama);
  EXPECT_EQ(look.background_picture->yaw, number("background/yaw"));
  EXPECT_EQ(look.background_picture->brightness, number("background/brightness"));
  EXPECT_NE(look.background_picture->yaw, sample(backgrounds, 1).background_picture->yaw);
}

TEST_F(BackgroundSamplerTest, LeavesTheColourToScenesWithoutAPicture) {
  add("a.png", 100);
  BackgroundSampler backgrounds = sampler("colour: [0.25, 0.5, 0.75], present: 0.5");
  int pictures = 0;
  for (int scene = 0; scene < 40; ++scene) {
    const world::Look look = sample(backgrounds, scene);
    EXPECT_EQ(look.background, Eigen::Vector3f(0.25F, 0.5F, 0.75F));
    const bool has_picture = look.background_picture.has_value();
    EXPECT_EQ(number("background/present"), has_picture ? 1.0 : 0.0);
    EXPECT_EQ(draws.count("background/pictures"), has_picture ? 1U : 0U);
    pictures += has_picture ? 1 : 0;
  }
  EXPECT_GT(pictures, 8);
  EXPECT_LT(pictures, 32);
}

TEST_F(BackgroundSamplerTest, DrawsThePictureWhateverElseIsDrawn) {
  for (const char* name : {"a.png", "b.png", "c.png", "d.png"}) add(name, 100);
  BackgroundSampler alone = sampler("projection: panorama");
  BackgroundSampler beside = sampler(
      "projection: panorama, present: 0.9999, colour: {uniform: [0, 1]}, yaw: {uniform: [-3, 3]}, "
      "brightness: {uniform: [0, 1]}");
  for (int scene = 0; scene < 10; ++scene) {
    EXPECT_EQ(sample(alone, scene).background_picture->picture->file,
              sample(beside, scene).background_picture->picture->file);
  }
}

TEST_F(BackgroundSamplerTest, NamesTheEntryOfAFolderThatIsOfNoUse) {
  EXPECT_THAT(errorsOf(""),
              ElementsAre("randomize/background/pictures: found '" + folder.path().string() +
                          "', a folder without pictures (png, jpg, bmp, tif, webp, hdr, exr)"));
  folder.write("broken.png", "no picture");
  EXPECT_THAT(errorsOf(""), ElementsAre(HasSubstr("randomize/background/pictures: picture '")));
}

TEST_F(BackgroundSamplerTest, RefusesAPhotographAsAPanorama) {
  add("sky.png", 100, {8, 4});
  add("street.png", 100, {6, 4});
  EXPECT_THAT(errorsOf("projection: panorama"),
              ElementsAre(HasSubstr("randomize/background/pictures: found '" +
                                    (folder / "street.png").string() +
                                    "' of 6 x 4 pixels; a panorama goes all round")));
  EXPECT_THAT(errorsOf("projection: backdrop"), IsEmpty());
}

}  // namespace background_sampler_test
}  // namespace synthetic_dataset::randomize
