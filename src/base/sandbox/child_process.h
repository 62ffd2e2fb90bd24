#pragma once

#include <cstdint>

#include <sys/types.h>

#include "base/sandbox/sandboxed_process.h"

/// What the processes of SandboxedProcess and KeptProcess have in common.
namespace synthetic_dataset::base {

/// To be called in the child: no core file, no output, no signal handlers, and no more memory than
/// the limit allows.
void becomeSandboxed(const SandboxLimits& limits);

/// Whether becomeSandboxed() was called in this process.
[[nodiscard]] bool isSandboxed();

/// The processor time used by a sleeping process [clock ticks], or -1 if it does not sleep
/// (proc(5)).
[[nodiscard]] std::int64_t cpuTimeIfSleeping(pid_t process);

/// Kills a child and waits for its end.
void endChild(pid_t child) noexcept;

}  // namespace synthetic_dataset::base
