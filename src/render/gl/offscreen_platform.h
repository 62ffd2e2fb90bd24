#pragma once

#include <memory>

namespace synthetic_dataset::render {

/// Provides an OpenGL 4.5 core context on the CPU, current in the thread that opened it until it is
/// destroyed. With every platform, Mesa's llvmpipe draws the same pixels.
class OffscreenPlatform {
 public:
  virtual ~OffscreenPlatform() = default;
  OffscreenPlatform() = default;
  OffscreenPlatform(const OffscreenPlatform&) = delete;
  OffscreenPlatform& operator=(const OffscreenPlatform&) = delete;

  /// Returns the address of an OpenGL function.
  using EntryPoint = void* (*)(const char* name);
  [[nodiscard]] virtual EntryPoint entryPoint() const = 0;
};

/// Each is available only if the program was built with its library.
/// @throws Error when the platform cannot provide such a context
[[nodiscard]] std::unique_ptr<OffscreenPlatform> openOsmesa();
[[nodiscard]] std::unique_ptr<OffscreenPlatform> openEgl();

}  // namespace synthetic_dataset::render
