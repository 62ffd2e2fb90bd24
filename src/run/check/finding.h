#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::run {

/// Something odd about a run: not an error, since it may be intended.
struct Finding {
  std::string kind;   ///< for programs, the same for all findings of a kind: "hidden"
  std::string about;  ///< an object, a camera or a setting; empty: the run
  std::string found;  ///< including figures
  std::string cure;   ///< the remedy, as settings that a user can write

  /// "<found>; <cure>"
  [[nodiscard]] std::string what() const { return found + (cure.empty() ? "" : "; ") + cure; }

  /// "<about>: <found>; <cure>"
  [[nodiscard]] std::string message() const { return (about.empty() ? "" : about + ": ") + what(); }
};

/// Merges more than four findings of one kind into the first one, which then names the others.
[[nodiscard]] std::vector<Finding> joinAlike(const std::vector<Finding>& findings);

}  // namespace synthetic_dataset::run
