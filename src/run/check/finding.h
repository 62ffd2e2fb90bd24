#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::run {

/// Something odd about a run: no error, since someone may want it so.
struct Finding {
  std::string kind;   ///< for programs, the same for all of its kind: "hidden"
  std::string about;  ///< an object, a camera, a setting; empty: the run
  std::string found;  ///< with its figures
  std::string cure;   ///< what mends it, in settings that a user can write

  /// "<found>; <cure>"
  [[nodiscard]] std::string what() const { return found + (cure.empty() ? "" : "; ") + cure; }

  /// "<about>: <found>; <cure>"
  [[nodiscard]] std::string message() const { return (about.empty() ? "" : about + ": ") + what(); }
};

/// Where more than four are of one kind, the first one speaks for the others and names them.
[[nodiscard]] std::vector<Finding> joinAlike(const std::vector<Finding>& findings);

}  // namespace synthetic_dataset::run
