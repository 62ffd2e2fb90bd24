#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace synthetic_dataset {

/// Tells contents apart, not to be relied on against anybody who wants two to be alike: FNV-1a of
/// 64 bits (http://www.isthe.com/chongo/tech/comp/fnv/).
class Fingerprint {
 public:
  void add(const void* data, std::size_t size) {
    constexpr std::uint64_t kPrime = 0x100000001b3;
    const auto* bytes = static_cast<const unsigned char*>(data);
    for (std::size_t i = 0; i < size; ++i) hash_ = (hash_ ^ bytes[i]) * kPrime;
  }

  /// Sixteen hexadecimal digits.
  [[nodiscard]] std::string text() const {
    std::string digits;
    for (int shift = 60; shift >= 0; shift -= 4) {
      digits += "0123456789abcdef"[(hash_ >> shift) & 0xfU];
    }
    return digits;
  }

 private:
  std::uint64_t hash_ = 0xcbf29ce484222325;
};

}  // namespace synthetic_dataset
