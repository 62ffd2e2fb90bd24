#include "base/image/isal_deflate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#ifdef __x86_64__
#include <immintrin.h>
#endif

#include <isa-l/igzip_lib.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace {

#ifdef __x86_64__
/// ISA-L leaves data in the upper halves of the wide registers, after which instructions that use
/// only the lower halves take twice as long (Intel, "64 and IA-32 Architectures Optimization
/// Reference Manual", mixing AVX code with SSE code).
__attribute__((target("avx"))) void clearUpperHalves() { _mm256_zeroupper(); }

void leaveIsal() {
  if (__builtin_cpu_supports("avx") != 0) clearUpperHalves();
}
#else
void leaveIsal() {}
#endif

/// Passes ISA-L its next bytes.
void deflateNext(isal_zstream& stream, std::size_t count, bool is_end) {
  stream.avail_in = static_cast<std::uint32_t>(count);
  stream.flush = is_end ? NO_FLUSH : SYNC_FLUSH;
  stream.end_of_stream = is_end ? 1 : 0;
  const int problem = isal_deflate(&stream);
  leaveIsal();
  if (problem != COMP_OK || stream.avail_in != 0) {
    throw Error("an image cannot be compressed (ISA-L's error " + std::to_string(problem) + ")");
  }
}

}  // namespace

std::vector<uchar> isalDeflated(const cv::Mat& bytes) {
  constexpr std::uint32_t kLevel = 1;
  // RFC 1950: deflate with a window of 32 kB, fastest level. We write the header ourselves, as
  // ISA-L 2.31 states another level than 2.30.
  constexpr std::array<uchar, 2> kHeader = {0x78, 0x01};
  // ISA-L 2.30 derives the third byte's place in its table from the address of the stream
  // (igzip_icf_body_h1_gr_bt.asm, .write_first_byte), so that equal input would now and then give
  // different output. The first bytes are flushed separately, which takes another code path.
  constexpr std::size_t kFirst = 16;
  std::vector<uchar> scratch(ISAL_DEF_LVL1_DEFAULT);
  // Incompressible data is stored in blocks, each with a few bytes of overhead.
  // A cv::Mat is not filled with zeros, as a vector would be.
  cv::Mat result(1, static_cast<int>(bytes.total() + bytes.total() / 8 + 1024), CV_8UC1);
  isal_zstream stream;
  isal_deflate_init(&stream);
  stream.gzip_flag = IGZIP_ZLIB_NO_HDR;
  stream.level = kLevel;
  stream.level_buf = scratch.data();
  stream.level_buf_size = static_cast<std::uint32_t>(scratch.size());
  stream.next_in = bytes.data;
  stream.next_out = std::copy(kHeader.begin(), kHeader.end(), result.data);
  stream.avail_out = static_cast<std::uint32_t>(result.total() - kHeader.size());
  const std::size_t first = std::min(kFirst, bytes.total());
  deflateNext(stream, first, false);
  deflateNext(stream, bytes.total() - first, true);
  if (stream.internal_state.state != ZSTATE_END) {
    throw Error("an image cannot be compressed: ISA-L needs more room than it should");
  }
  return {result.data, stream.next_out};
}

}  // namespace synthetic_dataset::base
