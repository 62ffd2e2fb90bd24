#pragma once

#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "base/sandbox/sandboxed_process.h"

namespace synthetic_dataset::base {

/// A process that does one kind of work again and again, as a process for each piece costs more
/// than a small piece does: the kernel copies the tables of a large process's memory, and then each
/// page that changes.
///
/// It is started with the first piece, anew after one that failed, and ends with
/// this. Of pieces that fail, or whose process breaks down, runSandboxed() says what is wrong.
class KeptProcess {
 public:
  /// @param work  of a request its answer; may throw
  /// @param limits  of each piece; the memory is that of all of them
  KeptProcess(std::function<std::string(std::string_view)> work, const SandboxLimits& limits);
  ~KeptProcess();
  KeptProcess(const KeptProcess&) = delete;
  KeptProcess& operator=(const KeptProcess&) = delete;

  /// Has a piece of work done; one at a time, in any thread.
  /// @return the answer, or nothing where it failed
  [[nodiscard]] std::optional<std::string> ask(std::string_view request);

 private:
  [[nodiscard]] bool isThere() const;
  void launch();
  void stop() noexcept;
  [[nodiscard]] std::optional<std::string> answerTo(std::string_view request) const;

  std::function<std::string(std::string_view)> work_;
  SandboxLimits limits_;
  std::mutex mutex_;
  int owner_ = -1;   ///< which process has started it: not what was forked from that
  int child_ = -1;   ///< its process, or -1 for none
  int socket_ = -1;  ///< to it, or -1 for none
};

}  // namespace synthetic_dataset::base
