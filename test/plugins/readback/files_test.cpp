#include "plugins/readback/files.h"

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace files_test {

using testing::HasSubstr;

class ReadPicture : public testing::Test {
 protected:
  /// The error about a file of this content.
  [[nodiscard]] std::string errorOf(const std::string& content) const {
    try {
      static_cast<void>(readPicture(folder_.write("picture.png", content), cv::IMREAD_COLOR));
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

  [[nodiscard]] static std::string encoded(const std::string& extension) {
    std::vector<unsigned char> bytes;
    cv::imencode(extension, cv::Mat(3000, 3000, CV_8UC1, cv::Scalar(7)), bytes);
    return {bytes.begin(), bytes.end()};
  }

  test::TemporaryFolder folder_;
};

TEST_F(ReadPicture, ReadsWhatPacksAsTightAsItCan) {
  EXPECT_EQ(errorOf(encoded(".png")), "no error");
  EXPECT_EQ(errorOf(encoded(".jpg")), "no error");
}

TEST_F(ReadPicture, RefusesASizeThatTheFileIsTooShortFor) {
  std::string png = encoded(".png").substr(0, 60);
  png.replace(16, 8, std::string("\0\0\x40\0\0\0\x40\0", 8));  // 16384 x 16384
  EXPECT_THAT(errorOf(png),
              HasSubstr("cannot be decoded; it should be a PNG, JPEG or TIFF picture"));
}

TEST_F(ReadPicture, ReadsDepthsInTiffAndRefusesThoseWhoseSizeIsALie) {
  std::vector<uchar> bytes;
  cv::imencode(".tiff", cv::Mat(30, 40, CV_32FC1, cv::Scalar(1.5)), bytes);
  std::string tiff(bytes.begin(), bytes.end());
  folder_.write("depth.tiff", tiff);
  const cv::Mat depth = readPicture(folder_ / "depth.tiff", cv::IMREAD_UNCHANGED);
  EXPECT_EQ(depth.size(), cv::Size(40, 30));
  EXPECT_EQ(depth.type(), CV_32FC1);
  // The directory's entry of the width: tag 256, and a number of two or four bytes.
  const std::size_t short_entry = tiff.find(std::string("\x00\x01\x03\x00\x01\x00\x00\x00", 8));
  ASSERT_NE(short_entry, std::string::npos);
  tiff.replace(short_entry + 2, 10, std::string("\x04\x00\x01\x00\x00\x00\xFF\xFF\xFF\x7F", 10));
  EXPECT_THAT(errorOf(tiff), HasSubstr("cannot be decoded"));
}

TEST_F(ReadPicture, RefusesOtherKinds) {
  EXPECT_THAT(errorOf(encoded(".bmp")), HasSubstr("it should be a PNG, JPEG or TIFF picture"));
  EXPECT_THAT(errorOf(""), HasSubstr("it should be a PNG, JPEG or TIFF picture"));
}

TEST_F(ReadPicture, RefusesDevices) {
  EXPECT_THAT(
      test::messagesOf([] { static_cast<void>(readPicture("/dev/zero", cv::IMREAD_COLOR)); }),
      testing::ElementsAre(HasSubstr("'/dev/zero': no such picture")));
  EXPECT_THAT(test::messagesOf([] { static_cast<void>(readText("/dev/zero")); }),
              testing::ElementsAre(HasSubstr("'/dev/zero': cannot be read")));
}

}  // namespace files_test
}  // namespace synthetic_dataset::formats
