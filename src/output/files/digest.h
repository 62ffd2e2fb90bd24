#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace synthetic_dataset::output {

/// SHA-256 (FIPS 180-4) of bytes that arrive in pieces.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(Digest&&) noexcept;
  Digest& operator=(Digest&&) noexcept;

  void add(std::string_view bytes);

  /// 64 lower-case hexadecimal digits, as printed by `sha256sum`. Nothing may be added afterwards.
  [[nodiscard]] std::string text();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Digest of bytes that are all in memory.
[[nodiscard]] std::string digestOf(std::string_view bytes);

struct FileDigest {
  std::int64_t bytes = 0;
  std::string digest;
};

/// Digest of a file's content, read in pieces.
/// @throws Error naming the file and why it cannot be read
[[nodiscard]] FileDigest digestOfFile(const std::string& path);

/// Digest of an input. For files above 64 MiB it covers only the first and last 32 MiB, since
/// recordings may be too large to read as a whole. The end of a bag lists the times and counts of
/// everything in it.
[[nodiscard]] FileDigest digestOfInput(const std::string& path);

}  // namespace synthetic_dataset::output
