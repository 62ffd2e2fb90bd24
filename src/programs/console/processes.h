#pragma once

#include <functional>

#include "run/reporter.h"

namespace synthetic_dataset::programs {

/// A piece of work. May throw.
/// @param index  of the piece, from 0
/// @param reporter  reports to the process that started it
/// @return false when it was stopped before its end
using PieceOfWork = std::function<bool(int index, run::Reporter& reporter)>;

/// Does several pieces of work at a time, each in a process of its own. Call it before there are
/// other threads.
///
/// `reporter` receives everything that the first process reports, each new warning of the others,
/// and the scenes of all together. When it requests a stop, so do the reporters of the processes;
/// when this process dies, they stop, too.
/// @return whether all finished
/// @throws ErrorList with what went wrong in any of them, each error once; the others are stopped
[[nodiscard]] bool doInProcesses(int count, const PieceOfWork& work, run::Reporter& reporter);

/// Does pieces of work one after the other, as doInProcesses does a single one. All processes are
/// forked at the beginning, before one piece can make this process start threads (such as those of
/// ROS topics) that would get in the way of forking another. Ends with the first piece that is
/// stopped or fails.
[[nodiscard]] bool doInTurn(int count, const PieceOfWork& work, run::Reporter& reporter);

}  // namespace synthetic_dataset::programs
