#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "output/verify/dataset_verifier.h"

namespace synthetic_dataset::test {

/// Keeps what verifying a dataset finds.
struct VerificationList : output::VerificationListener {
  void problem(const std::string& line) override { problems.push_back(line); }
  void remark(const std::string& line) override { remarks.push_back(line); }
  void progress(std::int64_t /*scene_count*/, std::int64_t /*of*/) override {}

  std::vector<std::string> problems;
  std::vector<std::string> remarks;
};

}  // namespace synthetic_dataset::test
