#include "world/files/trial_process.h"

#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include <gmock/gmock.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

using testing::Field;
using testing::HasSubstr;
using testing::VariantWith;

TEST(TryWork, HandsOverWhatTheWorkReturns) {
  const std::string large(std::size_t{5} << 20U, 'x');
  EXPECT_EQ(std::get<std::string>(tryWork([&] { return large; }, TrialLimits())), large);
}

TEST(TryWork, ThrowsWhatTheWorkThrows) {
  const auto work = []() -> std::string { throw Error("has no triangles"); };
  EXPECT_THAT([&] { static_cast<void>(tryWork(work, TrialLimits())); },
              testing::ThrowsMessage<Error>(testing::StrEq("has no triangles")));
}

TEST(TryWork, TellsHowWorkCrashes) {
  EXPECT_THAT(tryWork([]() -> std::string { std::abort(); }, TrialLimits()),
              VariantWith<Breakdown>(Field(&Breakdown::how, HasSubstr("crashes (Abort"))));
}

TEST(TryWork, TellsOfALibraryThatEndsTheProcess) {
  EXPECT_THAT(tryWork([]() -> std::string { std::_Exit(7); }, TrialLimits()),
              VariantWith<Breakdown>(Field(&Breakdown::how, HasSubstr("ends with exit code 7"))));
}

TEST(TryWork, TellsOfTooMuchMemory) {
  TrialLimits limits;
  limits.memory = std::uint64_t{64} << 20U;
  const auto work = [] {
    std::vector<char>(std::size_t{200} << 20U).at(5) = 1;
    return std::string();
  };
  EXPECT_THAT(tryWork(work, limits),
              VariantWith<Breakdown>(Field(&Breakdown::how, HasSubstr("64 MiB of memory"))));
}

TEST(TryWork, TellsOfWorkThatDoesNotEnd) {
  TrialLimits limits;
  limits.processor_time = std::chrono::seconds(1);
  const auto work = [] {
    for (volatile std::uint64_t i = 0;; i = i + 1) {
    }
    return std::string();
  };
  EXPECT_THAT(tryWork(work, limits),
              VariantWith<Breakdown>(Field(&Breakdown::how, HasSubstr("within 1 s"))));
}

TEST(TrialProcess, WorksBesideOthers) {
  std::vector<TrialProcess> processes;
  for (const char letter : {'a', 'b', 'c'}) {
    const auto work = [letter] { return std::string(std::size_t{3} << 20U, letter); };
    processes.emplace_back(work, TrialLimits());
  }
  for (const std::size_t i : {2, 0, 1}) {
    const auto answer = std::get<std::string>(processes[i].finish());
    EXPECT_EQ(answer.size(), std::size_t{3} << 20U);
    EXPECT_EQ(answer.back(), "abc"[i]);
  }
}

TEST(TrialProcess, EndsWithItsObject) {
  const auto sleep = [] {
    pause();
    return std::string();
  };
  { const TrialProcess process(sleep, TrialLimits()); }
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace synthetic_dataset::world
