#include "render/gl/offscreen_context.h"

#include <cstdlib>
#include <string>
#include <system_error>
#include <thread>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

/// The platforms that are built in, the default first.
constexpr const char* kPlatforms =
#if defined(SYNTHETIC_DATASET_OSMESA) && defined(SYNTHETIC_DATASET_EGL)
    "osmesa or egl";
#elif defined(SYNTHETIC_DATASET_OSMESA)
    "osmesa";
#else
    "egl";
#endif

std::unique_ptr<OffscreenPlatform> open(const std::string& name) {
#ifdef SYNTHETIC_DATASET_OSMESA
  if (name.empty() || name == "osmesa") return openOsmesa();
#endif
#ifdef SYNTHETIC_DATASET_EGL
  if (name.empty() || name == "egl") return openEgl();
#endif
  throw Error("SYNTHETIC_DATASET_GL: found '" + name + "'; it should be " + kPlatforms +
              ", with which this program was built");
}

std::unique_ptr<OffscreenPlatform> openChosen() {
  // Mesa 20 (Debian 11) approximates which mipmap levels a pixel is mixed from, and how, unless
  // these options forbid it. Mesa 22 does not, and knows neither of them.
  setenv("GALLIVM_PERF", "no_brilinear,no_rho_approx", 0);  // keeps the user's value
  const char* const chosen = std::getenv("SYNTHETIC_DATASET_GL");
  return open(chosen == nullptr ? "" : chosen);
}

// NOLINTNEXTLINE(cppcoreguidelines-pro-type-reinterpret-cast): OpenGL's texts are unsigned
std::string textOf(const GLubyte* text) { return reinterpret_cast<const char*>(text); }

}  // namespace

OffscreenContext::OffscreenContext() : platform_(openChosen()) {
  gl_ = std::make_unique<GlFunctions>(platform_->entryPoint());
  if (gl_->GetString(GL_VERSION) == nullptr) {
    throw Error(
        "the OpenGL context does not answer: another libGL was loaded into the process before "
        "OSMesa (often by a library linked with opencv_highgui); SYNTHETIC_DATASET_GL=egl "
        "avoids OSMesa, if this program was built with EGL");
  }
  requireProcessor();
  requireThreads();
}

/// Throws unless llvmpipe draws, as each GPU's driver draws different pixels.
void OffscreenContext::requireProcessor() const {
  const std::string renderer = textOf(gl_->GetString(GL_RENDERER));
  if (renderer.find("llvmpipe") != std::string::npos) return;
  throw Error("OpenGL is drawn by '" + renderer +
              "'; it should be Mesa's llvmpipe, on which equal runs make equal pictures");
}

/// Throws if no more threads can be started. Mesa does not notice if the system could not start its
/// threads, and waits for them for ever. If one more thread can be started, Mesa has its own.
void OffscreenContext::requireThreads() {
  try {
    std::thread([] {}).join();
  } catch (const std::system_error& error) {
    (void)platform_.release();  // its destructor would wait, too
    throw Error(
        std::string("the system starts no more threads for this process: ") +
        error.code().message() +
        "; Mesa needs one for each core, and two more are for pictures and files: raise the "
        "limit of processes (ulimit -u), of memory (ulimit -v), or of the container");
  }
}

std::string OffscreenContext::version() const { return textOf(gl_->GetString(GL_VERSION)); }

}  // namespace synthetic_dataset::render
