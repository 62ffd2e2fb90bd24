#include "motion/ros2/decompression.h"

#include <lz4frame.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <memory>
#include <system_error>
#include <utility>

#include "base/input_file.h"
#include "motion/ros2/storage.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

/// Zstandard encodes 128 KiB of equal bytes in 4 bytes (RFC 8878, section 3.1.1.2); LZ4's largest
/// ratio is far smaller.
constexpr std::uint64_t kLargestRatio = 50000;

/// One step of decompressing a frame: how many bytes it consumed, and how many it produced.
struct Step {
  std::size_t taken = 0;
  std::size_t made = 0;
  bool is_end = false;  ///< of the frame
};
using Decompressor = std::function<Step(std::string_view from, char* to, std::size_t room)>;

using ZstdContext = std::unique_ptr<ZSTD_DStream, std::size_t (*)(ZSTD_DStream*)>;

// NOLINTNEXTLINE(readability-non-const-parameter): it is written through the buffer
Step stepOfZstd(ZSTD_DStream* context, std::string_view from, char* to, std::size_t room) {
  ZSTD_inBuffer input{from.data(), from.size(), 0};
  ZSTD_outBuffer output{to, room, 0};
  const std::size_t result = ZSTD_decompressStream(context, &output, &input);
  if (ZSTD_isError(result) != 0) {
    throw Error(std::string("cannot be decompressed by zstd: ") + ZSTD_getErrorName(result));
  }
  return {input.pos, output.pos, result == 0};
}

ZstdContext makeZstd() {
  // Frames may need a window of up to 2 GiB; decoders allow 128 MiB by default.
  return {ZSTD_createDStream(), ZSTD_freeDStream};
}

std::string decompressed(std::string_view frame, const Decompressor& decompress) {
  constexpr std::size_t kPiece = 1U << 16U;
  const std::uint64_t most = std::min<std::uint64_t>(kLargestContent, kLargestRatio * frame.size());
  std::string content;
  std::size_t size = 0;
  for (bool is_end = false; !is_end;) {
    if (content.size() == size) content.resize(std::max(kPiece, 2 * size));
    const Step step = decompress(frame, content.data() + size, content.size() - size);
    frame.remove_prefix(step.taken);
    size += step.made;
    is_end = step.is_end;
    if (size > most) {
      throw Error("is more than " + std::to_string(most >> 20U) + " MiB when it is decompressed");
    }
    if (!is_end && step.taken == 0 && step.made == 0 && size < content.size()) {
      throw Error("breaks off before its compressed content ends");
    }
  }
  if (!frame.empty()) throw Error("has bytes after its compressed content");
  content.resize(size);
  return content;
}

}  // namespace

bool isZstd(std::string_view bytes) { return bytes.substr(0, 4) == "\x28\xB5\x2F\xFD"; }

std::string zstdDecompressed(std::string_view frame) {
  const ZstdContext context = makeZstd();
  return decompressed(frame, [&](std::string_view from, char* to, std::size_t room) {
    return stepOfZstd(context.get(), from, to, room);
  });
}

std::string lz4Decompressed(std::string_view frame) {
  LZ4F_dctx* context = nullptr;
  LZ4F_createDecompressionContext(&context, LZ4F_VERSION);
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> owner(
      context, LZ4F_freeDecompressionContext);
  return decompressed(frame, [&](std::string_view from, char* to, std::size_t room) {
    std::size_t taken = from.size();
    std::size_t made = room;
    const std::size_t result = LZ4F_decompress(context, to, &made, from.data(), &taken, nullptr);
    if (LZ4F_isError(result) != 0U) {
      throw Error(std::string("cannot be decompressed by lz4: ") + LZ4F_getErrorName(result));
    }
    return Step{taken, made, result == 0};
  });
}

TemporaryFile::TemporaryFile() {
  std::error_code error;
  const auto folder = std::filesystem::temp_directory_path(error);
  path_ = (error ? std::filesystem::path("/tmp") : folder) / "synthetic_dataset_XXXXXX";
  const int descriptor = mkstemp(path_.data());
  if (descriptor < 0) {
    const std::string wanted = std::exchange(path_, "");
    throw Error("no temporary file can be made like " + wanted +
                "; TMPDIR can name another folder");
  }
  close(descriptor);
}

TemporaryFile::~TemporaryFile() {
  if (!path_.empty()) unlink(path_.c_str());
}

TemporaryFile decompressZstdFile(const std::string& file) {
  std::ifstream from = base::openInput(file);
  TemporaryFile result;
  std::ofstream to(result.path(), std::ios::binary);
  constexpr std::uint64_t kLeftFree = std::uint64_t{256} << 20U;  // [byte] on the disk
  std::error_code error;
  const std::uint64_t room = std::filesystem::space(result.path(), error).available;
  const ZstdContext context = makeZstd();
  std::string input(ZSTD_DStreamInSize(), '\0');
  std::string output(ZSTD_DStreamOutSize(), '\0');
  std::uint64_t size = 0;
  bool is_end = false;
  while (from) {
    from.read(input.data(), static_cast<std::streamsize>(input.size()));
    std::string_view rest(input.data(), static_cast<std::size_t>(from.gcount()));
    bool is_full = false;  // then there may be more output pending
    while (!rest.empty() || is_full) {
      const Step step = stepOfZstd(context.get(), rest, output.data(), output.size());
      rest.remove_prefix(step.taken);
      is_full = step.made == output.size() && !step.is_end;
      is_end = step.is_end;
      size += step.made;
      to.write(output.data(), static_cast<std::streamsize>(step.made));
      if (!to || size + kLeftFree > room) {
        throw Error("becomes more than " + std::to_string(size >> 20U) +
                    " MiB when decompressed, for which there is no room next to " + result.path() +
                    "; TMPDIR can name another folder");
      }
    }
  }
  if (!is_end) throw Error("breaks off: its compressed content has no end");
  if (!to.flush()) throw Error("cannot be decompressed into " + result.path());
  return result;
}

}  // namespace synthetic_dataset::motion
