#include "randomize/appearance/picture_folder.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::randomize {
namespace picture_folder_test {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::SizeIs;

class PictureFolderTest : public ::testing::Test {
 protected:
  void add(const std::string& name, const cv::Size& size = {4, 4}) const {
    const fs::path file = folder / name;
    fs::create_directories(file.parent_path());
    cv::imwrite(file.string(), cv::Mat(size, CV_8UC3, cv::Scalar(10, 20, 30)));
  }

  [[nodiscard]] std::string bytesOf(const std::string& name) const {
    std::ifstream stream(folder / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  [[nodiscard]] PictureFolder pictures(PictureKind kind = PictureKind::kEncoded) const {
    return {folder.path().string(), kind};
  }

  [[nodiscard]] std::vector<std::string> errors() const {
    return test::messagesOf([&] { (void)pictures(); });
  }

  test::TemporaryFolder folder;
};

TEST_F(PictureFolderTest, KnowsTheSizesBeforeAnythingIsDecoded) {
  add("a.png", {5, 3});
  add("b/c.jpg", {7, 2});
  const PictureFolder found = pictures();
  EXPECT_THAT(found.files(), ElementsAre(EndsWith("a.png"), EndsWith("b/c.jpg")));
  ASSERT_THAT(found.sizes(), SizeIs(2));
  EXPECT_EQ(found.sizes()[0].width, 5U);
  EXPECT_EQ(found.sizes()[0].height, 3U);
  EXPECT_EQ(found.sizes()[1].width, 7U);
}

TEST_F(PictureFolderTest, HasPicturesOfLightWhereTheyAreWanted) {
  add("a.png");
  cv::imwrite((folder / "b.HDR").string(), cv::Mat(2, 4, CV_32FC3, cv::Scalar(3, 2, 1)));
  EXPECT_THAT(pictures().files(), ElementsAre(EndsWith("a.png")));
  PictureFolder found = pictures(PictureKind::kAny);
  EXPECT_THAT(found.files(), ElementsAre(EndsWith("a.png"), EndsWith("b.HDR")));
  EXPECT_EQ(found.sizes()[1].width, 4U);
  EXPECT_EQ(found.read(1)->pixels.at<cv::Vec4f>(1, 3), cv::Vec4f(3, 2, 1, 1));
}

TEST_F(PictureFolderTest, FindsAtOnceWhatBreaksOffOrIsNoPicture) {
  add("good.png");
  for (const char* name : {"half.png", "half.jpg", "half.bmp"}) {
    add(name, {64, 64});
    const std::string bytes = bytesOf(name);
    folder.write(name, bytes.substr(0, bytes.size() / 2));
  }
  folder.write("text.png", "this is a text");
  const auto broken = [&](const std::string& name) {
    return AllOf(HasSubstr("picture '" + (folder / name).string() + "' cannot be decoded"));
  };
  EXPECT_THAT(errors(), ElementsAre(broken("half.bmp"), broken("half.jpg"), broken("half.png"),
                                    broken("text.png")));
}

TEST_F(PictureFolderTest, NamesAFewOfManyThatAreBroken) {
  for (int i = 0; i < 9; ++i) folder.write(std::to_string(i) + ".png", "");
  const std::vector<std::string> found = errors();
  ASSERT_THAT(found, SizeIs(5));
  EXPECT_THAT(found[0], HasSubstr("0.png' cannot be decoded: the file is empty"));
  EXPECT_EQ(found[4], "found 5 more that cannot be decoded");
}

/// A file whose header, which is read first, is intact.
TEST_F(PictureFolderTest, NamesThePictureThatProvesBrokenWhenItIsDecoded) {
  add("a.webp", {64, 64});
  constexpr std::size_t kHeader = 32;
  folder.write("a.webp", bytesOf("a.webp").substr(0, kHeader));
  PictureFolder found = pictures();
  EXPECT_THAT(
      test::messagesOf([&] { (void)found.read(0); }),
      testing::ElementsAre(HasSubstr("picture '" + found.files()[0] + "' cannot be decoded")));
}

TEST_F(PictureFolderTest, NamesAPictureThatIsGone) {
  add("a.png");
  PictureFolder found = pictures();
  fs::remove(folder / "a.png");
  EXPECT_THAT(test::messagesOf([&] { (void)found.read(0); }),
              testing::ElementsAre(found.files()[0] + ": no such file, or it cannot be read"));
}

}  // namespace picture_folder_test
}  // namespace synthetic_dataset::randomize
