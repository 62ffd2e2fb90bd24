#include "synthetic_dataset/label_text.h"

#include <array>
#include <cstdio>
#include <iomanip>
#include <locale>
#include <sstream>

#include "synthetic_dataset/fingerprint.h"

namespace synthetic_dataset {
inline namespace v2 {

std::string fixed(double number, int decimals) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());  // a decimal point, whatever the user's language
  stream << std::fixed << std::setprecision(decimals) << number;
  return stream.str();
}

std::string sceneNumber(std::int64_t index) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%08lld", static_cast<long long>(index));
  return buffer.data();
}

std::string safeFileName(const std::string& text) {
  constexpr std::size_t kLongest = 80;  // [byte]; several such names fit into one path
  const auto isContinuation = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
  };
  std::string name = text;
  if (name.size() > kLongest) {
    std::size_t end = kLongest;
    while (end > 0 && isContinuation(name[end])) --end;  // do not split a UTF-8 character
    name.resize(end);
  }
  for (char& c : name) {
    const auto byte = static_cast<unsigned char>(c);
    const bool stays = byte >= 0x80U || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z') ||
                       (c >= 'a' && c <= 'z') || c == '-' || c == '_' || c == '.';
    if (!stays) c = '_';
  }
  if (!name.empty() && name.front() == '.')
    name.front() = '_';  // would be hidden, or the parent folder
  if (!name.empty() && name == text) return name;
  constexpr std::size_t kDigits = 8;
  return name + "_" + Fingerprint(text).text().substr(0, kDigits);
}

}  // namespace v2
}  // namespace synthetic_dataset
