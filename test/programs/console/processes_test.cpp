#include "programs/console/processes.h"

#include <csignal>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace processes_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

/// Records what is reported, and requests a stop after a number of scenes.
class NotingReporter : public run::Reporter {
 public:
  explicit NotingReporter(std::int64_t last_scene = 1000) : last_scene_(last_scene) {}

  void info(const std::string& message) override { infos.push_back(message); }
  void warning(const std::string& message) override { warnings.push_back(message); }
  void progress(std::int64_t done, std::int64_t all) override { scenes.emplace_back(done, all); }
  [[nodiscard]] bool stopRequested() const override {
    return !scenes.empty() && scenes.back().first >= last_scene_;
  }

  std::vector<std::string> infos;
  std::vector<std::string> warnings;
  std::vector<std::pair<std::int64_t, std::int64_t>> scenes;

 private:
  std::int64_t last_scene_;
};

/// Makes scenes until a stop is requested, or so many that something must be wrong.
bool workUntilStopped(run::Reporter& reporter) {
  constexpr int kScenes = 60000;
  reporter.progress(0, kScenes);
  for (int i = 0; i < kScenes; ++i) {
    if (reporter.stopRequested()) return false;
    usleep(1000);
  }
  return true;
}

std::vector<std::string> errorsOf(int count, const PieceOfWork& work) {
  NotingReporter reporter;
  return test::messagesOf([&] { (void)doInProcesses(count, work, reporter); });
}

class Processes : public testing::Test {
 protected:
  void TearDown() override { EXPECT_EQ(waitpid(-1, nullptr, WNOHANG), -1) << "a process is left"; }
};

TEST_F(Processes, EachDoItsPieceOfTheWork) {
  NotingReporter reporter;
  const pid_t here = getpid();
  const auto work = [&](int index, run::Reporter& told) {
    if (getpid() != here) told.warning("piece " + std::to_string(index));
    return true;
  };
  EXPECT_TRUE(doInProcesses(3, work, reporter));
  EXPECT_THAT(reporter.warnings, UnorderedElementsAre("piece 0", "piece 1", "piece 2"));
}

TEST_F(Processes, SayTheSameOnce) {
  NotingReporter reporter;
  const std::string long_text(std::size_t{3} << 20U, 'x');
  const auto work = [&](int index, run::Reporter& told) {
    told.info("hello of " + std::to_string(index));
    told.warning(long_text);
    return true;
  };
  EXPECT_TRUE(doInProcesses(3, work, reporter));
  EXPECT_THAT(reporter.infos, ElementsAre("hello of 0"));
  EXPECT_TRUE(reporter.warnings == std::vector<std::string>{long_text});
}

TEST_F(Processes, CountTheirScenesTogether) {
  NotingReporter reporter;
  const auto work = [](int index, run::Reporter& told) {
    const std::int64_t count = 2 + index;
    if (index == 2) return true;  // nothing to do
    for (std::int64_t done = 0; done <= count; ++done) told.progress(done, count);
    return true;
  };
  EXPECT_TRUE(doInProcesses(3, work, reporter));
  std::vector<std::pair<std::int64_t, std::int64_t>> expected;
  for (std::int64_t done = 0; done <= 5; ++done) expected.emplace_back(done, 5);
  EXPECT_EQ(reporter.scenes, expected);
}

TEST_F(Processes, StopWhenTheyAreToldTo) {
  NotingReporter reporter(0);
  const auto work = [](int, run::Reporter& told) { return workUntilStopped(told); };
  EXPECT_FALSE(doInProcesses(2, work, reporter));
}

TEST_F(Processes, AreAllForkedBeforeTheFirstHasItsTurn) {
  std::string value = "before";  // later changes by this process do not reach them
  class Changing : public NotingReporter {
   public:
    explicit Changing(std::string& value) : value_(value) {}
    void info(const std::string& message) override {
      NotingReporter::info(message);
      value_ = "after";
    }

   private:
    std::string& value_;
  } changing(value);
  const auto work = [&](int index, run::Reporter& told) {
    told.info(std::to_string(index) + " " + value);
    return index < 2;
  };
  EXPECT_FALSE(doInTurn(4, work, changing));
  EXPECT_THAT(changing.infos, ElementsAre("0 before", "1 before", "2 before"));
}

TEST_F(Processes, TellEachErrorOnceAndStopTheOthers) {
  const auto work = [](int index, run::Reporter& told) -> bool {
    if (index == 2) return workUntilStopped(told);
    throw ErrorList({"no bag", "no disk"});
  };
  EXPECT_THAT(errorsOf(3, work), ElementsAre("no bag", "no disk"));
}

TEST_F(Processes, TellWhateverTheyThrow) {
  const auto work = [](int, run::Reporter&) -> bool { throw std::runtime_error("out of memory"); };
  EXPECT_THAT(errorsOf(2, work), ElementsAre("out of memory"));
}

TEST_F(Processes, AreMissedWhenTheyDie) {
  const auto work = [](int index, run::Reporter& told) {
    if (index == 0) return workUntilStopped(told);
    raise(SIGKILL);
    return true;
  };
  EXPECT_THAT(errorsOf(2, work), ElementsAre(HasSubstr("process 2 died (Killed)")));
}

TEST_F(Processes, LeaveTheirParentsSignalsAlone) {
  NotingReporter reporter;
  const auto work = [](int, run::Reporter&) { return true; };
  EXPECT_TRUE(doInProcesses(1, work, reporter));
  struct sigaction action {};
  sigaction(SIGTERM, nullptr, &action);
  EXPECT_EQ(action.sa_handler, SIG_DFL);
}

}  // namespace processes_test
}  // namespace synthetic_dataset::programs
