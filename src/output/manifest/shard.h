#pragma once

#include <cstdint>
#include <string>

namespace synthetic_dataset::output {

/// What a run makes of a job: every `count`-th block of instants, beginning with block `index`.
struct Shard {
  std::int64_t index = 0;  ///< 0 .. count - 1
  std::int64_t count = 1;
};

/// "2/8"
[[nodiscard]] std::string shardText(const Shard& shard);

/// Whether an instant belongs to a shard. Blocks are long enough that work in a row stays together,
/// and short enough that all shards have as much to do.
[[nodiscard]] bool belongsTo(const Shard& shard, std::int64_t instant, std::int64_t instant_count);

}  // namespace synthetic_dataset::output
