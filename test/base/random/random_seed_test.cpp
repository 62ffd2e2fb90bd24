#include "base/random/random_seed.h"

#include <set>

#include <gtest/gtest.h>

namespace synthetic_dataset::base {
namespace random_seed_test {

TEST(RandomSeed, DiffersByRunSceneAndPurpose) {
  std::set<std::uint64_t> seeds;
  for (std::uint64_t run = 0; run < 10; ++run) {
    for (std::int64_t scene = 0; scene < 10; ++scene) {
      for (const char* purpose : {"noise", "light", ""}) {
        seeds.insert(randomSeed(run, scene, purpose));
      }
    }
  }
  EXPECT_EQ(seeds.size(), 300U);
}

TEST(RandomSeed, IsTheSameOnEveryMachine) {
  EXPECT_EQ(randomSeed(1, 2, "noise"), 7904174712041829097ULL);
}

}  // namespace random_seed_test
}  // namespace synthetic_dataset::base
