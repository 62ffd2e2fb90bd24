#pragma once

#include <sys/types.h>

#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "programs/setup_assistant/run/run_log.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// Starts and stops `generate`, one process at a time, and tracks its progress.
class RunControl {
 public:
  /// @param on_change  called in another thread when the state has changed
  explicit RunControl(std::function<void()> on_change);

  /// Asks a run in progress to stop, and waits for its end.
  ~RunControl();
  RunControl(const RunControl&) = delete;
  RunControl& operator=(const RunControl&) = delete;

  /// @param command  generate's file and its arguments
  /// @throws HttpError 409 when a run is in progress already
  void start(const std::vector<std::string>& command);

  /// Asks the run to stop after its current scene; if called again, at once. Does nothing without a
  /// run.
  void stop();

  [[nodiscard]] bool isRunning() const;

  /// state (idle, running, done, stopped or failed), stopping, scenes_done, scenes, rate,
  /// seconds_left, log, errors, exit_code.
  [[nodiscard]] Value::Map state() const;

 private:
  void work();
  void runOnce(const std::vector<std::string>& command);

  std::function<void()> on_change_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<std::vector<std::string>> wanted_;
  static constexpr pid_t kNone = -1;
  static constexpr pid_t kEnding = -2;  ///< the run prints nothing more
  pid_t child_ = kNone;                 ///< the process of the run in progress
  bool is_stopping_ = false;
  bool is_over_ = false;
  RunLog log_;
  std::optional<int> exit_code_;
  std::thread thread_;  ///< declared last: it uses the other members
};

}  // namespace synthetic_dataset::programs
