#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace synthetic_dataset {
inline namespace v2 {

/// The models of lenses that are drawn, and what their coefficients are.
enum class DistortionModel {
  kNone,
  kPlumbBob,            ///< k1, k2, p1, p2, k3
  kRationalPolynomial,  ///< k1, k2, p1, p2, k3, k4, k5, k6, s1, s2, s3, s4, tau_x, tau_y
  kEquidistant,         ///< k1, k2, k3, k4 of a fisheye lens
  kOmnidirectional,     ///< xi, k1, k2, p1, p2, skew / fx of a mirror or a wide lens
  kDoubleSphere,        ///< xi, alpha
};

/// Coefficients in the order above, which is that of CameraInfo's D, of OpenCV and of Kalibr; those
/// that a model lacks are 0.
/// Formulas: OpenCV's documentation of calib3d and of its fisheye module; C. Mei and P. Rives,
/// "Single View Point Omnidirectional Camera Calibration from Planar Grids" (2007); V. Usenko,
/// N. Demmel and D. Cremers, "The Double Sphere Camera Model" (2018).
struct Distortion {
  static constexpr std::size_t kMostCoefficients = 14;

  DistortionModel model = DistortionModel::kNone;
  std::array<double, kMostCoefficients> coefficients{};

  /// The lens shows nothing that is farther from its axis than this [rad], in (0, pi].
  double cutoff_angle = 3.14159265358979323846;
};

[[nodiscard]] inline bool operator==(const Distortion& a, const Distortion& b) {
  return a.model == b.model && a.coefficients == b.coefficients && a.cutoff_angle == b.cutoff_angle;
}

/// What CameraInfo calls a model, or this software where CameraInfo has no name for it: "none",
/// "plumb_bob", "rational_polynomial", "equidistant", "omnidirectional", "double_sphere".
[[nodiscard]] const std::string& distortionModelName(DistortionModel model);

/// Whether a name is that of a model that is drawn, by whichever of its names: ROS's, OpenCV's or
/// Kalibr's, whatever its capitals, spaces and hyphens.
[[nodiscard]] bool isDistortionModelName(const std::string& name);

/// The coefficients as lists have them: as many as the model needs, without the zeros at the end
/// that a shorter list stands for.
[[nodiscard]] std::vector<double> coefficientsOf(const Distortion& distortion);

/// The distortion that a name and a list describe. Zeros may follow the model's own coefficients.
/// As OpenCV and ROS do, a list of `plumb_bob` with more coefficients is taken for that of
/// `rational_polynomial`. Without coefficients other than 0, models that then bend nothing are
/// kNone, whatever their name.
/// @throws Error naming `distortion_model` or `distortion_coefficients`, what was found and what
///     would be right; for a model that is known but not drawn, with its name
[[nodiscard]] Distortion makeDistortion(const std::string& model,
                                        const std::vector<double>& coefficients);

}  // namespace v2
}  // namespace synthetic_dataset
