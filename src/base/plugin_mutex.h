#pragma once

#include <mutex>

namespace synthetic_dataset::base {

/// Must be held while plugins are looked up, loaded or unloaded, by us or by librosbag:
/// class_loader keeps global variables for that, so two threads that do so at the same time fail
/// now and then.
[[nodiscard]] inline std::mutex& pluginMutex() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace synthetic_dataset::base
