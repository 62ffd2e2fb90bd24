#pragma once

#include <string>

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

}  // namespace synthetic_dataset::run
