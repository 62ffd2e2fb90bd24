#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace synthetic_dataset::base {

/// One of many pieces of work.
struct SandboxedWork {
  std::function<std::string()> work;  ///< may throw Error
  std::chrono::seconds processor_time{0};
};

/// Does many pieces of work, as many in parallel as the machine has cores. A process per piece
/// would cost more than a small piece itself; here several pieces share a process, each with its
/// own time limit.
/// @param memory  [byte] of each process, beyond what is in use already
/// @return what each piece returns; nullopt for those that fail or whose process breaks down:
///     runSandboxed tells what is wrong with them
[[nodiscard]] std::vector<std::optional<std::string>> runAllSandboxed(
    const std::vector<SandboxedWork>& pieces, std::uint64_t memory);

}  // namespace synthetic_dataset::base
