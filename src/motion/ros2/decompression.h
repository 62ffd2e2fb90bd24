#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace synthetic_dataset::motion {

/// Whether bytes begin like a Zstandard frame (RFC 8878, section 3.1.1).
[[nodiscard]] bool isZstd(std::string_view bytes);

/// Decompresses a Zstandard frame.
/// @throws Error if it is damaged, or its content is larger than kLargestContent or than a frame of
///     such a length can hold
[[nodiscard]] std::string zstdDecompressed(std::string_view frame);

/// Decompresses an LZ4 frame (https://github.com/lz4/lz4/blob/dev/doc/lz4_Frame_format.md).
/// @throws Error as zstdDecompressed does
[[nodiscard]] std::string lz4Decompressed(std::string_view frame);

/// A file that is deleted together with this object.
class TemporaryFile {
 public:
  /// Creates an empty file in the folder that TMPDIR names, or else in /tmp.
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

/// Decompresses a file of one or several Zstandard frames, piece by piece.
/// @throws Error if it is damaged, or there is not enough room on the disk
[[nodiscard]] TemporaryFile decompressZstdFile(const std::string& file);

}  // namespace synthetic_dataset::motion
