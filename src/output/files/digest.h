#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace synthetic_dataset::output {

/// SHA-256 (FIPS 180-4) of bytes that come piece by piece.
class Digest {
 public:
  Digest();
  ~Digest();
  Digest(Digest&&) noexcept;
  Digest& operator=(Digest&&) noexcept;

  void add(std::string_view bytes);

  /// 64 lower-case hexadecimal digits, as `sha256sum` prints them. Nothing may be added after it.
  [[nodiscard]] std::string text();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// Of bytes that are there as a whole.
[[nodiscard]] std::string digestOf(std::string_view bytes);

struct FileDigest {
  std::int64_t bytes = 0;
  std::string digest;
};

/// Of a file's content, read piece by piece.
/// @throws Error naming the file and why it cannot be read
[[nodiscard]] FileDigest digestOfFile(const std::string& path);

/// The same, but of files above 64 MiB that of their first and last 32 MiB: recordings may be too
/// large to be read for it. The end of a bag lists the times and counts of all that it holds.
[[nodiscard]] FileDigest digestOfInput(const std::string& path);

}  // namespace synthetic_dataset::output
