#pragma once

#include <functional>

#include "run/reporter.h"

namespace synthetic_dataset {

/// A piece of work: told which one it is, from 0, and whom to tell what happens; whether it came to
/// its end, and was not stopped. May throw.
using PieceOfWork = std::function<bool(int index, Reporter& reporter)>;

/// Does pieces of work at a time, each in a process of its own. To be called before there are other
/// threads.
///
/// `reporter` is told what the first process tells, of all others each warning that is new, and the
/// scenes of all together. When it wants an end, so do those of the processes; when this process
/// dies, they stop, too.
/// @return whether all came to their end
/// @throws ErrorList with what went wrong in any of them, each error once; the others are stopped
[[nodiscard]] bool doInProcesses(int count, const PieceOfWork& work, Reporter& reporter);

}  // namespace synthetic_dataset
