#include "output/files/run_lock.h"

#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <filesystem>
#include <memory>
#include <thread>
#include <vector>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace run_lock_test {

using testing::HasSubstr;

class RunLockTest : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
  std::string manifest_ = (folder_ / "manifest.sqlite").string();
};

TEST_F(RunLockTest, KeepsASecondRunAway) {
  const RunLock lock(manifest_);
  try {
    const RunLock second(manifest_);
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("another run is writing the dataset of '" + manifest_));
  }
}

TEST_F(RunLockTest, LeavesNothingBehind) {
  { const RunLock lock(manifest_); }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  const RunLock again(manifest_);
}

TEST_F(RunLockTest, OfAKilledProcessHoldsNobodyUp) {
  int ready[2];
  ASSERT_EQ(::pipe(ready), 0);
  const pid_t child = ::fork();
  if (child == 0) {
    const RunLock lock(manifest_);
    (void)!::write(ready[1], "x", 1);
    ::pause();
  }
  char byte = 0;
  ASSERT_EQ(::read(ready[0], &byte, 1), 1);
  EXPECT_THROW(RunLock{manifest_}, Error);
  ::kill(child, SIGKILL);
  ::waitpid(child, nullptr, 0);
  ::close(ready[0]);
  ::close(ready[1]);
  EXPECT_NO_THROW(RunLock{manifest_});
}

TEST_F(RunLockTest, IsNeverHeldByTwoThatRaceForIt) {
  std::atomic<int> holders{0};
  std::atomic<int> most{0};
  std::atomic<int> taken{0};
  std::vector<std::thread> threads;
  for (int i = 0; i < 4; ++i) {
    threads.emplace_back([&] {
      for (int round = 0; round < 200; ++round) {
        try {
          const RunLock lock(manifest_);
          const int now = ++holders;
          if (now > most) most = now;
          ++taken;
          --holders;
        } catch (const Error&) {
          // Somebody else has it.
        }
      }
    });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(most, 1);
  EXPECT_GT(taken, 0);
}

}  // namespace run_lock_test
}  // namespace synthetic_dataset::output
