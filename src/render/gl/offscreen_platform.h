#pragma once

#include <memory>

namespace synthetic_dataset::render {

/// A way to OpenGL 4.5 core on the processor, current in the thread that opened it until it ends.
/// Whichever it is, Mesa's llvmpipe draws the same pixels.
class OffscreenPlatform {
 public:
  virtual ~OffscreenPlatform() = default;
  OffscreenPlatform() = default;
  OffscreenPlatform(const OffscreenPlatform&) = delete;
  OffscreenPlatform& operator=(const OffscreenPlatform&) = delete;

  /// The address of a function of OpenGL.
  using EntryPoint = void* (*)(const char* name);
  [[nodiscard]] virtual EntryPoint entryPoint() const = 0;
};

/// Each is there where the program was built with its library.
/// @throws Error when it gives no such context
[[nodiscard]] std::unique_ptr<OffscreenPlatform> openOsmesa();
[[nodiscard]] std::unique_ptr<OffscreenPlatform> openEgl();

}  // namespace synthetic_dataset::render
