#pragma once

#include <set>
#include <string>
#include <vector>

#include "output/manifest/run_description.h"
#include "run/reporter.h"

namespace synthetic_dataset {

/// Shows each kind of warning once; how often it came, the manifest knows.
class WarningTeller {
 public:
  explicit WarningTeller(Reporter& reporter) : reporter_(reporter) {}

  void tell(const std::vector<output::Warning>& warnings) {
    for (const output::Warning& warning : warnings) {
      if (!told_.insert(warning.kind).second) continue;
      reporter_.warning(warning.detail.empty() ? warning.kind
                                               : warning.kind + " (" + warning.detail + ")");
    }
  }

 private:
  Reporter& reporter_;
  std::set<std::string> told_;
};

}  // namespace synthetic_dataset
