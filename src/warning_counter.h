#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "reporter.h"

namespace synthetic_dataset {

/// Shows each kind of warning once and counts how often it came.
class WarningCounter {
 public:
  explicit WarningCounter(Reporter& reporter) : reporter_(reporter) {}

  /// @param kind  what is counted together
  /// @param detail  added to the first showing only ("by 0.03 m in scene 12")
  void add(const std::string& kind, const std::string& detail = "") {
    if (++counts_[kind] == 1) {
      reporter_.warning(detail.empty() ? kind : kind + " (" + detail + ")");
    }
  }

  [[nodiscard]] const std::map<std::string, std::int64_t>& counts() const { return counts_; }

 private:
  Reporter& reporter_;
  std::map<std::string, std::int64_t> counts_;
};

}  // namespace synthetic_dataset
