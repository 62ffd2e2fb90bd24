#include "base/image/picture_decoder.h"

#include <algorithm>
#include <limits>

#include <FreeImage.h>

#include <gmock/gmock.h>

#include <opencv2/imgcodecs.hpp>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace picture_decoder_test {

using testing::HasSubstr;
using Bytes = std::vector<std::uint8_t>;

Bytes encoded(const char* extension, const cv::Mat& pixels) {
  Bytes bytes;
  cv::imencode(extension, pixels, bytes);
  return bytes;
}

/// Two pixels, the left one red and the right one blue, in a format that only FreeImage writes.
Bytes encodedByFreeImage(FREE_IMAGE_FORMAT format, bool palette) {
  FIBITMAP* bitmap = FreeImage_Allocate(2, 1, 32);
  RGBQUAD red{0, 0, 255, 255};
  RGBQUAD blue{255, 0, 0, 255};
  FreeImage_SetPixelColor(bitmap, 0, 0, &red);
  FreeImage_SetPixelColor(bitmap, 1, 0, &blue);
  FIBITMAP* flat = FreeImage_ConvertTo24Bits(bitmap);
  FIBITMAP* few = palette ? FreeImage_ColorQuantize(flat, FIQ_WUQUANT) : flat;
  FIMEMORY* memory = FreeImage_OpenMemory();
  FreeImage_SaveToMemory(format, few, memory, 0);
  BYTE* data = nullptr;
  DWORD size = 0;
  FreeImage_AcquireMemory(memory, &data, &size);
  Bytes bytes(data, data + size);
  FreeImage_CloseMemory(memory);
  if (few != flat) FreeImage_Unload(few);
  FreeImage_Unload(flat);
  FreeImage_Unload(bitmap);
  return bytes;
}

