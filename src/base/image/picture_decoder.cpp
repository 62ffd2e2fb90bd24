#include "base/image/picture_decoder.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>
#include <variant>

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "base/image/freeimage_decoder.h"
#include "base/image/light_file.h"
#include "base/image/picture_bytes.h"
#include "base/image/picture_check.h"
#include "base/image/picture_size.h"
#include "base/sandbox/byte_stream.h"
#include "base/sandbox/kept_process.h"
#include "base/sandbox/sandboxed_batch.h"
#include "base/sandbox/sandboxed_process.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr const char* kUndecodable =
    "cannot be decoded; PNG, JPEG, BMP, TIFF, WebP, TGA, GIF, DDS, PSD and PGM pictures can";
constexpr const char* kDamaged = "cannot be decoded: the file breaks off or is damaged";
constexpr const char* kIsLight =
    "holds linear light, as Radiance's and OpenEXR's pictures do; only a background may. It can be "
    "used here if it is saved as PNG";

SandboxLimits decodingLimits() {
  SandboxLimits limits;
  limits.processor_time = std::chrono::seconds(60);
  limits.memory = std::uint64_t{3} << 30U;
  return limits;
}

void checkSize(const PictureSize& size) {
  const bool fits = size.width <= kLongestPictureSide && size.height <= kLongestPictureSide &&
                    size.width * size.height <= kLargestPicture;
  if (fits) return;
  throw Error("is too large: " + std::to_string(size.width) + " x " + std::to_string(size.height) +
              " pixels; at most " + std::to_string(kLongestPictureSide) + " a side and " +
              std::to_string(kLargestPicture >> 20U) + " million in all can be read");
}

/// The bytes of a file that make its pixels, after checks that it can be decoded.
Bytes checked(const Bytes& file) {
  if (file.empty()) throw Error("cannot be decoded: the file is empty");
  if (const std::optional<PictureSize> size = claimedSize(file)) checkSize(*size);
  Bytes essential = essentialPngChunks(file);
  if (essential.empty() || !isWhole(essential)) {
    throw Error(kDamaged);
  }
  return essential;
}

/// OpenCV sets its codecs up on first use. A process that is forked while another thread does so
/// would wait for it forever, as that thread does not exist in the new process.
void setUpCodecs() {
  static const bool kAreSetUp = [] {
    for (const char* kind : {".png", ".jpg"}) {
      std::vector<std::uint8_t> file;
      cv::imencode(kind, cv::Mat(1, 1, CV_8UC3, cv::Scalar::all(0)), file);
      static_cast<void>(cv::imdecode(file, cv::IMREAD_UNCHANGED));
    }
    return true;
  }();
  static_cast<void>(kAreSetUp);
}

/// Uses no threads of either library, so that it can run in a forked process.
cv::Mat decode(const Bytes& file, const std::string& name) {
  // OpenCV reads such pictures only from files, and OpenEXR not everywhere.
  if (isLight(PictureBytes(file))) return decodeWithFreeImage(file, name);
  cv::Mat pixels;
  try {
    pixels = cv::imdecode(file, cv::IMREAD_UNCHANGED);
  } catch (const cv::Exception&) {
    pixels.release();
  }
  return pixels.empty() ? decodeWithFreeImage(file, name) : pixels;
}

std::string toBytes(const cv::Mat& pixels) {
  ByteWriter writer;
  writer.number<std::int32_t>(pixels.rows);
  writer.number<std::int32_t>(pixels.cols);
  writer.number<std::int32_t>(pixels.type());
  for (int row = 0; row < pixels.rows; ++row) {
    writer.raw(pixels.ptr(row), static_cast<std::size_t>(pixels.cols) * pixels.elemSize());
  }
  return writer.take();
}

cv::Mat fromBytes(const std::string& bytes) {
  ByteReader reader(bytes);
  const auto rows = reader.number<std::int32_t>();
  const auto columns = reader.number<std::int32_t>();
  const auto type = reader.number<std::int32_t>();
  if (rows <= 0 || columns <= 0) return {};
  checkSize({static_cast<std::uint64_t>(columns), static_cast<std::uint64_t>(rows)});
  cv::Mat pixels(rows, columns, type);
  reader.copy(pixels.data, pixels.total() * pixels.elemSize());
  return pixels;
}

/// The most that one process may return, unless it is a single picture [pixel].
constexpr std::uint64_t kLargestBatch = std::uint64_t{1} << 25U;

/// Pictures that are decoded together: the essential bytes of their files, by name.
struct Batch {
  std::map<std::string, Bytes> files;
  std::uint64_t pixels = 0;
};

std::vector<Batch> batchesOf(const std::map<std::string, Bytes>& files) {
  std::vector<Batch> batches(1);
  for (const auto& [name, file] : files) {
    try {
      Bytes essential = checked(file);
      const std::optional<PictureSize> size = claimedSize(file);
      if (!size) continue;
      const std::uint64_t pixels = size->width * size->height;
      if (batches.back().pixels + pixels > kLargestBatch) batches.emplace_back();
      batches.back().files.emplace(name, std::move(essential));
      batches.back().pixels += pixels;
    } catch (const Error&) {
      continue;  // reported when it is decoded alone
    }
  }
  return batches;
}

