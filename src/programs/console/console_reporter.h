#pragma once

#include <functional>
#include <memory>
#include <mutex>
#include <set>
#include <string>

#include "output/progress.h"
#include "programs/console/ticker.h"
#include "run/reporter.h"

namespace synthetic_dataset::programs {

/// Reports what a slow start is doing: after two seconds, and then at most every two seconds, the
/// current stage, each stage once. Its functions may be called from any thread.
class StartReport {
 public:
  /// A clock that never goes back [s].
  using Clock = std::function<double()>;
  using Sink = std::function<void(const std::string& message)>;

  /// The clock is read here for the first time.
  StartReport(Clock clock, Sink sink);

  /// A stage begins, and the one before has ended.
  void begin(const std::string& stage);

  /// Reports the stage if it is time for that; to be called several times a second.
  void look();

 private:
  std::mutex mutex_;
  Clock clock_;
  Sink sink_;
  double start_;
  double next_;  ///< the earliest time of the next report
  std::string stage_;
  std::set<std::string> reported_;
};

/// Reports to rosconsole, which needs no master, and shows progress on a terminal if there is one.
/// Signals stop the run (see stop_signals.h).
class ConsoleReporter : public run::Reporter {
 public:
  void info(const std::string& message) override;
  void warning(const std::string& message) override;
  void stage(const std::string& what) override;
  void progress(std::int64_t scenes_done, std::int64_t scenes) override;
  [[nodiscard]] bool stopRequested() const override;

  /// Reports an error that ends the run.
  static void fatal(const std::string& message);

 private:
  void start(std::int64_t scenes);

  std::unique_ptr<output::Progress> progress_;
  bool is_started_ = false;  ///< whether a scene has been made
  std::unique_ptr<StartReport> start_report_;
  std::unique_ptr<Ticker> ticker_;  ///< declared last: it uses `start_report_`
};

}  // namespace synthetic_dataset::programs
