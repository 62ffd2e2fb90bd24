#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace synthetic_dataset {
inline namespace v2 {

/// A hash that tells contents apart but does not resist deliberate collisions: 64-bit FNV-1a
/// (http://www.isthe.com/chongo/tech/comp/fnv/). The same on every machine.
class Fingerprint {
 public:
  Fingerprint() = default;
  explicit Fingerprint(std::string_view text) { add(text.data(), text.size()); }

  void add(const void* data, std::size_t size) {
    constexpr std::uint64_t kPrime = 0x100000001b3;
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) value_ = (value_ ^ bytes[i]) * kPrime;
  }

  [[nodiscard]] std::uint64_t value() const { return value_; }

  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const {
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) {
      digits += "0123456789abcdef"[(value_ >> shift) & 0xfU];
    }
    return digits;
  }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace v2
}  // namespace synthetic_dataset
