#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace synthetic_dataset::motion {

/// Whether bytes begin as a frame of Zstandard (RFC 8878, section 3.1.1).
[[nodiscard]] bool isZstd(std::string_view bytes);

/// A frame of Zstandard, decompressed.
/// @throws Error where it is damaged, or becomes larger than kLargestContent or than any content of
///     such a length does
[[nodiscard]] std::string zstdDecompressed(std::string_view frame);

/// A frame of LZ4 (https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md), decompressed.
/// @throws Error likewise
[[nodiscard]] std::string lz4Decompressed(std::string_view frame);

/// A file that is removed with this object.
class TemporaryFile {
 public:
  /// Empty, where TMPDIR says, else in /tmp.
  TemporaryFile();
  ~TemporaryFile();
  TemporaryFile(TemporaryFile&& other) noexcept : path_(std::move(other.path_)) {
    other.path_.clear();
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  TemporaryFile& operator=(TemporaryFile&&) = delete;

  [[nodiscard]] const std::string& path() const { return path_; }

 private:
  std::string path_;
};

/// A file that is one frame of Zstandard or several, decompressed piece by piece.
/// @throws Error where it is damaged, or there is not enough room on the disk
[[nodiscard]] TemporaryFile decompressZstdFile(const std::string& file);

}  // namespace synthetic_dataset::motion
