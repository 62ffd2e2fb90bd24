#pragma once

#include <cstdint>

#include <sys/types.h>

#include "base/sandbox/sandboxed_process.h"

/// What processes of SandboxedProcess's and KeptProcess's share.
namespace synthetic_dataset::base {

/// In the child: no core file, no output, no handlers, and no more memory than the limit has it.
void becomeSandboxed(const SandboxLimits& limits);

/// Whether this is a process that becomeSandboxed() has made.
[[nodiscard]] bool isSandboxed();

/// The processor time of a process that waits [clock ticks], or -1 where it does not (proc(5)).
[[nodiscard]] std::int64_t timeOfWaiting(pid_t process);

/// Ends a child, and waits for that.
void endChild(pid_t child) noexcept;

}  // namespace synthetic_dataset::base
