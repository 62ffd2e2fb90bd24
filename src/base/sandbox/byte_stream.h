#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {

/// Serializes values one after another, for another process of the same program.
class ByteWriter {
 public:
  template <class Number>
  void number(Number value) {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    raw(&value, sizeof(value));
  }
  void text(std::string_view value) {
    number<std::uint64_t>(value.size());
    raw(value.data(), value.size());
  }
  /// A list of numbers, or of Eigen's fixed-size vectors, which contain nothing else.
  template <class Element>
  void list(const std::vector<Element>& values) {
    number<std::uint64_t>(values.size());
    raw(values.data(), values.size() * sizeof(Element));
  }
  void raw(const void* data, std::size_t size) {
    bytes_.append(static_cast<const char*>(data), size);
  }

  [[nodiscard]] std::string take() { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Reads back what a ByteWriter wrote, in the same order.
/// Its methods throw Error if the bytes end too early.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  template <class Number>
  [[nodiscard]] Number number() {
    static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
    if constexpr (std::is_same_v<Number, bool>) {
      return number<std::uint8_t>() != 0;  // bytes other than 0 and 1 are not a bool
    } else {
      Number value{};
      copy(&value, sizeof(value));
      return value;
    }
  }
  [[nodiscard]] std::string text() {
    const std::size_t size = count(1);
    std::string value(bytes_.substr(0, size));
    bytes_.remove_prefix(size);
    return value;
  }
  template <class Element>
  [[nodiscard]] std::vector<Element> list() {
    std::vector<Element> values(count(sizeof(Element)));
    copy(values.data(), values.size() * sizeof(Element));
    return values;
  }
  /// How many entries follow, each of at least one byte.
  [[nodiscard]] std::size_t entries() { return count(1); }
  void copy(void* to, std::size_t size) {
    if (size > bytes_.size()) throw Error("its content arrived incomplete");
    if (size > 0) std::memcpy(to, bytes_.data(), size);
    bytes_.remove_prefix(size);
  }

 private:
  [[nodiscard]] std::size_t count(std::size_t element_size) {
    const auto value = number<std::uint64_t>();
    if (value > bytes_.size() / element_size) throw Error("its content arrived incomplete");
    return static_cast<std::size_t>(value);
  }

  std::string_view bytes_;
};

}  // namespace synthetic_dataset::base