std::string errorOf(const Bytes& bytes, const std::string& name = "a") {
  try {
    static_cast<void>(decodePicture(bytes, name));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

cv::Vec4b pixel(const cv::Mat& pixels, int column = 0) { return pixels.at<cv::Vec4b>(0, column); }

/// A DDS file of one 4x4 block in DXT1: all pixels have the block's first colour, red.
Bytes redDxt1() {
  Bytes file(128 + 8, 0);
  const auto put = [&](std::size_t at, std::uint32_t value) {
    for (std::size_t i = 0; i < 4; ++i) file[at + i] = static_cast<std::uint8_t>(value >> (8 * i));
  };
  put(0, 0x20534444);  // "DDS "
  put(4, 124);         // the header's size
  put(8, 0x1007);      // it has caps, height, width, a pixel format
  put(12, 4);
  put(16, 4);
  put(76, 32);           // the pixel format's size
  put(80, 4);            // the format is a four-letter code
  put(84, 0x31545844);   // "DXT1"
  put(108, 0x1000);      // a texture
  put(128, 0x0000F800);  // 5, 6, 5 bits: red, then black
  return file;
}

TEST(PictureDecoder, ReadsGreyWithAlphaAndSixteenBits) {
  EXPECT_EQ(pixel(decodePicture(
                encoded(".png", cv::Mat(1, 1, CV_16UC4, cv::Scalar(257, 514, 771, 1028))), "a")),
            cv::Vec4b(1, 2, 3, 4));
  EXPECT_EQ(
      pixel(decodePicture(encoded(".tiff", cv::Mat(1, 1, CV_8UC3, cv::Scalar(5, 6, 7))), "a")),
      cv::Vec4b(5, 6, 7, 255));
}

TEST(PictureDecoder, ReadsPalettePngs) {
  const cv::Mat pixels = decodePicture(encodedByFreeImage(FIF_PNG, true), "a.png");
  EXPECT_EQ(pixel(pixels, 0), cv::Vec4b(0, 0, 255, 255));
  EXPECT_EQ(pixel(pixels, 1), cv::Vec4b(255, 0, 0, 255));
}

TEST(PictureDecoder, ReadsTgaAndGif) {
  const cv::Mat tga = decodePicture(encodedByFreeImage(FIF_TARGA, false), "a.tga");
  EXPECT_EQ(pixel(tga, 0), cv::Vec4b(0, 0, 255, 255));
  EXPECT_EQ(pixel(tga, 1), cv::Vec4b(255, 0, 0, 255));
  const cv::Mat gif = decodePicture(encodedByFreeImage(FIF_GIF, true), "a.gif");
  EXPECT_EQ(pixel(gif, 0), cv::Vec4b(0, 0, 255, 255));
}

TEST(PictureDecoder, ReadsDds) {
  const cv::Mat pixels = decodePicture(redDxt1(), "a.dds");
  ASSERT_EQ(pixels.size(), cv::Size(4, 4));
  EXPECT_GT(pixel(pixels)[2], 240);
  EXPECT_LT(pixel(pixels)[0], 10);
}

TEST(PictureDecoder, PutsTheFirstRowOnTop) {
  cv::Mat rows(2, 1, CV_8UC3, cv::Scalar(0, 0, 0));
  rows.at<cv::Vec3b>(0, 0) = {9, 9, 9};
  EXPECT_EQ(pixel(decodePicture(encoded(".bmp", rows), "a")), cv::Vec4b(9, 9, 9, 255));
}

TEST(PictureDecoder, RefusesWhatClaimsToBeLarge) {
  Bytes png = encoded(".png", cv::Mat::zeros(2, 2, CV_8UC3));
  png[17] = 1;  // a width of 65538
  EXPECT_THAT(errorOf(png), HasSubstr("is too large: 65538 x 2 pixels; at most 16384 a side"));
  Bytes tga = encodedByFreeImage(FIF_TARGA, false);
  tga[13] = tga[15] = 0xFF;
  EXPECT_THAT(errorOf(tga, "a.tga"), HasSubstr("is too large: 65282 x 65281"));
  Bytes jpeg = encoded(".jpg", cv::Mat::zeros(8, 8, CV_8UC3));
  for (std::size_t i = 0; i + 9 < jpeg.size(); ++i) {
    if (jpeg[i] == 0xFF && jpeg[i + 1] == 0xC0) jpeg[i + 5] = jpeg[i + 7] = 0xF0;
  }
  EXPECT_THAT(errorOf(jpeg), HasSubstr("is too large: 61448 x 61448"));
}

TEST(PictureDecoder, RefusesWhatBreaksOff) {
  const cv::Mat picture(64, 64, CV_8UC3, cv::Scalar(1, 2, 3));
  EXPECT_THAT(errorOf({}), HasSubstr("the file is empty"));
  for (const char* extension : {".png", ".jpg", ".tiff", ".webp"}) {
    Bytes bytes = encoded(extension, picture);
    bytes.resize(bytes.size() / 2);
    EXPECT_THAT(errorOf(bytes), HasSubstr("cannot be decoded")) << extension;
  }
  Bytes tga = encodedByFreeImage(FIF_TARGA, false);
  tga.resize(10);
  EXPECT_THAT(errorOf(tga, "a.tga"), HasSubstr("cannot be decoded"));
}

TEST(PictureDecoder, NamesThePicturesThatItReads) {
  EXPECT_THAT(errorOf({'n', 'o', 'n', 'e'}), HasSubstr("PSD and PGM pictures can"));
  const Bytes pgm = encoded(".pgm", cv::Mat(2, 3, CV_8UC1, cv::Scalar(7)));
  EXPECT_EQ(pixel(decodePicture(pgm, "a.pgm")), cv::Vec4b(7, 7, 7, 255));
}

/// A Radiance file of 2 x 2 pixels: a colour with at most half of white's light, white, a colour
/// with up to eight times white's light, and black.
Bytes radiance() {
  const std::string header = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 2\n";
  Bytes file(header.begin(), header.end());
  // A channel's value is its byte / 256 * 2^(last byte - 128).
  for (const int byte : {128, 64, 32, 128, 128, 128, 128, 129, 128, 128, 64, 132, 0, 0, 0, 0}) {
    file.push_back(static_cast<std::uint8_t>(byte));
  }
  return file;
}

/// An OpenEXR file of one row of pixels with these reds, and blues of twice as much.
Bytes openExr(const std::vector<float>& reds) {
  const auto width = static_cast<int>(reds.size());
  FIBITMAP* bitmap = FreeImage_AllocateT(FIT_RGBF, width, 1);
  auto* row = reinterpret_cast<FIRGBF*>(FreeImage_GetScanLine(bitmap, 0));
  for (std::size_t i = 0; i < reds.size(); ++i) row[i] = {reds[i], 0.0F, 2.0F * reds[i]};
  FIMEMORY* memory = FreeImage_OpenMemory();
  FreeImage_SaveToMemory(FIF_EXR, bitmap, memory, EXR_FLOAT);
  BYTE* data = nullptr;
  DWORD size = 0;
  FreeImage_AcquireMemory(memory, &data, &size);
  Bytes bytes(data, data + size);
  FreeImage_CloseMemory(memory);
  FreeImage_Unload(bitmap);
  return bytes;
}

cv::Vec4f light(const cv::Mat& pixels, int row, int column) {
  return pixels.at<cv::Vec4f>(row, column);
}

TEST(PictureDecoder, ReadsTheLightOfRadiancesPictures) {
  const cv::Mat pixels = decodePictureOrLight(radiance(), "a.hdr");
  ASSERT_EQ(pixels.size(), cv::Size(2, 2));
  EXPECT_EQ(light(pixels, 0, 0), cv::Vec4f(0.125F, 0.25F, 0.5F, 1.0F)) << "blue, green, red";
  EXPECT_EQ(light(pixels, 0, 1), cv::Vec4f(1.0F, 1.0F, 1.0F, 1.0F));
  EXPECT_EQ(light(pixels, 1, 0), cv::Vec4f(4.0F, 8.0F, 8.0F, 1.0F));
  EXPECT_EQ(light(pixels, 1, 1), cv::Vec4f(0.0F, 0.0F, 0.0F, 1.0F));
}

TEST(PictureDecoder, ReadsTheLightOfOpenExrsPictures) {
  constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
  const cv::Mat pixels = decodePictureOrLight(openExr({0.5F, 300.0F, 1e9F, -2.0F, kNone}), "a.exr");
  ASSERT_EQ(pixels.size(), cv::Size(5, 1));
  EXPECT_EQ(light(pixels, 0, 0), cv::Vec4f(1.0F, 0.0F, 0.5F, 1.0F));
  EXPECT_EQ(light(pixels, 0, 1), cv::Vec4f(600.0F, 0.0F, 300.0F, 1.0F));
  EXPECT_EQ(light(pixels, 0, 2), cv::Vec4f(65504.0F, 0.0F, 65504.0F, 1.0F));
  EXPECT_EQ(light(pixels, 0, 3), cv::Vec4f(0.0F, 0.0F, 0.0F, 1.0F)) << "below 0";
  EXPECT_EQ(light(pixels, 0, 4), cv::Vec4f(0.0F, 0.0F, 0.0F, 1.0F)) << "no number";
}

TEST(PictureDecoder, KnowsTheSizeOfLightAndWhereItBreaksOff) {
  EXPECT_EQ(checkPicture(radiance(), "a.hdr").height, 2U);
  EXPECT_EQ(checkPicture(openExr({1, 2, 3}), "a.exr").width, 3U);
  cv::Mat noise(9, 40, CV_32FC3);
  cv::randu(noise, 0.0, 9.0);
  const cv::Mat plain(9, 40, CV_32FC3, cv::Scalar::all(2));
  for (const Bytes& file : {radiance(), encoded(".hdr", noise), encoded(".hdr", plain),
                            openExr(std::vector<float>(100, 1.0F))}) {
    EXPECT_NO_THROW((void)checkPicture(file, "a"));
    const std::size_t step = 1 + file.size() / 50;
    for (std::size_t missing = 1; missing < file.size() - 10; missing += step) {
      const Bytes cut(file.begin(), file.end() - static_cast<std::ptrdiff_t>(missing));
      EXPECT_EQ(test::messagesOf([&] { (void)checkPicture(cut, "a"); }),
                std::vector<std::string>{"cannot be decoded: the file breaks off or is damaged"})
          << missing << " of " << file.size();
    }
  }
}

TEST(PictureDecoder, TakesNoLightForATexture) {
  for (const Bytes& file : {radiance(), openExr({1, 2})}) {
    EXPECT_THAT(errorOf(file), HasSubstr("holds linear light"));
  }
}

TEST(PictureDecoder, ChecksWithoutDecoding) {
  const cv::Mat picture(3, 5, CV_8UC3, cv::Scalar(1, 2, 3));
  for (const char* extension : {".png", ".jpg", ".bmp", ".tiff", ".webp", ".pgm"}) {
    const cv::Mat grey(picture.size(), CV_8UC1, cv::Scalar(9));
    const bool is_grey = std::string(extension) == ".pgm";
    const PictureSize size = checkPicture(encoded(extension, is_grey ? grey : picture), "a");
    EXPECT_EQ(size.width, 5U) << extension;
    EXPECT_EQ(size.height, 3U) << extension;
  }
}

TEST(PictureDecoder, ChecksThatNothingBreaksOffOrClaimsToBeLarge) {
  const auto problem = [](const Bytes& bytes) -> std::string {
    try {
      (void)checkPicture(bytes, "a");
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  const cv::Mat picture(64, 64, CV_8UC3, cv::Scalar(1, 2, 3));
  for (const char* extension : {".png", ".jpg", ".bmp"}) {
    Bytes bytes = encoded(extension, picture);
    bytes.resize(bytes.size() - 20);
    EXPECT_THAT(problem(bytes), HasSubstr("breaks off or is damaged")) << extension;
  }
  Bytes png = encoded(".png", picture);
  png[17] = 1;
  EXPECT_THAT(problem(png), HasSubstr("is too large"));
  EXPECT_THAT(problem({'n', 'o', 'n', 'e'}), HasSubstr("cannot be decoded"));
  EXPECT_THAT(problem({}), HasSubstr("the file is empty"));
}

/// A TGA file of 4 x 2 pixels with nothing after its content.
Bytes tgaOf(std::uint8_t kind, std::uint8_t depth, const Bytes& content) {
  const bool has_palette = kind % 8 == 1;
  constexpr std::size_t kHeader = 18;
  Bytes file(kHeader + content.size(), 0);
  file[1] = has_palette ? 1 : 0;
  file[2] = kind;
  file[5] = has_palette ? 2 : 0;
  file[7] = has_palette ? 24 : 0;
  file[12] = 4;
  file[14] = 2;
  file[16] = depth;
  std::copy(content.begin(), content.end(), file.begin() + kHeader);
  return file;
}

/// A DDS file of 8 x 4 pixels in the compressed format of a four-letter code or, if that is empty,
/// in rows of uncompressed 32-bit pixels.
Bytes ddsOf(const std::string& code, std::size_t content) {
  Bytes file = redDxt1();
  file[16] = 8;
  std::copy(code.begin(), code.end(), file.begin() + 84);
  if (code.empty()) {
    file[80] = 0x40;  // red, green, blue
    file[88] = 32;
    file[94] = file[97] = file[100] = 0xFF;  // the bit mask of each
  }
  file.resize(128 + content, 0);
  return file;
}

void expectNeedsAll(const Bytes& file, std::size_t header, const std::string& name) {
  EXPECT_EQ(errorOf(file, name), "") << name;
  for (std::size_t size = header; size < file.size(); ++size) {
    const Bytes part(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
    EXPECT_THAT(errorOf(part, name), HasSubstr("breaks off")) << name << ": " << size << " bytes";
  }
}

TEST(PictureDecoder, RefusesTgaThatBreaksOff) {
  const Bytes palette{0, 0, 255, 255, 0, 0};
  const auto withPalette = [&](Bytes pixels) {
    pixels.insert(pixels.begin(), palette.begin(), palette.end());
    return pixels;
  };
  expectNeedsAll(tgaOf(2, 24, Bytes(24, 7)), 18, "plain.tga");
  expectNeedsAll(tgaOf(3, 8, Bytes(8, 7)), 18, "grey.tga");
  expectNeedsAll(tgaOf(1, 8, withPalette(Bytes(8, 1))), 18, "palette.tga");
  // A run of five pixels, then three uncompressed pixels.
  expectNeedsAll(tgaOf(10, 24, {0x84, 1, 2, 3, 0x02, 1, 1, 1, 2, 2, 2, 3, 3, 3}), 18, "run.tga");
  expectNeedsAll(tgaOf(9, 8, withPalette({0x84, 1, 0x02, 0, 1, 0})), 18, "palette run.tga");
}

TEST(PictureDecoder, RefusesDdsThatBreaksOff) {
  expectNeedsAll(ddsOf("DXT1", 16), 128, "1.dds");
  expectNeedsAll(ddsOf("DXT3", 32), 128, "3.dds");
  expectNeedsAll(ddsOf("DXT5", 32), 128, "5.dds");
  expectNeedsAll(ddsOf("", 128), 128, "rows.dds");
}

TEST(PictureDecoder, RefusesBmpGifAndPsdThatBreakOff) {
  const Bytes bmp = encoded(".bmp", cv::Mat(4, 4, CV_8UC3, cv::Scalar(1, 2, 3)));
  expectNeedsAll(bmp, 54, "a.bmp");
  Bytes gif = encodedByFreeImage(FIF_GIF, true);
  EXPECT_EQ(errorOf(gif, "a.gif"), "");
  gif.resize(gif.size() - 3);
  EXPECT_THAT(errorOf(gif, "a.gif"), HasSubstr("breaks off"));
  Bytes psd = encodedByFreeImage(FIF_PSD, false);
  EXPECT_EQ(errorOf(psd, "a.psd"), "");
  psd.resize(psd.size() - 1);
  EXPECT_THAT(errorOf(psd, "a.psd"), HasSubstr("breaks off"));
}

TEST(PictureDecoder, RefusesWhatElseItsLibraryKnows) {
  const Bytes picture = encodedByFreeImage(FIF_XPM, false);
  ASSERT_GT(picture.size(), 40U);
  EXPECT_THAT(errorOf(picture, "a.xpm"), HasSubstr("PSD and PGM pictures can"));
}

TEST(PictureDecoder, RefusesWhatIsNoPicture) {
  const std::string text = "hello, I am a text";
  EXPECT_THAT(errorOf(Bytes(text.begin(), text.end()), "a.png"),
              HasSubstr("PNG, JPEG, BMP, TIFF, WebP, TGA, GIF, DDS, PSD and PGM pictures can"));
}

TEST(DecodePictures, GivesAllThatCanBeDecoded) {
  Bytes torn = encoded(".png", cv::Mat(40, 40, CV_8UC3, cv::Scalar(1, 2, 3)));
  torn.resize(torn.size() / 2);
  const Bytes grey = encoded(".png", cv::Mat(3, 5, CV_8UC1, cv::Scalar(7)));
  const Bytes deep = encoded(".png", cv::Mat(1, 1, CV_16UC4, cv::Scalar(257, 514, 771, 1028)));
  const Bytes photo = encoded(".jpg", cv::Mat(64, 48, CV_8UC3, cv::Scalar(90, 120, 40)));
  const auto pictures = decodePictures(
      {{"deep", deep}, {"empty", {}}, {"grey", grey}, {"photo", photo}, {"torn", torn}});
  ASSERT_EQ(pictures.size(), 3);
  for (const auto& [name, file] : {std::pair{"deep", deep}, {"grey", grey}, {"photo", photo}}) {
    EXPECT_EQ(cv::norm(pictures.at(name), decodePicture(file, name), cv::NORM_INF), 0.0) << name;
  }
}

/// More pixels than one process hands over.
TEST(DecodePictures, TakesLargeOnesOneAfterAnother) {
  const Bytes large = encoded(".png", cv::Mat(6000, 6000, CV_8UC1, cv::Scalar(9)));
  const Bytes small = encoded(".png", cv::Mat(2, 2, CV_8UC1, cv::Scalar(8)));
  const auto pictures = decodePictures({{"a", large}, {"b", small}});
  ASSERT_EQ(pictures.size(), 2);
  EXPECT_EQ(pictures.at("a").size(), cv::Size(6000, 6000));
  EXPECT_EQ(pixel(pictures.at("a")), cv::Vec4b(9, 9, 9, 255));
  EXPECT_EQ(pixel(pictures.at("b")), cv::Vec4b(8, 8, 8, 255));
}

}  // namespace picture_decoder_test
}  // namespace synthetic_dataset::base
