/// Runs whose scenes have a picture behind them.

#include <filesystem>
#include <set>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "render/pixels/srgb.h"
#include "run_fixture.h"

namespace synthetic_dataset::run {
namespace background_pictures_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::SizeIs;

using Files = std::map<std::string, std::string>;

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

/// Independent random pixels, so that a shift by one pixel gives a completely different picture.
cv::Mat noise(const cv::Size& size, std::uint64_t seed) {
  cv::Mat pixels(size, CV_8UC3);
  cv::RNG(seed).fill(pixels, cv::RNG::UNIFORM, 0, 256);
  return pixels;
}

/// The first column of a query's rows.
std::vector<std::string> listed(const std::string& folder, const std::string& query) {
  const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement row(manifest, query);
  std::vector<std::string> texts;
  while (row.step()) texts.push_back(row.text(0));
  return texts;
}

/// One camera of 160 x 120 pixels, above whose horizon there is nothing.
class BackgroundPictures : public test::RunFixture {
 protected:
  BackgroundPictures() {
    parameters.erase("background_subtractor");
    fs::create_directory(pictures);
    for (const char* name : {"a.png", "b.png"}) {
      cv::imwrite((pictures / name).string(), noise({160, 120}, name[0]));
    }
  }

  void show(const std::string& entries) {
    parameters["randomize"] =
        yaml("{background: {pictures: '" + pictures.string() + "'" + entries + "}}");
  }

  const fs::path pictures = run.folder() / "pictures";
};

TEST_F(BackgroundPictures, AreSeenAsTheyAreAndNamed) {
  show("");
  (void)generate();
  const std::vector<std::string> drawn =
      listed(folder, "SELECT value FROM draw WHERE name = 'background/pictures' ORDER BY scene");
  ASSERT_THAT(drawn, SizeIs(4));
  const cv::Rect above(0, 0, 160, 30);  // where nothing ever stands
  for (std::size_t scene = 0; scene < drawn.size(); ++scene) {
    const cv::Mat image = cv::imread(folder + "/yolo/0000000" + std::to_string(scene) + ".png");
    const cv::Mat behind = cv::imread(*yaml(drawn[scene]).as<std::string>());
    ASSERT_EQ(behind.size(), image.size());
    EXPECT_EQ(cv::norm(image(above), behind(above), cv::NORM_INF), 0.0) << scene;
  }
}

TEST_F(BackgroundPictures, AreAmongTheInputs) {
  show("");
  (void)generate();
  EXPECT_THAT(listed(folder, "SELECT path FROM input"),
              IsSupersetOf({(pictures / "a.png").string(), (pictures / "b.png").string()}));
}

TEST_F(BackgroundPictures, LeaveLabelsAndExactMasksAsTheyAre) {
  const Files plain = filesAnew();
  show(", brightness: {uniform: [0.5, 1]}");
  Files varied = filesAnew();
  ASSERT_EQ(varied.size(), plain.size());
  for (const auto& [name, bytes] : plain) {
    if (name == "manifest.sqlite") continue;
    const bool is_picture =
        name.find("mask") == std::string::npos && fs::path(name).extension() == ".png";
    EXPECT_EQ(varied[name] == bytes, !is_picture) << name;
  }
}

/// As a panorama it also lights the scene.
TEST_F(BackgroundPictures, OfLightAreNotCutAtWhite) {
  fs::remove(pictures / "b.png");
  cv::Mat encoded(100, 200, CV_8UC3);
  cv::Mat light(encoded.size(), CV_32FC3);
  for (int i = 0; i < 3 * 100 * 200; ++i) {
    const auto number = static_cast<std::uint8_t>(60 + i / 600 + i / 3 % 200 / 4);
    encoded.data[i] = number;
    light.ptr<float>()[i] = 8.0F * render::linearFromSrgb()[number];
  }
  const auto first = [&](const std::string& brightness) {
    parameters["rendering"] = yaml("{light: full}");
    show(", projection: panorama, brightness: " + brightness);
    const std::string bytes = filesAnew().at("yolo/00000000.png");
    return cv::imdecode(std::vector<char>(bytes.begin(), bytes.end()), cv::IMREAD_COLOR);
  };
  cv::imwrite((pictures / "a.png").string(), encoded);
  const cv::Mat by_encoded = first("1");
  fs::remove(pictures / "a.png");
  cv::imwrite((pictures / "a.hdr").string(), light);
  EXPECT_LE(cv::norm(first("0.125"), by_encoded, cv::NORM_INF), 2.0);
  EXPECT_THAT(listed(folder, "SELECT path FROM input"), Contains((pictures / "a.hdr").string()));
}

/// The picture behind the scene is the same with its objects and without them.
TEST_F(BackgroundPictures, AreNotTakenForObjectsBySubtraction) {
  parameters["masks"] = yaml("{method: mog2}");
  parameters["background_subtractor"] = yaml("{history_length: 1, var_threshold: 16}");
  show("");
  const RunSummary summary = generate();
  for (const auto& object : summary.objects) {
    ASSERT_TRUE(object.mask_agreement);
    EXPECT_GT(*object.mask_agreement, 0.97) << object.name;
  }
}

TEST_F(BackgroundPictures, ThatCannotBeDecodedAreNamedBeforeTheFirstScene) {
  run.folder().write("pictures/broken.jpg", "no picture");
  show("");
  EXPECT_THAT(errors(), ElementsAre(AllOf(HasSubstr("randomize/background/pictures: picture '"),
                                          HasSubstr("broken.jpg' cannot be decoded"))));
  EXPECT_FALSE(fs::exists(folder));
  parameters["randomize"] =
      yaml("{distractors: {volume: {min: [-1, -1, 0], max: [1, 1, 1]}, textures: '" +
           pictures.string() + "'}, materials: {world: {textures: '" + pictures.string() + "'}}}");
  EXPECT_THAT(errors(), Contains(HasSubstr("randomize/distractors/textures: picture '")));
}

/// A run that keeps much from picture to picture: two cameras, moving things, masks by subtraction.
TEST(BackgroundPicturesKept, ChangeNoByte) {
  AllAtOnceRun run;
  const std::string pictures = run.input("pictures");
  fs::create_directory(pictures);
  for (const char* name : {"a.png", "b.png"}) {
    cv::imwrite(pictures + "/" + name, noise({200, 100}, name[0]));
  }
  for (const char* projection : {"backdrop", "panorama"}) {
    run.parameters["randomize"] = yaml("{background: {present: 0.8, pictures: '" + pictures +
                                       "', projection: " + projection + "}}");
    std::vector<Files> made;
    for (const bool reuse : {false, true}) {
      fs::remove_all(run.folder());
      run.parameters["rendering"] = Value(Value::Map{{"reuse", Value(reuse)}});
      (void)run.run();
      made.push_back(AllAtOnceRun::files(run.folder()));
    }
    EXPECT_EQ(made[0].size(), made[1].size());
    for (const auto& [path, bytes] : made[0]) EXPECT_TRUE(made[1].at(path) == bytes) << path;
  }
}

}  // namespace background_pictures_test
}  // namespace synthetic_dataset::run
