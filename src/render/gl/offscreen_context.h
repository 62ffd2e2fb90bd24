#pragma once

#include <memory>
#include <string>

#include "render/gl/gl_functions.h"
#include "render/gl/offscreen_platform.h"

namespace synthetic_dataset::render {

/// An offscreen OpenGL 4.5 core context, rendered by the CPU: no GPU, no display. Current in the
/// thread that constructs it, and used from that thread only.
///
/// It comes from OSMesa if the program was built with it, otherwise from EGL; the environment
/// variable SYNTHETIC_DATASET_GL overrides this (`osmesa`, `egl`).
class OffscreenContext {
 public:
  /// @throws Error when there is no such context, when another libGL has taken OSMesa's place, when
  ///   the system cannot start its threads, or when the chosen platform is not built in
  OffscreenContext();

  [[nodiscard]] const GlFunctions& gl() const { return *gl_; }

  /// As reported by OpenGL: "4.5 (Core Profile) Mesa 22.3.6".
  [[nodiscard]] std::string version() const;

 private:
  void requireProcessor() const;
  void requireThreads();

  std::unique_ptr<OffscreenPlatform> platform_;
  std::unique_ptr<GlFunctions> gl_;
};

}  // namespace synthetic_dataset::render
