#include "synthetic_dataset/label_text.h"

#include <array>
#include <cstdio>
#include <iomanip>
#include <locale>
#include <sstream>

namespace synthetic_dataset {
inline namespace v1 {

std::string fixed(double number, int decimals) {
  std::ostringstream stream;
  stream.imbue(std::locale::classic());  // a point, whatever the user's language
  stream << std::fixed << std::setprecision(decimals) << number;
  return stream.str();
}

std::string sceneNumber(std::int64_t index) {
  std::array<char, 32> buffer{};
  std::snprintf(buffer.data(), buffer.size(), "%08lld", static_cast<long long>(index));
  return buffer.data();
}

}  // namespace v1
}  // namespace synthetic_dataset
