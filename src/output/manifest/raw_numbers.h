#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <type_traits>
#include <utility>

#include "synthetic_dataset/errors.h"

/// Converts numbers to the forms that the manifest stores.
namespace synthetic_dataset::output {

/// An index as SQLite stores it.
[[nodiscard]] inline std::int64_t signedIndex(std::size_t index) {
  return static_cast<std::int64_t>(index);
}

/// Appends a number as it is in memory; all systems that this runs on agree (IEEE 754,
/// little-endian).
template <class Number>
void appendRaw(const Number& number, std::string& bytes) {
  static_assert(std::is_arithmetic_v<Number>);
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &number, sizeof(Number));
  bytes.append(raw.data(), raw.size());
}

/// Reads numbers one after another from a string of bytes.
class RawNumbers {
 public:
  explicit RawNumbers(std::string bytes) : bytes_(std::move(bytes)) {}

  [[nodiscard]] bool isAtEnd() const { return at_ == bytes_.size(); }

  template <class Number>
  Number next() {
    if (bytes_.size() - at_ < sizeof(Number)) throw Error("a list in the manifest is damaged");
    Number number{};
    std::memcpy(&number, bytes_.data() + at_, sizeof(Number));
    at_ += sizeof(Number);
    return number;
  }

 private:
  std::string bytes_;
  std::size_t at_ = 0;
};

}  // namespace synthetic_dataset::output
