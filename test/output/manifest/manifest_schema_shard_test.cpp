#include <algorithm>
#include <vector>

#include <gmock/gmock.h>

#include "output/manifest/manifest_schema.h"

namespace synthetic_dataset::output {
namespace shard_test {

class Shards : public testing::TestWithParam<std::pair<std::int64_t, std::int64_t>> {};

TEST_P(Shards, HaveEachInstantOnceAndAboutAsMuchToDo) {
  const auto [count, instants] = GetParam();
  std::vector<std::int64_t> work(static_cast<std::size_t>(count), 0);
  for (std::int64_t instant = 0; instant < instants; ++instant) {
    int owners = 0;
    for (std::int64_t index = 0; index < count; ++index) {
      if (!belongsTo({index, count}, instant, instants)) continue;
      ++owners;
      ++work[static_cast<std::size_t>(index)];
    }
    EXPECT_EQ(owners, 1) << "instant " << instant;
  }
  const auto [least, most] = std::minmax_element(work.begin(), work.end());
  EXPECT_LE(*most - *least,
            std::min<std::int64_t>(64, std::max<std::int64_t>(1, instants / (4 * count))));
}

INSTANTIATE_TEST_SUITE_P(OfManySizes, Shards,
                         testing::Values(std::pair{1, 10}, std::pair{2, 1}, std::pair{3, 16},
                                         std::pair{4, 100}, std::pair{7, 10000},
                                         std::pair{100, 50}));

}  // namespace shard_test
}  // namespace synthetic_dataset::output
