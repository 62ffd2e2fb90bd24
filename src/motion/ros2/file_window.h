#pragma once

#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

namespace synthetic_dataset::motion {

/// A file of any size, read piece by piece.
class FileWindow {
 public:
  explicit FileWindow(const std::string& file);

  [[nodiscard]] std::uint64_t size() const { return size_; }

  /// Returns the bytes at this offset; the view is valid until the next call.
  /// @throws Error if the file does not have them
  [[nodiscard]] std::string_view at(std::uint64_t place, std::uint64_t count);

 private:
  std::ifstream stream_;
  std::uint64_t size_ = 0;
  std::string bytes_;
  std::uint64_t begin_ = 0;  ///< offset of bytes_ in the file
};

}  // namespace synthetic_dataset::motion
