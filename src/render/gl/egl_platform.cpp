#include <array>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include "render/gl/offscreen_platform.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::render {
namespace {

constexpr std::array<EGLint, 7> kAttributes = {EGL_CONTEXT_MAJOR_VERSION,
                                               4,
                                               EGL_CONTEXT_MINOR_VERSION,
                                               5,
                                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                               EGL_NONE};

[[noreturn]] void fail(const std::string& what) {
  throw Error("EGL " + what + "; it needs Mesa's llvmpipe driver (packages libegl1 and " +
              "libgl1-mesa-dri, version 20 or newer)");
}

void* entryPointOf(const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

/// EGL without any surface, on the CPU regardless of any GPU.
/// https://registry.khronos.org/EGL/extensions/MESA/EGL_MESA_platform_surfaceless.txt
class EglPlatform : public OffscreenPlatform {
 public:
  EglPlatform() {
    setenv("LIBGL_ALWAYS_SOFTWARE", "true", 1);
    setenv("GALLIUM_DRIVER", "llvmpipe", 1);
    const char* const extensions = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    if (extensions == nullptr ||
        std::strstr(extensions, "EGL_MESA_platform_surfaceless") == nullptr) {
      fail("has no surfaceless platform");
    }
    display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) != EGL_TRUE) {
      fail("cannot open its surfaceless platform");
    }
    context_ =
        eglBindAPI(EGL_OPENGL_API) == EGL_TRUE
            ? eglCreateContext(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data())
            : EGL_NO_CONTEXT;
    if (context_ == EGL_NO_CONTEXT) fail("cannot make an OpenGL 4.5 core context");
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
      eglDestroyContext(display_, context_);
      fail("cannot make its context current");
    }
  }

  /// Leaves the display open, as the whole process shares it, including other contexts.
  ~EglPlatform() override {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  EglPlatform(const EglPlatform&) = delete;
  EglPlatform& operator=(const EglPlatform&) = delete;

  [[nodiscard]] EntryPoint entryPoint() const override { return entryPointOf; }

 private:
  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<OffscreenPlatform> openEgl() { return std::make_unique<EglPlatform>(); }

}  // namespace synthetic_dataset::render
