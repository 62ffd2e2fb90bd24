#include "render/gl/osmesa_context.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <thread>

#include <GL/osmesa.h>

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

/// Mesa 20 (Debian 11) approximates which levels of a texture a pixel is mixed from, and how,
/// unless this forbids it. Mesa 22 does not, and knows none of the two words.
OSMesaContext exactContext() {
  setenv("GALLIVM_PERF", "no_brilinear,no_rho_approx", 0);  // keeps the user's
  return OSMesaCreateContextAttribs(kAttributes.data(), nullptr);
}

void* entryPoint(const char* name) { return reinterpret_cast<void*>(OSMesaGetProcAddress(name)); }

}  // namespace

void OsmesaContext::Destroy::operator()(void* context) const {
  OSMesaDestroyContext(static_cast<OSMesaContext>(context));
}

OsmesaContext::OsmesaContext() : context_(exactContext()) {
  if (!context_) {
    throw Error(
        "OSMesa cannot make an OpenGL 4.5 core context; it needs Mesa's llvmpipe driver (package "
        "libosmesa6, version 20 or newer)");
  }
  if (OSMesaMakeCurrent(static_cast<OSMesaContext>(context_.get()), unused_picture_.data(),
                        GL_UNSIGNED_BYTE, 1, 1) != GL_TRUE) {
    throw Error("OSMesa cannot make its context current");
  }
  gl_ = std::make_unique<GlFunctions>(entryPoint);
  if (gl_->GetString(GL_VERSION) == nullptr) {
    throw Error(
        "OSMesa's context does not answer: another libGL was loaded into the process before it "
        "(often by a library linked with opencv_highgui)");
  }
  requireThreads();
}

/// Mesa does not notice where the system started no threads for it, and waits for what they do for
/// ever. Where there is one more to be had, it has its own.
void OsmesaContext::requireThreads() {
  try {
    std::thread([] {}).join();
  } catch (const std::system_error& error) {
    (void)context_.release();  // its end would wait, too
    throw Error(
        std::string("the system starts no more threads for this process: ") +
        error.code().message() +
        "; Mesa needs one for each core, and two more are for pictures and files: raise the "
        "limit of processes (ulimit -u), of memory (ulimit -v), or of the container");
  }
}

std::string OsmesaContext::version() const {
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): OpenGL's texts are unsigned
  return reinterpret_cast<const char*>(gl_->GetString(GL_VERSION));
}

OsmesaContext::~OsmesaContext() { OSMesaMakeCurrent(nullptr, nullptr, 0, 0, 0); }

}  // namespace synthetic_dataset::render
