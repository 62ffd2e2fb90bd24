#include "world/sdf/sdf_lenses.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <Eigen/Dense>

#include "world/sdf/sdf_values.h"

namespace synthetic_dataset::world {
namespace {

/// The mapping function's parts, as SDF's <custom_function> names them.
struct Mapping {
  double c1 = 1.0;
  double c2 = 1.0;
  double c3 = 0.0;
  double f = 1.0;
  std::string fun = "tan";

  [[nodiscard]] double apply(double angle) const {
    if (fun == "tan") return std::tan(angle);
    return fun == "sin" ? std::sin(angle) : angle;
  }

  /// The angle up to which the function increases [rad].
  [[nodiscard]] double end() const { return fun == "id" ? M_PI : std::min(M_PI, c2 * 0.5 * M_PI); }

  /// The radius in the image for an angle from the axis, scaled so that it equals the angle for
  /// small angles.
  [[nodiscard]] double radius(double angle) const { return c2 * apply(angle / c2); }
};

Mapping customMapping(const Element& lens, const SourceLocation& location, SdfReading& reading) {
  const Element element = lens.child("custom_function");
  const auto number = [&](const char* name, double fallback) {
    return readNumber(element, name, fallback, location, reading);
  };
  Mapping mapping;
  mapping.c1 = number("c1", 1.0);
  mapping.c2 = number("c2", 1.0);
  mapping.c3 = number("c3", 0.0);
  mapping.f = number("f", 1.0);
  const std::string fun = readText(element, "fun");
  if (!fun.empty()) mapping.fun = fun;
  return mapping;
}

/// https://en.wikipedia.org/wiki/Fisheye_lens#Mapping_function
Mapping mappingOf(const Element& lens, const SourceLocation& location, SdfReading& reading) {
  const std::string named = readText(lens, "type");
  const std::string type = named.empty() ? "stereographic" : named;
  if (type == "gnomonical") return {1.0, 1.0, 0.0, 1.0, "tan"};
  if (type == "stereographic") return {2.0, 2.0, 0.0, 1.0, "tan"};
  if (type == "equidistant") return {1.0, 1.0, 0.0, 1.0, "id"};
  if (type == "equisolid_angle") return {2.0, 2.0, 0.0, 1.0, "sin"};
  if (type == "orthographic") return {1.0, 1.0, 0.0, 1.0, "sin"};
  if (type == "custom") return customMapping(lens, location, reading);
  throw Error("lens/type: found '" + type +
              "'; it should be gnomonical, stereographic, equidistant, equisolid_angle, "
              "orthographic or custom");
}

void checkMapping(const Mapping& mapping) {
  if (mapping.fun != "tan" && mapping.fun != "sin" && mapping.fun != "id") {
    throw Error("lens/custom_function/fun: found '" + mapping.fun +
                "'; it should be sin, tan or id");
  }
  if (!(mapping.c1 > 0.0) || !(mapping.c2 > 0.0) || !(mapping.f > 0.0)) {
    throw Error("lens/custom_function: c1, c2 and f should be above 0");
  }
  if (mapping.c3 != 0.0) {
    throw UnsupportedLens("lens/custom_function/c3: found " + std::to_string(mapping.c3) +
                          "; only lenses with 0 are drawn");
  }
}

/// The radius, in half widths of the image, of one unit of c1 fun().
double scaleOf(const Mapping& mapping, bool is_scaled, double field_of_view) {
  if (!is_scaled) return mapping.f;
  const double half = 0.5 * field_of_view;
  if (!(half > 0.0 && (half < mapping.end() || (mapping.fun != "tan" && half <= mapping.end())))) {
    throw Error("horizontal_fov: found " + std::to_string(field_of_view) +
                "; with this lens it should be above 0 and below " +
                std::to_string(2.0 * mapping.end()) + " rad");
  }
  return 1.0 / (mapping.c1 * mapping.apply(half / mapping.c2));
}

/// The angle at which the lens reaches a radius, or `end` if that comes first.
double angleAt(const Mapping& mapping, double radius, double end) {
  double low = 0.0;
  double high = end;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (mapping.radius(middle) < radius ? low : high) = middle;
  }
  return high;
}

/// Fits theta (1 + k1 theta^2 + ... + k4 theta^8) to the radius by least squares.
Distortion fitted(const Mapping& mapping, double largest_angle, double focal_length) {
  constexpr int kPlaces = 400;
  constexpr double kTolerance = 0.05;  // [px]
  Eigen::MatrixXd powers(kPlaces, 4);
  Eigen::VectorXd wanted(kPlaces);
  for (int i = 0; i < kPlaces; ++i) {
    const double angle = largest_angle * (i + 1) / kPlaces;
    for (int j = 0; j < 4; ++j) powers(i, j) = std::pow(angle, 2 * j + 3);
    wanted(i) = mapping.radius(angle) - angle;
  }
  const Eigen::VectorXd k = powers.colPivHouseholderQr().solve(wanted);
  const double error = focal_length * (powers * k - wanted).cwiseAbs().maxCoeff();
  if (!(error <= kTolerance)) {
    throw UnsupportedLens("lens: its mapping up to " + std::to_string(largest_angle) + " rad is " +
                          std::to_string(error) +
                          " px from any equidistant lens with four coefficients; a smaller "
                          "cutoff_angle would fit better");
  }
  Distortion distortion;
  distortion.model = DistortionModel::kEquidistant;
  std::copy(k.data(), k.data() + 4, distortion.coefficients.begin());
  distortion.cutoff_angle = largest_angle;
  return distortion;
}

Distortion distortionOf(const Mapping& mapping, double cutoff, double focal_length, double corner) {
  if (mapping.fun == "id") {
    return {DistortionModel::kEquidistant, {}, std::min(cutoff, M_PI)};
  }
  if (mapping.fun == "tan" && mapping.c2 == 1.0) return {DistortionModel::kNone, {}, cutoff};
  // At the very end of the function, the radius would become infinite, or stop growing.
  const double end = std::min(cutoff, 0.995 * mapping.end());
  const double largest_angle = angleAt(mapping, corner / focal_length, end);
  return fitted(mapping, largest_angle, focal_length);
}

}  // namespace

