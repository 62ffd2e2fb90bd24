#include "base/image/deflate.h"

#ifdef SYNTHETIC_DATASET_QUICK_DEFLATE
#include <memory>

#include <libdeflate.h>

#include "base/image/isal_deflate.h"
#include "synthetic_dataset/errors.h"
#else
#include <zlib.h>

#include "base/image/zlib_deflate.h"
#endif

namespace synthetic_dataset::base {

#ifdef SYNTHETIC_DATASET_QUICK_DEFLATE
namespace {

std::vector<uchar> libdeflated(const cv::Mat& bytes, int compression) {
  struct Free {
    void operator()(libdeflate_compressor* freed) const { libdeflate_free_compressor(freed); }
  };
  const std::unique_ptr<libdeflate_compressor, Free> compressor(
      libdeflate_alloc_compressor(compression));
  if (!compressor) throw Error("too little memory to compress an image");
  std::vector<uchar> result(libdeflate_zlib_compress_bound(compressor.get(), bytes.total()));
  result.resize(libdeflate_zlib_compress(compressor.get(), bytes.data, bytes.total(), result.data(),
                                         result.size()));
  return result;
}

}  // namespace

std::vector<uchar> deflated(const cv::Mat& bytes, int compression) {
  constexpr int kQuickest = 1;
  return compression <= kQuickest ? isalDeflated(bytes) : libdeflated(bytes, compression);
}

std::uint32_t crc32(std::uint32_t sum, const uchar* bytes, std::size_t size) {
  return libdeflate_crc32(sum, bytes, size);
}

std::map<std::string, std::string> deflateLibraries() {
  return {{"isa-l", ISAL_VERSION}, {"libdeflate", LIBDEFLATE_VERSION_STRING}};
}
#else
std::vector<uchar> deflated(const cv::Mat& bytes, int compression) {
  return zlibDeflated(bytes, compression);
}

std::uint32_t crc32(std::uint32_t sum, const uchar* bytes, std::size_t size) {
  return static_cast<std::uint32_t>(crc32_z(sum, bytes, size));
}

std::map<std::string, std::string> deflateLibraries() { return {{"zlib", ZLIB_VERSION}}; }
#endif

}  // namespace synthetic_dataset::base
