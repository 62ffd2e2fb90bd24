#pragma once

#include <string>
#include <variant>
#include <vector>

#include "base/sandbox/sandboxed_process.h"

namespace synthetic_dataset::base {

/// What a program has printed, and how it ended.
struct ProgramResult {
  int exit_code = 0;   ///< 127 if there is no such program, as in shells
  std::string output;  ///< its standard output
  std::string errors;  ///< its standard error
};

/// Runs a program in a sandboxed process, which limits its time and its memory, waits for its end,
/// and returns what it has printed. It reads no input.
/// @param command  the program's name, looked up in PATH unless it has a slash, and its arguments
[[nodiscard]] std::variant<ProgramResult, Crash> runSandboxedProgram(
    const std::vector<std::string>& command, SandboxLimits limits);

}  // namespace synthetic_dataset::base
