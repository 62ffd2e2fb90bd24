#pragma once

#include <array>
#include <memory>
#include <string>

#include "render/gl/gl_functions.h"

namespace synthetic_dataset::render {

/// An offscreen OpenGL 4.5 core context, drawn by the processor: no GPU, no display.
/// Made current in the thread that makes it, and used from that thread alone.
class OsmesaContext {
 public:
  /// @throws Error when OSMesa gives no such context, when another libGL has taken its place, or
  ///   when the system starts no threads for it
  OsmesaContext();
  ~OsmesaContext();
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  [[nodiscard]] const GlFunctions& gl() const { return *gl_; }

  /// As OpenGL tells it: "4.5 (Core Profile) Mesa 22.3.6".
  [[nodiscard]] std::string version() const;

 private:
  struct Destroy {
    void operator()(void* context) const;
  };

  void requireThreads();

  /// OSMesa wants a picture of its own to be current with; everything is drawn elsewhere.
  std::array<unsigned char, 4> unused_picture_{};
  std::unique_ptr<void, Destroy> context_;
  std::unique_ptr<GlFunctions> gl_;
};

}  // namespace synthetic_dataset::render
