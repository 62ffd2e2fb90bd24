#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace synthetic_dataset {
inline namespace v2 {

/// The lens models that can be rendered, with their coefficients.
enum class DistortionModel {
  kNone,
  kPlumbBob,            ///< k1, k2, p1, p2, k3
  kRationalPolynomial,  ///< k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, tau_x, tau_y
  kEquidistant,         ///< k1, k2, k3, k4 of a fisheye lens
  kOmnidirectional,     ///< xi, k1, k2, p1, p2, skew / fx of a mirror or a wide lens
  kDoubleSphere,        ///< xi, alpha
};

/// A lens model with its coefficients in the order above, which is also that of CameraInfo's D, of
/// OpenCV and of Kalibr; coefficients that the model lacks are 0.
/// Formulas: OpenCV's documentation of calib3d and of its fisheye module; C. Mei and P. Rives,
/// "Single View Point Omnidirectional Camera Calibration from Planar Grids" (2007); V. Usenko,
/// N. Demmel and D. Cremers, "The Double Sphere Camera Model" (2018).
struct Distortion {
  static constexpr std::size_t kMostCoefficients = 14;

  DistortionModel model = DistortionModel::kNone;
  std::array<double, kMostCoefficients> coefficients{};

  /// The lens shows nothing farther from its axis than this angle [rad], in (0, pi].
  double cutoff_angle = 3.14159265358979323846;
};

[[nodiscard]] inline bool operator==(const Distortion& a, const Distortion& b) {
  return a.model == b.model && a.coefficients == b.coefficients && a.cutoff_angle == b.cutoff_angle;
}

/// CameraInfo's name for a model, or this software's own if CameraInfo has none: "none",
/// "plumb_bob", "rational_polynomial", "equidistant", "omnidirectional", "double_sphere".
[[nodiscard]] const std::string& distortionModelName(DistortionModel model);

/// Whether this is ROS's, OpenCV's or Kalibr's name for a model that can be rendered; case, spaces
/// and hyphens are ignored.
[[nodiscard]] bool isDistortionModelName(const std::string& name);

/// The coefficients as a list: as many as the model needs, without trailing zeros that a shorter
/// list implies.
[[nodiscard]] std::vector<double> coefficientsOf(const Distortion& distortion);

/// Makes the distortion that a model's name and a list of coefficients describe. Zeros may follow
/// the model's own coefficients. As in OpenCV and ROS, a `plumb_bob` list with more coefficients is
/// read as one of `rational_polynomial`. If all coefficients are 0, the result is kNone whatever
/// the name, except for models that bend the picture even then.
/// @throws Error naming `distortion_model` or `distortion_coefficients`, what was found and what
///     would be right; for a known model that cannot be rendered, also what it is
[[nodiscard]] Distortion makeDistortion(const std::string& model,
                                        const std::vector<double>& coefficients);

}  // namespace v2
}  // namespace synthetic_dataset
