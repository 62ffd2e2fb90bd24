#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <variant>

namespace synthetic_dataset::base {

struct SandboxLimits {
  std::chrono::seconds processor_time{120};
  std::uint64_t memory = std::uint64_t{4} << 30U;  ///< [byte], beyond what is in use already

  /// A process that sends nothing and waits without using the processor for one to two times this
  /// long is restarted, at most three times: if another thread held a lock (of the heap or a
  /// library) when the process was forked, nothing will ever unlock it in the child.
  std::chrono::milliseconds idle{1000};
};

/// How a piece of work broke down: "crashes (Segmentation fault)".
struct Crash {
  std::string how;
};

/// A piece of work in a process of its own, so that a library that crashes or never returns does
/// not affect anything else. What the work changes or prints is lost; what it returns is passed
/// back. If no process can be started, the work is done in this one, by finish().
///
/// Several may run at a time. The work may be started more than once (see SandboxLimits::idle). It
/// ends at the latest with the thread that started it.
class SandboxedProcess {
 public:
  /// Starts the work.
  /// @param work  may throw Error
  SandboxedProcess(std::function<std::string()> work, const SandboxLimits& limits);

  /// Ends the work at once unless finish() was called.
  ~SandboxedProcess();
  SandboxedProcess(SandboxedProcess&& other) noexcept;
  SandboxedProcess(const SandboxedProcess&) = delete;
  SandboxedProcess& operator=(const SandboxedProcess&) = delete;
  SandboxedProcess& operator=(SandboxedProcess&&) = delete;

  /// Waits for the work to end; to be called once, in any thread.
  /// @return the work's result, or how it broke down
  /// @throws Error as the work does
  [[nodiscard]] std::variant<std::string, Crash> finish();

 private:
  void start();
  void stop() noexcept;
  std::optional<std::string> receive();  ///< its answer, or nullopt if there is no process

  std::function<std::string()> work_;
  SandboxLimits limits_;
  int child_ = -1;    ///< its process, or -1 for none
  int reading_ = -1;  ///< the end of the pipe that brings its answer, or -1 for none
};

/// In a sandboxed process: gives the work from now on a processor time limit of its own, within
/// that of the whole process. Does nothing in other processes.
void limitSandboxTime(std::chrono::seconds processor_time);

/// Starts and finishes a piece of work.
[[nodiscard]] std::variant<std::string, Crash> runSandboxed(
    const std::function<std::string()>& work, const SandboxLimits& limits);

}  // namespace synthetic_dataset::base
