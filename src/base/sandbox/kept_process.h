#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "base/sandbox/sandboxed_process.h"

namespace synthetic_dataset::base {

/// A process that does one kind of work again and again, as a new process for each piece of work
/// costs more than a small piece itself: the kernel copies the page tables of a large process, and
/// then each page that changes.
///
/// The process is started with the first piece, restarted after one that failed, and ends with this
/// object. For pieces that fail, or whose process breaks down, runSandboxed() tells what is wrong.
class KeptProcess {
 public:
  /// @param work  turns a request into its answer; may throw
  /// @param limits  of each piece; the memory limit is for all pieces together
  KeptProcess(std::function<std::string(std::string_view)> work, const SandboxLimits& limits);
  ~KeptProcess();
  KeptProcess(const KeptProcess&) = delete;
  KeptProcess& operator=(const KeptProcess&) = delete;

  /// Has a piece of work done; may be called from any thread, does one piece at a time.
  /// @return the answer, or nullopt if it failed
  [[nodiscard]] std::optional<std::string> ask(std::string_view request);

 private:
  [[nodiscard]] bool isThere() const;
  void launch();
  void stop() noexcept;
  [[nodiscard]] std::optional<std::string> answerTo(std::string_view request) const;

  std::function<std::string(std::string_view)> work_;
  SandboxLimits limits_;
  std::mutex mutex_;
  int owner_ = -1;   ///< the process that has started it, not a fork of that
  int child_ = -1;   ///< its process, or -1 for none
  int socket_ = -1;  ///< to it, or -1 for none
};

}  // namespace synthetic_dataset::base
