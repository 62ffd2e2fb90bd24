#include "programs/setup_assistant/run/run_control.h"

#include <condition_variable>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {
namespace {

/// A shell in the place of `generate`.
std::vector<std::string> shell(const std::string& script) { return {"/bin/sh", "-c", script}; }

/// A run that tests wait for by its states, not by time.
class Watched {
 public:
  void waitFor(const std::function<bool(const Value::Map& state)>& is_there) {
    std::unique_lock<std::mutex> lock(mutex_);
    changed_.wait(lock, [&] { return is_there(run.state()); });
  }

  void waitForEnd() {
    waitFor([](const Value::Map& state) {
      return state.at("state") != Value("running") && state.at("state") != Value("idle");
    });
  }

  [[nodiscard]] Value member(const std::string& name) const { return run.state().at(name); }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;

 public:
  RunControl run{[this] {
    const std::lock_guard<std::mutex> lock(mutex_);
    changed_.notify_all();
  }};
};

TEST(RunControl, KnowsHowItsProgramEnded) {
  Watched watched;
  EXPECT_EQ(Value("idle"), watched.member("state"));
  watched.run.start(
      shell(R"(echo '{"scenes_done": 2, "scenes": 2, "rate": 1.0, "time_left": 0.0}')"));
  watched.waitForEnd();
  EXPECT_EQ(Value("done"), watched.member("state"));
  EXPECT_EQ(Value(2), watched.member("scenes_done"));
  watched.run.start(shell("echo wrong >&2; exit 1"));
  watched.waitForEnd();
  EXPECT_EQ(Value("failed"), watched.member("state"));
  EXPECT_EQ(Value(1), watched.member("exit_code"));
  EXPECT_EQ(Value(Value::List{Value("wrong")}), watched.member("log"));
}

TEST(RunControl, StopsItsProgramBySigint) {
  Watched watched;
  watched.run.start(shell("trap 'exit 130' INT; echo ready; while :; do sleep 0.01; done"));
  watched.waitFor(
      [](const Value::Map& state) { return !state.at("log").as<Value::List>()->empty(); });
  EXPECT_EQ(Value("running"), watched.member("state"));
  watched.run.stop();
  watched.waitForEnd();
  EXPECT_EQ(Value("stopped"), watched.member("state"));
  EXPECT_EQ(Value(130), watched.member("exit_code"));
}

TEST(RunControl, HasOneRunAtATime) {
  Watched watched;
  watched.run.start(shell("trap 'exit 130' INT; while :; do sleep 0.01; done"));
  EXPECT_THROW(watched.run.start(shell("true")), HttpError);
}  // the end of `watched` stops the run

TEST(RunControl, SaysWhenThereIsNoSuchProgram) {
  Watched watched;
  watched.run.start({"/no/such/program"});
  watched.waitForEnd();
  EXPECT_EQ(Value("failed"), watched.member("state"));
  EXPECT_EQ(Value(127), watched.member("exit_code"));
}

}  // namespace
}  // namespace synthetic_dataset::programs
