#pragma once

#include <cstdint>
#include <string>

#include "output/output_options.h"

namespace synthetic_dataset::output {

/// "2/8"
[[nodiscard]] std::string shardText(const Shard& shard);

/// Whether an instant belongs to a shard. Blocks are long enough that work in a row stays together,
/// and short enough that all shards have as much to do.
[[nodiscard]] bool belongsTo(const Shard& shard, std::int64_t instant, std::int64_t instant_count);

}  // namespace synthetic_dataset::output
