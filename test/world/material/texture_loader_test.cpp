#include "world/material/texture_loader.h"

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace texture_loader_test {

using test::TemporaryFolder;
using testing::AllOf;
using testing::HasSubstr;
using testing::Property;

class TextureLoaderTest : public testing::Test {
 protected:
  TextureReference write(const std::string& name, const cv::Mat& pixels) const {
    cv::imwrite((folder_ / name).string(), pixels);
    return reference(name);
  }
  TextureReference reference(const std::string& uri) const {
    TextureReference result;
    result.uri = uri;
    result.folder = folder_.path();
    return result;
  }
  cv::Vec4b pixel(const TextureReference& reference) {
    return loader_.load(reference)->pixels.at<cv::Vec4b>(0, 0);
  }

  TemporaryFolder folder_;
  ResourceFinder finder_ = test::finderIn(folder_);
  TextureLoader loader_{finder_};
};

TEST_F(TextureLoaderTest, ReadsColourAndGreyOfAnyDepth) {
  EXPECT_EQ(pixel(write("c.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)))),
            cv::Vec4b(1, 2, 3, 255));
  EXPECT_EQ(pixel(write("g.png", cv::Mat(1, 1, CV_8UC1, cv::Scalar(7)))), cv::Vec4b(7, 7, 7, 255));
  EXPECT_EQ(pixel(write("d.png", cv::Mat(1, 1, CV_16UC1, cv::Scalar(0x2020)))),
            cv::Vec4b(0x20, 0x20, 0x20, 255));
}

TEST_F(TextureLoaderTest, KeepsAlphaOnlyWhereItMeansOpacity) {
  TextureReference reference = write("a.png", cv::Mat(1, 1, CV_8UC4, cv::Scalar(1, 2, 3, 4)));
  EXPECT_EQ(pixel(reference), cv::Vec4b(1, 2, 3, 255));
  reference.alpha = AlphaMeaning::kOpacity;
  EXPECT_EQ(pixel(reference), cv::Vec4b(1, 2, 3, 4));
}

TEST_F(TextureLoaderTest, SharesPictures) {
  const TextureReference reference = write("c.png", cv::Mat::zeros(1, 1, CV_8UC3));
  EXPECT_EQ(loader_.load(reference), loader_.load(this->reference("./c.png")));
}

TEST_F(TextureLoaderTest, ReadsEmbeddedPictures) {
  TextureReference reference;
  auto picture = std::make_shared<EmbeddedPicture>();
  picture->name = "robot.glb*0";
  cv::imencode(".png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(9, 8, 7)), picture->bytes);
  reference.embedded = picture;
  EXPECT_EQ(pixel(reference), cv::Vec4b(9, 8, 7, 255));
}

TEST_F(TextureLoaderTest, TellsWhereAMissingPictureWasLookedFor) {
  EXPECT_THAT(
      test::messagesOf([&] { static_cast<void>(loader_.load(reference("model://box/p.png"))); }),
      testing::ElementsAre(AllOf(HasSubstr("texture 'model://box/p.png': no such file"),
                                 HasSubstr("looked in " + folder_.path().string()))));
}

TEST_F(TextureLoaderTest, TakesNoPictureBesideForOneThatLeadsOutOfItsFolder) {
  write("secret.png", cv::Mat::zeros(1, 1, CV_8UC3));
  const auto load = [&] {
    static_cast<void>(loader_.load(reference("model://a/../../secret.png")));
  };
  EXPECT_THAT(test::messagesOf(load), testing::ElementsAre(HasSubstr("leads out of the folders")));
  EXPECT_EQ(finder_.refusals().size(), 1U);
}

TEST_F(TextureLoaderTest, DoesWithoutGazebosFlatNormals) {
  EXPECT_EQ(loader_.load(reference("file://media/materials/textures/flat_normal.png")), nullptr);
  EXPECT_TRUE(loader_.takeStandIns().empty());
}

TEST_F(TextureLoaderTest, PaintsAStandInForAPictureOfGazebos) {
  const TextureReference dirt = reference("file://media/materials/textures/terrain_detail.jpg");
  EXPECT_NE(loader_.load(dirt), nullptr);
  EXPECT_THAT(loader_.takeStandIns(), testing::ElementsAre("terrain_detail.jpg"));
}

TEST_F(TextureLoaderTest, FindsPicturesOfAResourceFolderByTheirNames) {
  std::filesystem::create_directories(folder_ / "media/materials/textures");
  write("media/materials/textures/p.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  TextureReference reference = this->reference("p.png");
  reference.folder = "/nowhere";
  EXPECT_EQ(pixel(reference), cv::Vec4b(1, 2, 3, 255));
}

TEST_F(TextureLoaderTest, MultipliesPicturesInTheSizeOfTheLarger) {
  const TextureReference a = write("a.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(255, 100, 51)));
  const TextureReference b = write("b.png", cv::Mat(2, 4, CV_8UC3, cv::Scalar(51, 255, 0)));
  const cv::Mat product = loader_.loadProduct(a, b)->pixels;
  EXPECT_EQ(product.size(), cv::Size(4, 2));
  EXPECT_EQ(product.at<cv::Vec4b>(1, 3), cv::Vec4b(51, 100, 0, 255));
  EXPECT_EQ(loader_.loadProduct(a, b), loader_.loadProduct(a, b));
}

TEST_F(TextureLoaderTest, SharesPicturesWithoutHolesWhateverAlphaMeans) {
  TextureReference reference = write("c.png", cv::Mat::zeros(1, 1, CV_8UC3));
  const auto ignored = loader_.load(reference);
  reference.alpha = AlphaMeaning::kOpacity;
  EXPECT_EQ(loader_.load(reference)->pixels.data, ignored->pixels.data);
}

TEST_F(TextureLoaderTest, FindsPicturesInMoreFolders) {
  std::filesystem::create_directories(folder_ / "far");
  cv::imwrite((folder_ / "far/p.png").string(), cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  TextureReference wanted = reference("p.png");
  EXPECT_THROW(static_cast<void>(loader_.load(wanted)), Error);
  wanted.more_folders = {folder_ / "far"};
  EXPECT_EQ(pixel(wanted), cv::Vec4b(1, 2, 3, 255));
}

TEST_F(TextureLoaderTest, SpreadsTheRedChannelOfNumbers) {
  TextureReference wanted = write("n.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 30)));
  wanted.content = PictureContent::kRed;
  EXPECT_EQ(pixel(wanted), cv::Vec4b(30, 30, 30, 255));
  wanted.content = PictureContent::kInvertedRed;
  EXPECT_EQ(pixel(wanted), cv::Vec4b(225, 225, 225, 255));
}

TEST_F(TextureLoaderTest, MakesNormalsOfHeightsThatRiseToTheRight) {
  cv::Mat ramp(3, 8, CV_8UC1);
  for (int x = 0; x < 8; ++x) ramp.col(x).setTo(16 * x);
  TextureReference wanted = write("h.png", ramp);
  wanted.content = PictureContent::kNormalsOrHeights;
  const cv::Vec4b normal = loader_.load(wanted)->pixels.at<cv::Vec4b>(1, 4);
  EXPECT_LT(normal[2], 120);       // x: against the slope
  EXPECT_NEAR(normal[1], 128, 1);  // y: level
  EXPECT_GT(normal[0], 230);       // z: up
}

TEST_F(TextureLoaderTest, KeepsNormalMapsThatAreNot) {
  TextureReference wanted = write("n.png", cv::Mat(2, 2, CV_8UC3, cv::Scalar(255, 128, 120)));
  wanted.content = PictureContent::kNormalsOrHeights;
  EXPECT_EQ(pixel(wanted), cv::Vec4b(255, 128, 120, 255));
}

TEST_F(TextureLoaderTest, JoinsAnOpacityPictureToItsColours) {
  const TextureReference colours = write("c.png", cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
  TextureReference opacity = write("o.png", cv::Mat(2, 2, CV_8UC1, cv::Scalar(77)));
  opacity.alpha = AlphaMeaning::kOpacity;
  opacity.content = PictureContent::kAlphaFromGrey;
  const auto joined = loader_.loadWithOpacity(colours, opacity);
  EXPECT_EQ(joined->pixels.at<cv::Vec4b>(3, 3), cv::Vec4b(1, 2, 3, 77));
  EXPECT_EQ(joined, loader_.loadWithOpacity(colours, opacity));
}

TEST_F(TextureLoaderTest, MakesAPictureOnce) {
  int times = 0;
  const auto make = [&] {
    ++times;
    return cv::Mat(1, 1, CV_8UC4, cv::Scalar::all(255));
  };
  EXPECT_EQ(loader_.made("a", make), loader_.made("a", make));
  EXPECT_EQ(times, 1);
}

TEST_F(TextureLoaderTest, RefusesWhatCannotBeDecodedWithoutPrinting) {
  std::vector<std::uint8_t> png;
  cv::imencode(".png", cv::Mat::zeros(64, 64, CV_8UC3), png);
  folder_.write("cut.png", std::string(png.begin(), png.begin() + 60));
  png[45] ^= 0xFFU;
  folder_.write("changed.png", std::string(png.begin(), png.end()));
  folder_.write("text.png", "hello");
  folder_.write("empty.png", "");
  testing::internal::CaptureStderr();
  for (const char* name : {"cut.png", "changed.png", "text.png", "empty.png"}) {
    EXPECT_THAT(test::messagesOf([&] { static_cast<void>(loader_.load(reference(name))); }),
                testing::ElementsAre(AllOf(HasSubstr(name), HasSubstr("cannot be decoded"))));
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST_F(TextureLoaderTest, DecodesWhatItHasDecodedAheadNoMore) {
  const TextureReference picture = write("c.png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  TextureReference embedded;
  std::vector<std::uint8_t> bytes;
  cv::imencode(".png", cv::Mat(1, 1, CV_8UC3, cv::Scalar(4, 5, 6)), bytes);
  embedded.embedded = std::make_shared<EmbeddedPicture>(EmbeddedPicture{"inside", bytes});
  loader_.decodeAhead({picture, embedded, reference("gone.png")});
  std::filesystem::resize_file(folder_ / "c.png", 3);  // it is not read again
  EXPECT_EQ(pixel(picture), cv::Vec4b(1, 2, 3, 255));
  EXPECT_EQ(pixel(embedded), cv::Vec4b(4, 5, 6, 255));
  EXPECT_THAT(test::messagesOf([&] { static_cast<void>(loader_.load(reference("gone.png"))); }),
              testing::ElementsAre(HasSubstr("texture 'gone.png': no such file")));
}

}  // namespace texture_loader_test
}  // namespace synthetic_dataset::world
