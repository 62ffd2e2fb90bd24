#pragma once

#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace synthetic_dataset::programs {

/// Says what a start that takes long is doing: after two seconds, and then not more often than
/// that, the stage that is going on, each once. Its functions may be called from any thread.
class StartReport {
 public:
  /// A clock that never goes back [s].
  using Clock = std::function<double()>;
  using Sink = std::function<void(const std::string& message)>;

  /// The clock is read here for the first time.
  StartReport(Clock clock, Sink sink);

  /// A stage begins, and the one before has ended.
  void begin(const std::string& stage);

  /// Reports the stage if it is time to; to be called several times a second.
  void look();

 private:
  std::mutex mutex_;
  Clock clock_;
  Sink sink_;
  double start_;
  double next_;  ///< not before this is something reported
  std::string stage_;
  std::set<std::string> reported_;
};

}  // namespace synthetic_dataset::programs
