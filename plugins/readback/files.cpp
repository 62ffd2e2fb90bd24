#include "plugins/readback/files.h"

#include <cstdint>
#include <fstream>
#include <iterator>
#include <sstream>
#include <system_error>

#include <opencv2/imgcodecs.hpp>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats {
namespace {

std::uint64_t bigEndian(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t place = at + i;
    number = number << 8U | (place < bytes.size() ? static_cast<unsigned char>(bytes[place]) : 0U);
  }
  return number;
}

bool startsWith(const std::string& bytes, const std::string& start) {
  return bytes.compare(0, start.size(), start) == 0;
}

/// The number of pixels that a JPEG's frame header announces (ITU T.81, B.2.2), 0 if there is none.
std::uint64_t pixelsOfJpeg(const std::string& bytes) {
  std::size_t at = 2;
  while (at + 4 <= bytes.size() && bigEndian(bytes, at, 1) == 0xFF) {
    const std::uint64_t marker = bigEndian(bytes, at + 1, 1);
    const bool is_frame =
        marker >= 0xC0 && marker <= 0xCF && marker != 0xC4 && marker != 0xC8 && marker != 0xCC;
    if (is_frame) return bigEndian(bytes, at + 5, 2) * bigEndian(bytes, at + 7, 2);
    at += marker == 0xFF ? 1 : 2 + bigEndian(bytes, at + 2, 2);
  }
  return 0;
}

std::uint64_t littleEndian(const std::string& bytes, std::size_t at, std::size_t count) {
  std::uint64_t number = 0;
  for (std::size_t i = count; i-- > 0;) {
    number = number << 8U | bigEndian(bytes, at + i, 1);
  }
  return number;
}

/// The number of pixels that the first directory of a little-endian TIFF announces (TIFF 6.0,
/// section 2).
std::uint64_t pixelsOfTiff(const std::string& bytes) {
  constexpr std::uint64_t kWidth = 256;
  constexpr std::uint64_t kHeight = 257;
  constexpr std::uint64_t kShort = 3;
  const std::size_t directory = littleEndian(bytes, 4, 4);
  const std::uint64_t count = littleEndian(bytes, directory, 2);
  std::uint64_t width = 0;
  std::uint64_t height = 0;
  for (std::uint64_t i = 0; i < count; ++i) {
    const std::size_t entry = directory + 2 + 12 * i;
    const std::uint64_t tag = littleEndian(bytes, entry, 2);
    const std::size_t size = littleEndian(bytes, entry + 2, 2) == kShort ? 2 : 4;
    if (tag == kWidth) width = littleEndian(bytes, entry + 8, size);
    if (tag == kHeight) height = littleEndian(bytes, entry + 8, size);
  }
  return width * height;
}

/// The number of pixels that a picture's header announces; 0 if it is not of a type found in
/// datasets.
std::uint64_t claimedPixels(const std::string& bytes) {
  if (startsWith(bytes, "\x89PNG\r\n\x1A\n")) {
    return bigEndian(bytes, 16, 4) * bigEndian(bytes, 20, 4);
  }
  if (startsWith(bytes, "\xFF\xD8\xFF")) return pixelsOfJpeg(bytes);
  if (startsWith(bytes, std::string("II*\0", 4))) return pixelsOfTiff(bytes);
  return 0;
}

/// Whether a picture's file is long enough for the size that it announces: zlib compresses at most
/// 1032 bytes to one, and each may hold 8 pixels.
bool isPlausible(const std::string& bytes) {
  constexpr std::uint64_t kMostPixelsOfAByte = 10000;
  const std::uint64_t pixels = claimedPixels(bytes);
  return pixels > 0 && pixels <= kMostPixelsOfAByte * bytes.size();
}

}  // namespace

std::string readText(const std::filesystem::path& file) {
  std::error_code ignored;  // a device, which is not a regular file, may never end
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw Error("'" + file.string() + "': cannot be read");
  }
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("'" + file.string() + "': cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> readLines(const std::filesystem::path& file) {
  std::istringstream stream(readText(file));
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) {
    if (!line.empty()) lines.push_back(line);
  }
  return lines;
}

std::vector<std::string> wordsOf(const std::string& line) {
  std::istringstream stream(line);
  return {std::istream_iterator<std::string>(stream), {}};
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
  return text;
}

namespace {

bool isCoordinate(const std::string& word) {
  constexpr std::size_t kDecimals = 5;
  const std::size_t point = word.find('.');
  return point != std::string::npos && word.size() == point + 1 + kDecimals &&
         word.find_first_not_of("0123456789", point + 1) == std::string::npos;
}

}  // namespace

std::size_t firstCoordinate(const std::vector<std::string>& words, std::size_t shortest_id,
                            std::size_t group, const std::filesystem::path& file) {
  std::size_t first = words.size();
  while (first > shortest_id && isCoordinate(words[first - 1])) --first;
  const bool is_between = first > shortest_id + 1 && isCoordinate(words[first - 2]);
  if (is_between) (void)numberOf(words[first - 1], file);
  first += (words.size() - first) % group;
  for (std::size_t i = first; i < words.size(); ++i) (void)numberOf(words[i], file);
  return first;
}

double numberOf(const std::string& word, const std::filesystem::path& file) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  if (stream >> number && stream.eof()) return number;
  throw Error("'" + file.string() + "': found '" + word + "'; it should be a number");
}

cv::Mat readPicture(const std::filesystem::path& file, int mode) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw Error("'" + file.string() + "': no such picture");
  }
  const std::string bytes = readText(file);
  cv::Mat picture;
  try {
    const cv::Mat content(1, static_cast<int>(bytes.size()), CV_8UC1,
                          const_cast<char*>(bytes.data()));  // only read
    if (isPlausible(bytes)) picture = cv::imdecode(content, mode);
  } catch (const cv::Exception&) {
    picture.release();
  }
  if (picture.empty()) {
    throw Error("'" + file.string() +
                "': cannot be decoded; it should be a PNG, JPEG or TIFF picture");
  }
  return picture;
}

}  // namespace synthetic_dataset::formats
