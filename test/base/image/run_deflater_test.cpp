#include "base/image/run_deflater.h"

#include <random>

#include <gtest/gtest.h>

#include "base/image/inflated.h"

namespace synthetic_dataset::base {
namespace run_deflater_test {

using Bytes = std::vector<std::uint8_t>;
using test::inflated;

TEST(RunDeflater, HoldsRunsOfEveryLength) {
  RunDeflater deflater;
  Bytes expected;
  for (std::size_t count = 1; count < 800; ++count) {
    const std::uint8_t byte = count % 2 == 0 ? 0 : 255;
    deflater.add(byte, count);
    expected.insert(expected.end(), count, byte);
  }
  EXPECT_TRUE(inflated(deflater.finish(), expected.size()) == expected);
}

TEST(RunDeflater, JoinsRunsOfTheSame) {
  std::mt19937 random(3);
  RunDeflater joined;
  RunDeflater whole;
  for (int run = 0; run < 200; ++run) {
    const std::uint8_t byte = run % 2 == 0 ? 255 : 0;
    const std::size_t first = random() % 300;
    const std::size_t second = 1 + random() % 3;
    joined.add(byte, first);
    joined.add(byte, second);
    whole.add(byte, first + second);
  }
  EXPECT_EQ(joined.finish(), whole.finish());
}

TEST(RunDeflater, HoldsNothingAndVeryMuch) {
  EXPECT_FALSE(RunDeflater().finish().empty());
  constexpr std::size_t kMany = 50'000'000;
  RunDeflater deflater;
  deflater.add(255, kMany);
  const Bytes stream = deflater.finish();
  EXPECT_LT(stream.size(), kMany / 1000);
  EXPECT_TRUE(inflated(stream, kMany) == Bytes(kMany, 255));
}

}  // namespace run_deflater_test
}  // namespace synthetic_dataset::base
