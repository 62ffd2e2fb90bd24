#pragma once

namespace synthetic_dataset::heap {

/// Makes the C library's heap fit for pictures that come and go, each of some megabytes. To be
/// called before the process has threads. Where the system does not go along, all is as it was.
void prepare();

}  // namespace synthetic_dataset::heap
