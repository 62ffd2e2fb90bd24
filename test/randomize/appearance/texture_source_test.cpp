#include "randomize/appearance/texture_source.h"

#include <array>
#include <filesystem>
#include <map>
#include <set>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace texture_source_test {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::HasSubstr;

/// A folder of small pictures.
class TextureFolder : public ::testing::Test {
 protected:
  /// @param pixel  blue, green, red, and perhaps alpha
  void add(const std::string& name, const cv::Scalar& pixel, int type = CV_8UC3) const {
    const fs::path file = folder / name;
    fs::create_directories(file.parent_path());
    cv::imwrite(file.string(), cv::Mat(4, 4, type, pixel));
  }

  [[nodiscard]] TextureSource source() const { return TextureSource(folder.path().string()); }

  /// The names, relative to the folder, of the first draws with `count` sources of random numbers.
  static std::vector<std::string> draws(TextureSource source, const fs::path& folder,
                                        int count = 60) {
    std::vector<std::string> names;
    for (int seed = 0; seed < count; ++seed) {
      base::RandomSource random(static_cast<std::uint64_t>(seed));
      names.push_back(fs::relative(source.draw(random).first, folder).string());
    }
    return names;
  }

  test::TemporaryFolder folder;
};

TEST_F(TextureFolder, GivesEachOfItsPicturesAndNothingElse) {
  add("red.png", {0, 0, 255});
  add("green.JPG", {0, 255, 0});
  add("below/deep/blue.bmp", {255, 0, 0});
  add("grey.webp", {99, 99, 99});
  add("white.tiff", {255, 255, 255});
  folder.write("readme.txt", "not a picture");
  fs::create_directory(folder / "folder.png");

  std::map<std::string, int> counts;
  for (const std::string& name : draws(source(), folder.path(), 200)) ++counts[name];

  using testing::Gt;
  using testing::Pair;
  EXPECT_THAT(counts,
              testing::UnorderedElementsAre(Pair("red.png", Gt(15)), Pair("green.JPG", Gt(15)),
                                            Pair("below/deep/blue.bmp", Gt(15)),
                                            Pair("grey.webp", Gt(15)), Pair("white.tiff", Gt(15))));
}

TEST_F(TextureFolder, GivesThePixelsOfTheFileThatItNames) {
  add("red.png", {0, 0, 255});
  add("green.png", {0, 255, 0});
  TextureSource textures = source();
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    base::RandomSource random(seed);
    const auto [name, texture] = textures.draw(random);
    EXPECT_EQ(texture->file, name);
    const cv::Mat file = cv::imread(name);
    ASSERT_EQ(texture->pixels.size(), file.size());
    const auto& pixel = texture->pixels.at<cv::Vec4b>(1, 2);
    const auto& expected = file.at<cv::Vec3b>(1, 2);
    EXPECT_EQ(pixel, cv::Vec4b(expected[0], expected[1], expected[2], 255));
  }
}

/// File systems list files in any order, often that in which they were made.
TEST_F(TextureFolder, GivesTheSameWhateverTheOrderOnTheDisk) {
  const test::TemporaryFolder other;
  const std::vector<std::string> names = {"d.png", "a.png", "e/a.png", "c.png", "b.png", "f.png"};
  for (const std::string& name : names) add(name, {0, 0, 0});
  for (auto name = names.rbegin(); name != names.rend(); ++name) {
    fs::create_directories((other / *name).parent_path());
    fs::copy_file(folder / *name, other / *name);
  }
  EXPECT_EQ(draws(source(), folder.path()),
            draws(TextureSource(other.path().string()), other.path()));
}

TEST_F(TextureFolder, IsInAlphabeticalOrder) {
  for (const char* name : {"c.png", "a.png", "b.png"}) add(name, {0, 0, 0});
  TextureSource textures = source();
  const std::array<std::string, 3> sorted = {"a.png", "b.png", "c.png"};
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    base::RandomSource random(seed);
    base::RandomSource same(seed);
    EXPECT_EQ(textures.draw(random).first, (folder / sorted.at(same.index(3))).string());
  }
}

TEST_F(TextureFolder, HasNoHoles) {
  add("leaf.png", {10, 20, 30, 0}, CV_8UC4);
  TextureSource textures = source();
  base::RandomSource random(1);
  EXPECT_EQ(textures.draw(random).second->pixels.at<cv::Vec4b>(0, 0), cv::Vec4b(10, 20, 30, 255));
}

TEST_F(TextureFolder, GivesMorePicturesThanItKeeps) {
  for (int i = 0; i < 40; ++i) add(std::to_string(i) + ".png", {1.0 * i, 0, 0});
  TextureSource textures = source();
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    base::RandomSource random(seed);
    const auto [name, texture] = textures.draw(random);
    EXPECT_EQ(texture->pixels.at<cv::Vec4b>(0, 0)[0], std::stoi(fs::path(name).stem())) << name;
  }
}

TEST_F(TextureFolder, GivesTheSameTextureAgainWhileItIsKept) {
  add("red.png", {0, 0, 255});
  TextureSource textures = source();
  base::RandomSource random(1);
  const auto first = textures.draw(random).second;
  EXPECT_EQ(textures.draw(random).second, first);
}

TEST_F(TextureFolder, ThatIsMissingIsNamed) {
  EXPECT_THAT(test::messagesOf([] { TextureSource("/nowhere/textures"); }),
              testing::ElementsAre("found '/nowhere/textures': No such file or directory"));
}

TEST_F(TextureFolder, WithoutPicturesIsNamed) {
  folder.write("readme.txt", "not a picture");
  EXPECT_THAT(test::messagesOf([&] { (void)source(); }),
              testing::ElementsAre("found '" + folder.path().string() +
                                   "', a folder without pictures (png, jpg, bmp, tif, webp)"));
}

TEST_F(TextureFolder, NamesAPictureThatCannotBeDecodedBeforeOneIsDrawn) {
  add("red.png", {0, 0, 255});
  folder.write("broken.png", "\x89PNG but no more");
  EXPECT_THAT(
      test::messagesOf([&] { (void)source(); }),
      testing::ElementsAre(AllOf(HasSubstr("picture '" + (folder / "broken.png").string() + "' "),
                                 HasSubstr("cannot be decoded"))));
}

TEST(TextureSource, MakesPatternsUp) {
  TextureSource textures("procedural");
  base::RandomSource random(1);
  std::set<std::string> kinds;
  for (int i = 0; i < 100; ++i) kinds.insert(textures.draw(random).first);
  EXPECT_THAT(kinds, testing::ElementsAre("checkers", "clouds", "dots", "gradient", "stripes"));
}

TEST(TextureSource, MakesMaterialsUp) {
  TextureSource textures("natural");
  base::RandomSource random(1);
  base::RandomSource same(1);
  std::set<std::string> names;
  for (int i = 0; i < 20; ++i) {
    const auto [name, texture] = textures.draw(random);
    EXPECT_EQ(texture->file, name);
    EXPECT_THAT(name, testing::MatchesRegex("natural/[a-z]+/" + std::to_string(same.index(256))));
    names.insert(name);
  }
  EXPECT_GT(names.size(), 15U);
}

}  // namespace texture_source_test
}  // namespace synthetic_dataset::randomize
