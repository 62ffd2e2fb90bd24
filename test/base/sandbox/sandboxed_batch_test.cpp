#include "base/sandbox/sandboxed_batch.h"

#include <cstdlib>
#include <new>

#include <gmock/gmock.h>

#include "base/sandbox/sandboxed_process.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace sandboxed_batch_test {

using testing::Each;
using testing::IsEmpty;
using testing::Optional;

constexpr std::chrono::seconds kTime{10};

TEST(TryAll, GivesEachPieceItsResult) {
  std::vector<SandboxedWork> pieces;
  for (int i = 0; i < 50; ++i) pieces.push_back({[i] { return std::to_string(i); }, kTime});
  const auto results = runAllSandboxed(pieces, SandboxLimits().memory);
  ASSERT_EQ(results.size(), pieces.size());
  for (int i = 0; i < 50; ++i) {
    EXPECT_THAT(results[static_cast<std::size_t>(i)], Optional(std::to_string(i)));
  }
}

TEST(TryAll, OfNothingIsNothing) {
  EXPECT_THAT(runAllSandboxed({}, SandboxLimits().memory), IsEmpty());
}

TEST(TryAll, LeavesOutWhatFailsAlone) {
  const std::vector<SandboxedWork> pieces = {
      {[] { return std::string("a"); }, kTime},
      {[]() -> std::string { throw Error("has no triangles"); }, kTime},
      {[] { return std::string(); }, kTime},
      {[] { return std::string("d"); }, kTime}};
  EXPECT_THAT(runAllSandboxed(pieces, SandboxLimits().memory),
              testing::ElementsAre(Optional(std::string("a")), std::nullopt,
                                   Optional(std::string()), Optional(std::string("d"))));
}

/// The pieces that share the crashed process are lost, whichever they are, and no others.
TEST(TryAll, LosesNoMoreThanOneProcessToACrash) {
  std::vector<SandboxedWork> pieces(9, {[] { return std::string("whole"); }, kTime});
  pieces[4].work = []() -> std::string { std::abort(); };
  const auto results = runAllSandboxed(pieces, SandboxLimits().memory);
  EXPECT_EQ(results[4], std::nullopt);
  EXPECT_THAT(results, Each(testing::AnyOf(std::nullopt, Optional(std::string("whole")))));
}

/// The test throws the exception itself, because AddressSanitizer's `new` ends the process at the
/// limit instead of throwing.
TEST(TryAll, LeavesOutWhatNeedsTooMuchMemoryAlone) {
  std::vector<SandboxedWork> pieces(5, {[] { return std::string("whole"); }, kTime});
  pieces[2].work = []() -> std::string { throw std::bad_alloc(); };
  const auto results = runAllSandboxed(pieces, SandboxLimits().memory);
  EXPECT_THAT(results,
              testing::ElementsAre(Optional(std::string("whole")), Optional(std::string("whole")),
                                   std::nullopt, Optional(std::string("whole")),
                                   Optional(std::string("whole"))));
}

}  // namespace sandboxed_batch_test
}  // namespace synthetic_dataset::base
