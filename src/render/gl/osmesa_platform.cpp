#include <array>
#include <memory>
#include <type_traits>

#include <GL/osmesa.h>

#include "render/gl/offscreen_platform.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

constexpr std::array<int, 11> kAttributes = {OSMESA_FORMAT,
                                             OSMESA_RGBA,
                                             OSMESA_PROFILE,
                                             OSMESA_CORE_PROFILE,
                                             OSMESA_CONTEXT_MAJOR_VERSION,
                                             4,
                                             OSMESA_CONTEXT_MINOR_VERSION,
                                             5,
                                             OSMESA_DEPTH_BITS,
                                             0,
                                             0};

void* entryPointOf(const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

/// Mesa's own library for rendering into memory; Mesa 25.0 is the last version that has it.
class OsmesaPlatform : public OffscreenPlatform {
 public:
  OsmesaPlatform() : context_(OSMesaCreateContextAttribs(kAttributes.data(), nullptr)) {
    if (!context_) {
      throw Error(
          "OSMesa cannot make an OpenGL 4.5 core context; it needs Mesa's llvmpipe driver (package "
          "libosmesa6, version 20 or newer)");
    }
    if (OSMesaMakeCurrent(context_.get(), unused_picture_.data(), GL_UNSIGNED_BYTE, 1, 1) !=
        GL_TRUE) {
      throw Error("OSMesa cannot make its context current");
    }
  }

  ~OsmesaPlatform() override { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }
  OsmesaPlatform(const OsmesaPlatform&) = delete;
  OsmesaPlatform& operator=(const OsmesaPlatform&) = delete;

  [[nodiscard]] EntryPoint entryPoint() const override { return entryPointOf; }

 private:
  struct Destroy {
    void operator()(OSMesaContext context) const { OSMesaDestroyContext(context); }
  };

  /// OSMesa needs a picture to make its context current; everything is drawn elsewhere.
  std::array<unsigned char, 4> unused_picture_{};
  std::unique_ptr<std::remove_pointer_t<OSMesaContext>, Destroy> context_;
};

}  // namespace

std::unique_ptr<OffscreenPlatform> openOsmesa() { return std::make_unique<OsmesaPlatform>(); }

}  // namespace synthetic_dataset::render
