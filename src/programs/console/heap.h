#pragma once

namespace synthetic_dataset::programs::heap {

/// Prepares the C library's heap for images that come and go, each of some megabytes. Call it
/// before the process has threads. Where the system does not support it, nothing changes.
void prepare();

}  // namespace synthetic_dataset::programs::heap
