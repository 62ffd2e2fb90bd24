#pragma once

namespace synthetic_dataset::programs::heap {

/// Prepares the C library's heap for short-lived images of some megabytes each. Call it before the
/// process has threads. If the system does not support it, nothing changes.
void prepare();

}  // namespace synthetic_dataset::programs::heap
