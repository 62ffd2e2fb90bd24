#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include "base/random/random_source.h"
#include "randomize/appearance/variety/model_parts.h"
#include "randomize/appearance/variety/width_profile.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A change of a model's proportions: heights are stretched piece by piece, widths by a factor that
/// varies with the height, about a vertical axis. Up is the model's z.
class ShapeChange {
 public:
  /// The limits of what is drawn, as factors on the model's total height and width.
  static constexpr double kLowest = 0.75;
  static constexpr double kHighest = 1.35;
  static constexpr double kNarrowest = 0.5;
  static constexpr double kWidest = 2.4;

  /// @param levels  of the model
  ShapeChange(const ModelParts& parts, const std::vector<HeightLevel>& levels,
              base::RandomSource& random);

  /// Where a point of the model that belongs to no piece moves to, such as a keypoint.
  [[nodiscard]] Eigen::Vector3d moved(const Eigen::Vector3d& p_M) const;

  /// Changes the meshes of visuals and collisions, and masses. Links stay where they are.
  /// @param parts  of this model
  void apply(const ModelParts& parts, world::Model& model) const;

 private:
  struct Knot {
    double from;  ///< height [m]
    double to;
  };

  /// A foot or a head that protrudes beyond what stands on it or carries it.
  struct Flange {
    double low;
    double high;
    double radius;  ///< beyond which it protrudes [m]
    double factor;  ///< on the protruding length
  };

  void drawFlanges(const std::vector<HeightLevel>& levels, base::RandomSource& random);
  void drawHeights(const ModelParts& parts, const std::vector<HeightLevel>& levels,
                   base::RandomSource& random);
  void drawWidths(const ModelParts& parts, base::RandomSource& random);
  [[nodiscard]] double heightAt(double z) const;
  [[nodiscard]] double widthAt(double z) const;
  [[nodiscard]] double flangeAt(const Eigen::Vector3d& p_M) const;
  [[nodiscard]] Eigen::Vector3d moved(const Eigen::Vector3d& p_M, double own_width) const;
  [[nodiscard]] std::shared_ptr<const world::Mesh> changed(const world::Mesh& mesh,
                                                           const SurfacePart& part) const;
  void change(const Pose& X_MC, world::Shape& shape) const;

  Eigen::Vector2d axis_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d width_ = Eigen::Vector2d::Ones();  ///< factors along x and y
  std::vector<Knot> knots_;                          ///< ascending, at least two
  double taper_ = 0.0;
  double bulge_ = 0.0;
  std::vector<Flange> flanges_;
  std::vector<double> own_widths_;            ///< one per piece
  std::vector<Eigen::AlignedBox3d> boxes_M_;  ///< one per piece
};

}  // namespace synthetic_dataset::randomize
