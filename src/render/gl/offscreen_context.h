#pragma once

#include <memory>
#include <string>

#include "render/gl/gl_functions.h"
#include "render/gl/offscreen_platform.h"

namespace synthetic_dataset::render {

/// An offscreen OpenGL 4.5 core context, drawn by the processor: no GPU, no display.
/// Made current in the thread that makes it, and used from that thread alone.
///
/// It comes from OSMesa where the program was built with it, otherwise from EGL; the variable
/// SYNTHETIC_DATASET_GL of the environment chooses (`osmesa`, `egl`).
class OffscreenContext {
 public:
  /// @throws Error when there is no such context, when another libGL has taken OSMesa's place, when
  ///   the system starts no threads for it, or when what is chosen is not built in
  OffscreenContext();

  [[nodiscard]] const GlFunctions& gl() const { return *gl_; }

  /// As OpenGL tells it: "4.5 (Core Profile) Mesa 22.3.6".
  [[nodiscard]] std::string version() const;

 private:
  void requireProcessor() const;
  void requireThreads();

  std::unique_ptr<OffscreenPlatform> platform_;
  std::unique_ptr<GlFunctions> gl_;
};

}  // namespace synthetic_dataset::render