Distortion brownDistortion(const Element& camera, const SourceLocation& location,
                           SdfReading& reading) {
  const Element element = camera.child("distortion");
  if (!element) return {};
  const auto k = [&](const char* name) {
    return readNumber(element, name, 0.0, location, reading);
  };
  Distortion distortion;
  distortion.coefficients = {k("k1"), k("k2"), k("p1"), k("p2"), k("k3")};
  const auto& c = distortion.coefficients;
  if (std::all_of(c.begin(), c.end(), [](double number) { return number == 0.0; })) return {};
  const std::string centre = readText(element, "center");
  if (!centre.empty() && numbersIn(centre) != std::vector<double>{0.5, 0.5}) {
    throw UnsupportedLens("distortion/center: found '" + centre +
                          "'; only distortion about the middle, 0.5 0.5, is drawn");
  }
  distortion.model = DistortionModel::kPlumbBob;
  return distortion;
}

Lens wideAngleLens(const CameraImage& image, const Element& camera, const SourceLocation& location,
                   SdfReading& reading) {
  constexpr double kDefaultCutoff = 1.5707;  // SDF's
  const Element lens = camera.child("lens");
  const Mapping mapping = mappingOf(lens, location, reading);
  checkMapping(mapping);
  const double width = image.width;
  const double height = image.height;
  const bool is_scaled = readBool(lens, "scale_to_hfov", true, location, reading);
  const double scale = scaleOf(mapping, is_scaled, image.field_of_view);
  const double focal_length = 0.5 * width * mapping.c1 * scale / mapping.c2;
  const double cutoff = readNumber(lens, "cutoff_angle", kDefaultCutoff, location, reading);
  return {{focal_length, focal_length, 0.5 * (width - 1.0), 0.5 * (height - 1.0)},
          distortionOf(mapping, cutoff, focal_length, 0.5 * std::hypot(width, height))};
}

}  // namespace synthetic_dataset::world
