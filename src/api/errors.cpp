#include "synthetic_dataset/errors.h"

#include <utility>

namespace synthetic_dataset {
inline namespace v2 {
namespace {

std::string joinLines(const std::vector<std::string>& messages) {
  std::string text;
  for (const std::string& message : messages) {
    if (!text.empty()) text += '\n';
    text += message;
  }
  return text;
}

}  // namespace

ErrorList::ErrorList(std::vector<std::string> messages)
    : Error(joinLines(messages)), messages_(std::move(messages)) {}

}  // namespace v2
}  // namespace synthetic_dataset
