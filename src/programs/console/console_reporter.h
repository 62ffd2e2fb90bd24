#pragma once

#include <memory>
#include <string>

#include "output/progress.h"
#include "programs/console/start_report.h"
#include "programs/console/ticker.h"
#include "run/reporter.h"

namespace synthetic_dataset::programs {

/// Reports to rosconsole, which needs no master, and shows progress on a terminal if there is one.
/// Signals stop the run (see stop_signals.h).
class ConsoleReporter : public run::Reporter {
 public:
  void info(const std::string& message) override;
  void warning(const std::string& message) override;
  void stage(const std::string& what) override;
  void progress(std::int64_t scenes_done, std::int64_t scenes) override;
  [[nodiscard]] bool stopRequested() const override;

  /// An error that ends the run.
  static void fatal(const std::string& message);

 private:
  void start(std::int64_t scenes);

  std::unique_ptr<output::Progress> progress_;
  bool is_started_ = false;  ///< a scene is there
  std::unique_ptr<StartReport> start_report_;
  std::unique_ptr<Ticker> ticker_;  ///< looks at `start_report_`, and ends before it
};

}  // namespace synthetic_dataset::programs
