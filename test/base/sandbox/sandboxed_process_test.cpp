#include "base/sandbox/sandboxed_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace sandboxed_process_test {

using testing::Field;
using testing::HasSubstr;
using testing::VariantWith;

TEST(TryWork, HandsOverWhatTheWorkReturns) {
  const std::string large(std::size_t{5} << 20U, 'x');
  EXPECT_EQ(std::get<std::string>(runSandboxed([&] { return large; }, SandboxLimits())), large);
}

TEST(TryWork, ThrowsWhatTheWorkThrows) {
  const auto work = []() -> std::string { throw Error("has no triangles"); };
  EXPECT_THAT(test::messagesOf([&] { static_cast<void>(runSandboxed(work, SandboxLimits())); }),
              testing::ElementsAre(testing::StrEq("has no triangles")));
}

TEST(TryWork, TellsHowWorkCrashes) {
  EXPECT_THAT(runSandboxed([]() -> std::string { std::abort(); }, SandboxLimits()),
              VariantWith<Crash>(Field(&Crash::how, HasSubstr("crashes (Abort"))));
}

TEST(TryWork, TellsOfALibraryThatEndsTheProcess) {
  EXPECT_THAT(runSandboxed([]() -> std::string { std::_Exit(7); }, SandboxLimits()),
              VariantWith<Crash>(Field(&Crash::how, HasSubstr("ends with exit code 7"))));
}

TEST(TryWork, TellsOfAKillThatIsNoQuestionOfTime) {
  const auto work = []() -> std::string {
    raise(SIGKILL);
    return "";
  };
  EXPECT_THAT(runSandboxed(work, SandboxLimits()),
              VariantWith<Crash>(Field(&Crash::how, HasSubstr("short of memory"))));
}

TEST(TryWork, TellsOfTooMuchMemory) {
  SandboxLimits limits;
  limits.memory = std::uint64_t{64} << 20U;
  const auto work = [] {
    std::vector<char>(std::size_t{200} << 20U).at(5) = 1;
    return std::string();
  };
  EXPECT_THAT(runSandboxed(work, limits),
              VariantWith<Crash>(Field(&Crash::how, HasSubstr("64 MiB of memory"))));
}

TEST(TryWork, TellsOfWorkThatDoesNotEnd) {
  SandboxLimits limits;
  limits.processor_time = std::chrono::seconds(1);
  const auto work = [] {
    for (volatile std::uint64_t i = 0;; i = i + 1) {
    }
    return std::string();
  };
  EXPECT_THAT(runSandboxed(work, limits),
              VariantWith<Crash>(Field(&Crash::how, HasSubstr("within 1 s"))));
}

rlim_t processorTime() {
  rlimit limit{};
  getrlimit(RLIMIT_CPU, &limit);
  return limit.rlim_cur;
}

TEST(LimitSandboxTime, IsOfWhatFollows) {
  SandboxLimits limits;
  limits.processor_time = std::chrono::seconds(1000);
  const auto timeAfter = [&](std::chrono::seconds time) {
    const auto work = [time] {
      limitSandboxTime(time);
      return std::to_string(processorTime());
    };
    return std::stoul(std::get<std::string>(runSandboxed(work, limits)));
  };
  EXPECT_GE(timeAfter(std::chrono::seconds(20)), 20);
  EXPECT_LE(timeAfter(std::chrono::seconds(20)), 900);
  EXPECT_LE(timeAfter(std::chrono::seconds(5000)), 1001);
}

TEST(LimitSandboxTime, LeavesOtherProcessesAlone) {
  const rlim_t before = processorTime();
  limitSandboxTime(std::chrono::seconds(20));
  EXPECT_EQ(processorTime(), before);
}

TEST(SandboxedProcess, WorksBesideOthers) {
  std::vector<SandboxedProcess> processes;
  for (const char letter : {'a', 'b', 'c'}) {
    const auto work = [letter] { return std::string(std::size_t{3} << 20U, letter); };
    processes.emplace_back(work, SandboxLimits());
  }
  for (const std::size_t i : {2, 0, 1}) {
    const auto answer = std::get<std::string>(processes[i].finish());
    EXPECT_EQ(answer.size(), std::size_t{3} << 20U);
    EXPECT_EQ(answer.back(), "abc"[i]);
  }
}

/// Work that blocks for ever in its first `waits` starts, as if on a lock that another thread held
/// when the process was forked.
class WaitingWork {
 public:
  explicit WaitingWork(std::uintmax_t waits) : waits_(waits) {}

  std::string operator()() const {
    std::ofstream(file_, std::ios::app) << '.' << std::flush;
    if (starts() <= waits_) pause();
    return "done";
  }
  [[nodiscard]] std::uintmax_t starts() const { return std::filesystem::file_size(file_); }

 private:
  test::TemporaryFolder folder_;
  std::string file_ = folder_.path() / "starts";
  std::uintmax_t waits_;
};

SandboxLimits impatient() {
  SandboxLimits limits;
  limits.idle = std::chrono::milliseconds(20);
  return limits;
}

TEST(SandboxedProcess, IsStartedAnewWhereItWaits) {
  const WaitingWork work(2);
  EXPECT_THAT(runSandboxed(std::cref(work), impatient()), VariantWith<std::string>("done"));
  EXPECT_EQ(work.starts(), 3);
}

TEST(SandboxedProcess, IsNotStartedAnewForEver) {
  const WaitingWork waiting(1000);
  const auto work = [&waiting] {
    ualarm(200'000, 0);  // ends a process that hangs, long after it should have been restarted
    return waiting();
  };
  EXPECT_THAT(runSandboxed(work, impatient()), VariantWith<Crash>(testing::_));
  EXPECT_EQ(waiting.starts(), 4);
}

TEST(SandboxedProcess, EndsWithTheProgram) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  const pid_t program = fork();
  if (program == 0) {
    const auto sleep = [&] {
      EXPECT_EQ(write(ends[1], ".", 1), 1);
      pause();
      return std::string();
    };
    (void)runSandboxed(sleep, SandboxLimits());
    _exit(0);
  }
  close(ends[1]);
  char begun = 0;
  ASSERT_EQ(read(ends[0], &begun, 1), 1);
  kill(program, SIGKILL);
  waitpid(program, nullptr, 0);
  // The pipe hangs up once no process holds its other end any more.
  constexpr int kLong = 30'000;  // [ms]
  pollfd end{ends[0], POLLIN, 0};
  EXPECT_EQ(poll(&end, 1, kLong), 1) << "the work goes on";
  close(ends[0]);
}

TEST(SandboxedProcess, EndsWithItsObject) {
  const auto sleep = [] {
    pause();
    return std::string();
  };
  { const SandboxedProcess process(sleep, SandboxLimits()); }
  EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace sandboxed_process_test
}  // namespace synthetic_dataset::base
