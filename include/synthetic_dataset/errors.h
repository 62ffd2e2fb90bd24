#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace synthetic_dataset {
inline namespace v2 {

/// Anything that the user can fix: the message names the parameter or the file, what was found and
/// what would be right.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Several errors that are reported together, so that the user can fix them in one go.
class ErrorList : public Error {
 public:
  /// @param messages  at least one
  explicit ErrorList(std::vector<std::string> messages);

  [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }

 private:
  std::vector<std::string> messages_;
};

}  // namespace v2
}  // namespace synthetic_dataset
