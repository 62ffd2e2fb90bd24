#include "base/sandbox/kept_process.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::base {
namespace kept_process_test {

using testing::Eq;
using testing::Optional;

/// Does what the request says.
std::string obey(std::string_view request) {
  if (request == "crash") std::abort();
  if (request == "throw") throw Error("no");
  if (request == "end") std::_Exit(0);
  if (request == "work for ever") {
    volatile bool is_for_ever = true;
    while (is_for_ever) {
    }
  }
  if (request == "wait for ever") std::this_thread::sleep_for(std::chrono::hours(1));
  if (request == "process") return std::to_string(getpid());
  if (request == "memory") return std::string(std::size_t{1} << 30U, 'x');
  return std::string(request) + "!";
}

SandboxLimits shortLimits() {
  SandboxLimits limits;
  limits.processor_time = std::chrono::seconds(1);
  limits.memory = std::uint64_t{512} << 20U;
  limits.idle = std::chrono::milliseconds(50);
  return limits;
}

TEST(KeptProcess, AnswersOneRequestAfterTheOther) {
  KeptProcess process(obey, shortLimits());
  const std::string large(std::size_t{5} << 20U, 'x');
  EXPECT_THAT(process.ask("a"), Optional(Eq("a!")));
  EXPECT_THAT(process.ask(large), Optional(Eq(large + "!")));
  EXPECT_THAT(process.ask(""), Optional(Eq("!")));
  const auto first = process.ask("process");
  EXPECT_NE(first, std::to_string(getpid()));
  EXPECT_EQ(process.ask("process"), first);
}

TEST(KeptProcess, FailsAloneAtWhatItCannotDo) {
  KeptProcess process(obey, shortLimits());
  for (const char* request :
       {"crash", "throw", "end", "work for ever", "wait for ever", "memory"}) {
    EXPECT_EQ(process.ask(request), std::nullopt) << request;
    EXPECT_THAT(process.ask("a"), Optional(Eq("a!"))) << request;
  }
}

TEST(KeptProcess, GivesEachRequestItsOwnTime) {
  KeptProcess process(
      [](std::string_view) {
        const auto end = clock() + 4 * CLOCKS_PER_SEC / 10;
        while (clock() < end) {
        }
        return std::string("done");
      },
      shortLimits());
  for (int i = 0; i < 6; ++i) EXPECT_THAT(process.ask(""), Optional(Eq("done")));
}

TEST(KeptProcess, AnswersSeveralThreads) {
  KeptProcess process(obey, shortLimits());
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&process, name = std::to_string(i)] {
      for (int k = 0; k < 50; ++k) EXPECT_THAT(process.ask(name), Optional(Eq(name + "!")));
    });
  }
  for (std::thread& thread : threads) thread.join();
}

TEST(KeptProcess, KeepsNoFileOpen) {
  const test::TemporaryFolder folder;
  const int file = open(folder.write("a", "").c_str(), O_RDONLY);
  KeptProcess process(
      [](std::string_view path) {
        for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
          std::error_code gone;
          if (std::filesystem::read_symlink(entry, gone) == path) return "open";
        }
        return "closed";
      },
      shortLimits());
  EXPECT_THAT(process.ask((folder / "a").string()), Optional(Eq("closed")));
  close(file);
}

/// If set, a forked process blocks before it has read anything, as if on a lock that it inherited.
bool waits_after_fork = false;

TEST(KeptProcess, FailsWhereTheProcessNeverTakesTheRequest) {
  pthread_atfork(nullptr, nullptr, [] {
    if (waits_after_fork) pause();
  });
  KeptProcess process(obey, shortLimits());
  waits_after_fork = true;
  EXPECT_EQ(process.ask(std::string(std::size_t{5} << 20U, 'x')), std::nullopt);
  waits_after_fork = false;
  EXPECT_THAT(process.ask("a"), Optional(Eq("a!")));
}

TEST(KeptProcess, EndsWithItsOwner) {
  int process_number = 0;
  {
    KeptProcess process(obey, shortLimits());
    process_number = std::stoi(process.ask("process").value());
    EXPECT_EQ(kill(process_number, 0), 0);
  }
  EXPECT_NE(kill(process_number, 0), 0);
}

TEST(KeptProcess, IsAnotherOneInAForkedProcess) {
  KeptProcess process(obey, shortLimits());
  const std::string own = process.ask("process").value();
  const auto others = runSandboxed([&] { return process.ask("process").value(); }, {});
  EXPECT_NE(std::get<std::string>(others), own);
  EXPECT_EQ(process.ask("process"), own);
}

}  // namespace kept_process_test
}  // namespace synthetic_dataset::base
