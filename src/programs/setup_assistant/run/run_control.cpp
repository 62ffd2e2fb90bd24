#include "programs/setup_assistant/run/run_control.h"

#include <csignal>
#include <utility>

#include "programs/setup_assistant/run/child_program.h"
#include "programs/setup_assistant/web/http_message.h"

namespace synthetic_dataset::programs {
namespace {

bool wasAskedToStop(int exit_code) {
  constexpr int kSignalled = 128;
  const int signal = exit_code - kSignalled;
  return signal == SIGINT || signal == SIGTERM || signal == SIGHUP;
}

}  // namespace

RunControl::RunControl(std::function<void()> on_change)
    : on_change_(std::move(on_change)), thread_([this] { work(); }) {}

RunControl::~RunControl() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    is_over_ = true;
    if (child_ > 0 && !is_stopping_) ::kill(child_, SIGINT);
  }
  changed_.notify_all();
  thread_.join();
}

void RunControl::start(const std::vector<std::string>& command) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (wanted_ || child_ != kNone)
      throw HttpError(409, "a run is already going on; stop it first");
    wanted_ = command;
    log_ = {};
    exit_code_.reset();
    is_stopping_ = false;
  }
  changed_.notify_all();
}

void RunControl::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (child_ > 0) {
    ::kill(child_, SIGINT);
    is_stopping_ = true;
  } else {
    wanted_.reset();
  }
}

bool RunControl::isRunning() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return wanted_ || child_ != kNone;
}

Value::Map RunControl::state() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::string state = "idle";
  if (wanted_ || child_ != kNone) {
    state = "running";
  } else if (exit_code_) {
    state = *exit_code_ == 0 ? "done" : wasAskedToStop(*exit_code_) ? "stopped" : "failed";
  }
  return {{"state", Value(state)},
          {"stopping", Value(state == "running" && is_stopping_)},
          {"scenes_done", Value(log_.scenes_done)},
          {"scenes", Value(log_.scenes)},
          {"rate", Value(log_.rate)},
          {"seconds_left", Value(log_.time_left)},
          {"log", Value(Value::List(log_.lines.begin(), log_.lines.end()))},
          {"errors", Value(Value::List(log_.errors.begin(), log_.errors.end()))},
          {"exit_code", exit_code_ ? Value(*exit_code_) : Value()}};
}

/// Runs in the only thread that starts child programs: they stop when it ends.
void RunControl::work() {
  for (;;) {
    std::vector<std::string> command;
    {
      std::unique_lock<std::mutex> lock(mutex_);
      changed_.wait(lock, [this] { return is_over_ || wanted_; });
      if (is_over_) return;
      command = *wanted_;
    }
    try {
      runOnce(command);
    } catch (const std::exception& error) {
      const std::lock_guard<std::mutex> lock(mutex_);
      log_.errors.emplace_back(error.what());
      exit_code_ = 1;
      wanted_.reset();
    }
    on_change_();
  }
}

void RunControl::runOnce(const std::vector<std::string>& command) {
  ChildProgram child(command);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    child_ = child.id();
    // stop() or the destructor may have been called before there was a process.
    if (is_over_ || !wanted_) ::kill(child_, SIGINT);
    is_stopping_ = !wanted_;
    wanted_.reset();
  }
  on_change_();
  child.read([this](const std::string& line) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      log_.take(line);
    }
    on_change_();
  });
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    child_ = kEnding;  // its id may be reused from now on
  }
  const int code = child.wait();
  const std::lock_guard<std::mutex> lock(mutex_);
  child_ = kNone;
  exit_code_ = code;
}

}  // namespace synthetic_dataset::programs