/// Converts colours of any depth and number of channels to blue, green, red, alpha of 8 bits.
cv::Mat toBgra(const cv::Mat& picture) {
  cv::Mat bytes;
  if (picture.empty()) return {};
  if (picture.depth() == CV_8U) {
    bytes = picture;
  } else if (picture.depth() == CV_16U) {
    picture.convertTo(bytes, CV_8U, 1.0 / 257.0);
  } else {
    return {};
  }
  cv::Mat bgra;
  switch (bytes.channels()) {
    case 1:
      cv::cvtColor(bytes, bgra, cv::COLOR_GRAY2BGRA);
      return bgra;
    case 3:
      cv::cvtColor(bytes, bgra, cv::COLOR_BGR2BGRA);
      return bgra;
    case 4:
      return bytes;
    default:
      return {};
  }
}

void decodeInto(const Batch& batch, std::map<std::string, cv::Mat>& pictures) {
  std::vector<SandboxedWork> pieces;
  for (const auto& entry : batch.files) {
    pieces.push_back({[&entry] { return toBytes(decode(entry.second, entry.first)); },
                      decodingLimits().processor_time});
  }
  const auto answers = runAllSandboxed(pieces, decodingLimits().memory);
  auto answer = answers.begin();
  for (const auto& entry : batch.files) {
    const std::optional<std::string>& pixels = *answer++;
    if (!pixels) continue;
    try {
      cv::Mat picture = toBgra(fromBytes(*pixels));
      if (!picture.empty()) pictures.emplace(entry.first, std::move(picture));
    } catch (const Error&) {
      continue;  // decodePicture() tells what is wrong
    }
  }
}

/// A process that decodes one picture after another.
KeptProcess& keptDecoder() {
  setUpCodecs();
  static KeptProcess decoder(
      [](std::string_view request) {
        ByteReader reader(request);
        const std::string name = reader.text();
        return toBytes(decode(reader.list<std::uint8_t>(), name));
      },
      decodingLimits());
  return decoder;
}

/// The result of toBytes() for a picture's pixels. If the kept decoder fails, the picture is
/// decoded again in a process of its own, which tells what is wrong with it.
std::string decodeApart(const Bytes& file, const std::string& name) {
  ByteWriter request;
  request.text(name);
  request.list(file);
  if (auto answer = keptDecoder().ask(request.take())) return *std::move(answer);
  const auto work = [&] { return toBytes(decode(file, name)); };
  std::variant<std::string, Crash> answer = runSandboxed(work, decodingLimits());
  if (const auto* crash = std::get_if<Crash>(&answer)) {
    throw Error("cannot be decoded (its decoder " + crash->how + ")");
  }
  return std::get<std::string>(std::move(answer));
}

/// @return 8 or 16 bits per channel, as in decodePixels(), or CV_32FC3: red, green, blue
cv::Mat decodeAny(const Bytes& file, const std::string& name) {
  cv::Mat pixels = fromBytes(decodeApart(checked(file), name));
  const bool is_known = pixels.depth() == CV_8U || pixels.depth() == CV_16U ||
                        (isLight(PictureBytes(file)) && pixels.type() == CV_32FC3);
  if (pixels.empty() || !is_known)
    throw Error(isLight(PictureBytes(file)) ? kDamaged : kUndecodable);
  return pixels;
}

/// Converts light from CV_32FC3 (red, green, blue) to the result of decodePictureOrLight(). OpenEXR
/// also stores negative numbers and NaN.
cv::Mat lightOf(const cv::Mat& pixels) {
  constexpr float kMost = 65504.0F;  // the largest 16-bit float (IEEE 754 binary16)
  cv::Mat light(pixels.size(), CV_32FC4);
  for (int row = 0; row < pixels.rows; ++row) {
    const auto* from = pixels.ptr<cv::Vec3f>(row);
    auto* to = light.ptr<cv::Vec4f>(row);
    for (int column = 0; column < pixels.cols; ++column) {
      for (int channel = 0; channel < 3; ++channel) {
        const float number = from[column][2 - channel];
        to[column][channel] = number > 0.0F ? std::min(number, kMost) : 0.0F;
      }
      to[column][3] = 1.0F;
    }
  }
  return light;
}

}  // namespace

PictureSize checkPicture(const Bytes& file, const std::string& name) {
  static_cast<void>(checked(file));
  const std::optional<PictureSize> size = claimedSize(file);
  if (size && size->width > 0 && size->height > 0) return *size;
  const cv::Mat pixels = decodeAny(file, name);
  return {static_cast<std::uint64_t>(pixels.cols), static_cast<std::uint64_t>(pixels.rows)};
}

cv::Mat decodePixels(const Bytes& file, const std::string& name) {
  if (isLight(PictureBytes(file))) throw Error(kIsLight);
  return decodeAny(file, name);
}

cv::Mat decodePicture(const Bytes& file, const std::string& name) {
  cv::Mat pixels = toBgra(decodePixels(file, name));
  if (pixels.empty()) throw Error(kUndecodable);
  return pixels;
}

cv::Mat decodePictureOrLight(const Bytes& file, const std::string& name) {
  return isLight(PictureBytes(file)) ? lightOf(decodeAny(file, name)) : decodePicture(file, name);
}

std::map<std::string, cv::Mat> decodePictures(const std::map<std::string, Bytes>& files) {
  std::map<std::string, cv::Mat> pictures;
  if (files.empty()) return pictures;  // setting up takes a while
  setUpCodecs();
  for (const Batch& batch : batchesOf(files)) decodeInto(batch, pictures);
  return pictures;
}

}  // namespace synthetic_dataset::base
