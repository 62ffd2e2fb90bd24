#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace synthetic_dataset::world {

struct TrialLimits {
  std::chrono::seconds processor_time{120};
  std::uint64_t memory = std::uint64_t{4} << 30U;  ///< [byte], beyond what is in use already

  /// A process that sends nothing and waits without using the processor for one to two times this
  /// long is started anew, three times at most: where another thread held a lock (of a heap, of a
  /// library) when the process was forked, nobody will ever unlock it there.
  std::chrono::milliseconds idle{1000};
};

/// How a piece of work broke down: "crashes (Segmentation fault)".
struct Breakdown {
  std::string how;
};

/// A piece of work in a process of its own, so that a library that crashes or never ends takes
/// nothing else with it. What the work changes or prints is lost; what it returns is handed over.
/// Where no process is to be had the work is done in this one, when it is finished.
///
/// Several may work at a time. The work may be started more than once (see TrialLimits::idle). It
/// ends with the thread that started it, at the latest.
class TrialProcess {
 public:
  /// Starts it.
  /// @param work  may throw Error
  TrialProcess(std::function<std::string()> work, const TrialLimits& limits);

  /// Ends it at once, if it has not been finished.
  ~TrialProcess();
  TrialProcess(TrialProcess&& other) noexcept;
  TrialProcess(const TrialProcess&) = delete;
  TrialProcess& operator=(const TrialProcess&) = delete;
  TrialProcess& operator=(TrialProcess&&) = delete;

  /// Waits for its end; to be called once, in any thread.
  /// @return the work's result, or how it broke down
  /// @throws Error as the work does
  [[nodiscard]] std::variant<std::string, Breakdown> finish();

 private:
  void start();
  void stop() noexcept;
  std::optional<std::string> receive();  ///< its answer, or nothing if there is no process

  std::function<std::string()> work_;
  TrialLimits limits_;
  int child_ = -1;    ///< its process, or -1 for none
  int reading_ = -1;  ///< the end of the pipe that brings its answer, or -1 for none
};

/// In a process of TrialProcess's: gives what is done from now on its own time, within the whole
/// work's. Elsewhere it does nothing.
void limitTrialTime(std::chrono::seconds processor_time);

/// Starts and finishes a piece of work.
[[nodiscard]] std::variant<std::string, Breakdown> tryWork(const std::function<std::string()>& work,
                                                           const TrialLimits& limits);

}  // namespace synthetic_dataset::world
