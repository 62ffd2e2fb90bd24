#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "config/config.h"
#include "synthetic_dataset/label_writer.h"

namespace synthetic_dataset {

/// Which split each of a run's times belongs to: a function of the settings, the seed and the
/// number of times alone.
class SplitPlan {
 public:
  /// @param instant_count  how many times there are
  SplitPlan(const config::SplitConfig& config, std::uint64_t seed, std::int64_t instant_count);

  /// The name of a time's split; empty where there are none.
  [[nodiscard]] const std::string& at(std::int64_t instant) const;

  /// The splits with their numbers of scenes.
  /// @param camera_count  scenes at each time
  [[nodiscard]] std::vector<SplitInfo> splits(std::size_t camera_count) const;

 private:
  std::vector<std::string> names_;
  std::vector<std::uint8_t> split_of_;  ///< of each time, a place in names_; empty without splits
};

}  // namespace synthetic_dataset
