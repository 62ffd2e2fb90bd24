#include "output/manifest/shard.h"

#include <algorithm>

namespace synthetic_dataset::output {

std::string shardText(const Shard& shard) {
  return std::to_string(shard.index) + "/" + std::to_string(shard.count);
}

bool belongsTo(const Shard& shard, std::int64_t instant, std::int64_t instant_count) {
  constexpr std::int64_t kLongestBlock = 64;  // instants
  constexpr std::int64_t kBlocksOfEach = 4;   // at least, where there are so many instants
  const std::int64_t block =
      std::clamp<std::int64_t>(instant_count / (shard.count * kBlocksOfEach), 1, kLongestBlock);
  return instant / block % shard.count == shard.index;
}

}  // namespace synthetic_dataset::output
