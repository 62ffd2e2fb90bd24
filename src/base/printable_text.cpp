#include "base/printable_text.h"

#include <algorithm>
#include <clocale>
#include <cstddef>

namespace synthetic_dataset::base {
namespace {

unsigned byteAt(std::string_view text, std::size_t at) {
  return at < text.size() ? static_cast<unsigned char>(text[at]) : 0U;
}

/// The number of bytes of the character that begins at a position; 0 if none does (RFC 3629,
/// section 4).
std::size_t lengthOfCharacter(std::string_view text, std::size_t at) {
  const unsigned first = byteAt(text, at);
  if (first < 0x80U) return 1;
  const std::size_t length = first >= 0xC2U && first <= 0xDFU   ? 2
                             : first >= 0xE0U && first <= 0xEFU ? 3
                             : first >= 0xF0U && first <= 0xF4U ? 4
                                                                : 0;
  for (std::size_t i = 1; i < length; ++i) {
    if ((byteAt(text, at + i) & 0xC0U) != 0x80U) return 0;
  }
  const unsigned second = byteAt(text, at + 1);
  const bool is_overlong = (first == 0xE0U && second < 0xA0U) || (first == 0xF0U && second < 0x90U);
  const bool is_none = (first == 0xEDU && second >= 0xA0U) || (first == 0xF4U && second >= 0x90U);
  return is_overlong || is_none ? 0 : length;
}

/// U+0000 to U+001F except tab and line feed, U+007F to U+009F.
bool isControl(std::string_view character) {
  const unsigned first = byteAt(character, 0);
  if (first == '\n' || first == '\t') return false;
  return first < 0x20U || first == 0x7FU || (first == 0xC2U && byteAt(character, 1) < 0xA0U);
}

/// @param isUnwanted  whether the bytes of a character are escaped
template <class Predicate>
std::string escaped(std::string_view text, const Predicate& isUnwanted) {
  constexpr const char* kDigits = "0123456789abcdef";
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t length = lengthOfCharacter(text, at);
    const std::string_view character = text.substr(at, std::max<std::size_t>(length, 1));
    if (length > 0 && !isUnwanted(character)) {
      result += character;
    } else {
      for (const char c : character) {
        const auto byte = static_cast<unsigned char>(c);
        result += {'\\', 'x', kDigits[byte >> 4U], kDigits[byte & 0xFU]};
      }
    }
    at += character.size();
  }
  return result;
}

}  // namespace

std::string asUtf8(std::string_view text) {
  return escaped(text, [](std::string_view) { return false; });
}

std::string printable(std::string_view text) { return escaped(text, isControl); }

void printUtf8() {
  for (const char* locale : {"C.UTF-8", "C.utf8", "en_US.UTF-8"}) {
    if (std::setlocale(LC_CTYPE, locale) != nullptr) return;
  }
}

}  // namespace synthetic_dataset::base
