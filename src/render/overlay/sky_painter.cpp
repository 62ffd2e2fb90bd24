#include "render/overlay/sky_painter.h"

#include <algorithm>
#include <cmath>

#include "render/gl/framebuffer.h"
#include "render/overlay/shader_macros.h"
#include "render/pixels/srgb.h"
#include "render/shaders.h"

namespace synthetic_dataset::render {
namespace {

/// Vertical optical thickness of the air at 680, 550 and 440 nm (Bucholtz 1995, Rayleigh).
const Eigen::Vector3f kAir(0.041F, 0.098F, 0.243F);
constexpr float kHaze = 0.03F;

/// Makes a clear sky at noon about as bright as a surface in the sun.
constexpr float kSunBrightness = 16.0F;
const Eigen::Vector3f kNight(0.0012F, 0.0018F, 0.004F);

/// The progress of the day: 0 at sunrise, 1 at sunset, and on to 2 at the next sunrise.
double dayProgress(const world::Sky& sky) {
  const auto wrapped = [](double hours) { return hours - 24.0 * std::floor(hours / 24.0); };
  const double day = wrapped(sky.sunset - sky.sunrise);
  const double since = wrapped(sky.time - sky.sunrise);
  if (since <= day) return since / std::max(day, 1e-3);
  return 1.0 + (since - day) / (24.0 - day);
}

/// The relative air mass towards the sun, given the sine of its elevation (Kasten and Young 1989).
double airMass(double sine) {
  const double s = std::clamp(sine, 0.0, 1.0);
  return 1.0 / (s + 0.50572 * std::pow(6.07995 + std::asin(s) * 180.0 / M_PI, -1.6364));
}

/// The share of the sun that still lights the sky, which fades from sunset to the end of civil
/// twilight.
double daylight(double sine) {
  constexpr double kDark = -0.1045;  // the sine of 6 degrees below the horizon
  const double x = std::clamp((sine - kDark) / -kDark, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

/// The panorama's height; a clear sky varies slowly and needs fewer rows.
int skyRows(const world::Sky& sky) { return sky.cloud_humidity > 0.0 ? 512 : 256; }

}  // namespace

Eigen::Vector3d sunDirection(const world::Sky& sky, const std::vector<world::Light>& lights) {
  constexpr double kHighest = M_PI / 3.0;
  const double progress = dayProgress(sky);
  const auto sun = std::find_if(lights.begin(), lights.end(), [](const world::Light& light) {
    return light.type == world::LightType::kDirectional;
  });
  if (progress <= 1.0 && sun != lights.end()) {
    return -(sun->X_WL.linear() * sun->direction_L).normalized();
  }
  const double angle = M_PI * progress;
  return {std::cos(angle), -std::sin(angle) * std::cos(kHighest),
          std::sin(angle) * std::sin(kHighest)};
}

ShaderProgram makeSkyProgram(const GlFunctions& gl, const world::Sky& sky,
                             const std::string& macros) {
  const std::string clouds = sky.cloud_humidity > 0.0 ? "#define CLOUDS\n" : "";
  ShaderProgram program(gl, shaders::kRectanglesVertex,
                        withMacros(shaders::kSkyFragment, macros + clouds));
  program.set("night", kNight);
  program.set("air", kAir);
  program.set("haze", kHaze);
  program.set("cloud_colour", linearFromSrgb(sky.cloud_ambient));
  program.set("cloud_cover", static_cast<float>(std::clamp(sky.cloud_humidity, 0.0, 1.0)));
  program.set("cloud_scale",
              static_cast<float>(4.0 - 3.2 * std::clamp(sky.cloud_mean_size, 0.0, 1.0)));
  return program;
}

void setSun(const ShaderProgram& program, const Eigen::Vector3d& sun) {
  const auto brightness = static_cast<float>(daylight(sun.z())) * kSunBrightness;
  program.set("sun_W", Eigen::Vector3f(sun.cast<float>()));
  program.set("sunlight", Eigen::Vector3f(Eigen::Vector3f::Constant(brightness)));
  program.set("sun_air_mass", static_cast<float>(airMass(sun.z())));
}

SkyPainter::SkyPainter(const GlFunctions& gl, const world::Sky& sky,
                       const std::vector<world::Light>& lights, bool encoded)
    : sky_(sky), program_(makeSkyProgram(gl, sky, encoded ? kEncodedMacro : "")), drawing_(gl) {
  setLights(lights);
}

void SkyPainter::setLights(const std::vector<world::Light>& lights) const {
  setSun(program_, sunDirection(sky_, lights));
}

void SkyPainter::paint(const View& view, float exposure,
                       const std::vector<cv::Rect>& regions) const {
  const Intrinsics& k = view.camera.intrinsics();
  program_.set("exposure", exposure);
  program_.set("exposure_later", exposure);
  program_.set("world_from_camera", Eigen::Matrix4f(view.X_WC.matrix().cast<float>()));
  program_.set("intrinsics",
               Eigen::Vector4f(Eigen::Vector4d(k.fx, k.fy, k.cx, k.cy).cast<float>()));
  drawing_.draw(program_, regions, {view.camera.width(), view.camera.height()});
}

SkyPanorama::SkyPanorama(const GlFunctions& gl, const world::Sky& sky)
    : program_(makeSkyProgram(gl, sky, "#define PANORAMA\n")),
      drawing_(gl),
      light_(gl, {2 * skyRows(sky), skyRows(sky)}, {GL_RGBA16F}) {
  const cv::Size& size = light_.size();
  program_.set("picture_size", Eigen::Vector4f(static_cast<float>(size.width),
                                               static_cast<float>(size.height), 0.0F, 0.0F));
}

cv::Mat SkyPanorama::draw(const Eigen::Vector3d& sun) const {
  const cv::Rect all({}, light_.size());
  setSun(program_, sun);
  light_.bind();
  drawing_.draw(program_, {all}, light_.size());
  return light_.read(0, all);
}

}  // namespace synthetic_dataset::render
