#include "motion/ros2/cdr.h"

#include <cstdint>
#include <cstring>
#include <limits>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {
namespace {

constexpr std::size_t kHead = 4;  // [byte]

/// The encoding that a representation identifier means (DDS-XTypes 1.3, section 7.6.3.1.2, table
/// 60).
std::string nameOfEncoding(unsigned identifier) {
  switch (identifier) {
    case 0x02:
    case 0x03:
      return "a parameter list (PL_CDR)";
    case 0x06:
    case 0x07:
      return "XCDR2 (PLAIN_CDR2)";
    case 0x08:
    case 0x09:
      return "XCDR2 (DELIMITED_CDR2)";
    case 0x0A:
    case 0x0B:
      return "XCDR2 with a parameter list (PL_CDR2)";
    default:
      return "unknown (" + std::to_string(identifier) + ")";
  }
}

/// Reads CDR and writes ROS 1's serialisation.
class Converter {
 public:
  Converter(std::string_view content, bool is_little) : rest_(content), is_little_(is_little) {
    size_ = content.size();
    written_.reserve(content.size() + content.size() / 4 + sizeof(std::uint32_t));
  }

  void convert(const MessageLayout& layout) {
    if (layout.type == "std_msgs/Header") writeNumber(0);  // ROS 1's `seq`
    for (const FieldLayout& field : layout.fields) convert(field);
  }

  std::string finish() {
    constexpr std::size_t kLongestPadding = 7;
    if (rest_.size() > kLongestPadding) {
      throw Error("has " + std::to_string(rest_.size()) + " bytes more than its type");
    }
    if (written_.size() > std::numeric_limits<std::uint32_t>::max()) throw Error("is too long");
    return std::move(written_);
  }

 private:
  void convert(const FieldLayout& field) {
    std::uint32_t count = field.fixed_count;
    if (field.count == FieldLayout::Count::kList) {
      count = number();
      const std::uint64_t least = field.number_size > 0 ? field.number_size
                                  : field.message       ? field.message->least_size
                                                        : sizeof(std::uint32_t);
      if (least == 0 || count > rest_.size() / least) {
        throw Error("has a list '" + field.name + "' of " + std::to_string(count) +
                    " entries, more than its bytes can hold");
      }
      writeNumber(count);
    }
    if (field.number_size > 0) {
      convertNumbers(count, field.number_size);
    } else if (field.message) {
      for (std::uint32_t i = 0; i < count; ++i) convert(*field.message);
    } else {
      for (std::uint32_t i = 0; i < count; ++i) convertText(field.name);
    }
  }

  /// Skips padding: numbers start at multiples of their size, counted from the start of the
  /// content.
  void align(std::size_t to) {
    const std::size_t place = size_ - rest_.size();
    static_cast<void>(take((to - place % to) % to));
  }

  std::string_view take(std::uint64_t count) {
    if (count > rest_.size()) throw Error("breaks off");
    const std::string_view taken = rest_.substr(0, count);
    rest_.remove_prefix(count);
    return taken;
  }

  std::uint32_t number() {
    align(sizeof(std::uint32_t));
    const std::string_view bytes = take(sizeof(std::uint32_t));
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      const std::size_t from = is_little_ ? bytes.size() - 1 - i : i;
      value = value << 8U | static_cast<unsigned char>(bytes[from]);
    }
    return value;
  }

  void writeNumber(std::uint32_t value) {
    for (unsigned i = 0; i < sizeof value; ++i) {
      written_ += static_cast<char>(value >> (8U * i) & 0xFFU);
    }
  }

  void convertNumbers(std::uint64_t count, std::size_t size) {
    if (count == 0) return;  // not even padding
    align(size);
    const std::string_view bytes = take(count * size);
    if (is_little_ || size == 1) {
      written_ += bytes;
      return;
    }
    for (std::size_t at = 0; at < bytes.size(); at += size) {
      const std::string_view one = bytes.substr(at, size);
      written_.append(one.rbegin(), one.rend());
    }
  }

  void convertText(const std::string& name) {
    const std::uint32_t length = number();
    std::string_view text = take(length);
    // The length includes the terminating zero; some writers give 0 for an empty text.
    if (!text.empty()) {
      if (text.back() != '\0') throw Error("has a text '" + name + "' without its end");
      text.remove_suffix(1);
    }
    writeNumber(static_cast<std::uint32_t>(text.size()));
    written_ += text;
  }

  std::string_view rest_;
  std::size_t size_ = 0;
  bool is_little_;
  std::string written_;
};

}  // namespace

std::string ros1Serialized(std::string_view cdr, const MessageLayout& layout) {
  if (cdr.size() < kHead) throw Error("has no head");
  const unsigned identifier =
      static_cast<unsigned char>(cdr[0]) * 256U + static_cast<unsigned char>(cdr[1]);
  if (identifier > 1) {
    throw Error("has the encoding " + nameOfEncoding(identifier) + "; plain CDR can be read");
  }
  Converter converter(cdr.substr(kHead), identifier == 1);
  converter.convert(layout);
  return converter.finish();
}

}  // namespace synthetic_dataset::motion
