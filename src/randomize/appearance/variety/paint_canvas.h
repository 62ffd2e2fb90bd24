#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include <opencv2/core/mat.hpp>

#include "randomize/appearance/variety/model_parts.h"
#include "randomize/appearance/variety/paint_palette.h"
#include "randomize/appearance/variety/width_profile.h"
#include "world/description.h"

namespace synthetic_dataset::randomize {

/// A piece of a surface within one height level of the model, to be painted.
struct PaintedPart {
  enum class Pattern {
    kPlain,    ///< a single paint
    kBanded,   ///< paints that change only with the height: a cone's stripes
    kPicture,  ///< anything else
  };

  Eigen::AlignedBox3f box_M;
  double share = 0.0;          ///< of the model's surface
  std::vector<double> paints;  ///< how much of it each paint of the palette covers
  std::size_t paint = 0;       ///< the most common one
  Pattern pattern = Pattern::kPlain;
};

/// A picture that surfaces show, with data about each texel.
struct PaintCanvas {
  struct Texel {
    Eigen::Vector3f p_M{0.0F, 0.0F, 0.0F};
    std::int32_t part = kNone;  ///< index of its part, or one of the values below
    std::uint8_t paint = 0;     ///< index in the palette
    bool is_mixed = false;      ///< of two paints, or near their border
    float shade = 1.0F;         ///< its lightness relative to that of its paint
  };
  static constexpr std::int32_t kNone = -1;       ///< no surface shows it
  static constexpr std::int32_t kSomewhere = -2;  ///< several places show it

  std::vector<std::size_t> surfaces;  ///< that show it, indices in the model's parts
  cv::Mat picture;                    ///< CV_8UC4, as in Texture
  std::vector<Texel> texels;          ///< row by row
};

/// A model prepared for painting: its pictures, each texel's place, and its paints. Made once for
/// all variants.
class PaintedModel {
 public:
  explicit PaintedModel(const world::Model& original);

  /// Looks like the original and has the same triangles; large surfaces without a texture of their
  /// own have received one.
  world::Model model;
  ModelParts parts;                 ///< of `model`
  std::vector<HeightLevel> levels;  ///< of `model`
  std::vector<PaintCanvas> canvases;
  std::vector<PaintedPart> painted;     ///< parts of the canvases
  std::vector<std::size_t> untextured;  ///< indices in the parts' surfaces: those in one colour

  [[nodiscard]] const PaintPalette& palette() const { return *palette_; }

 private:
  void place(PaintCanvas& canvas, ColourCount& colours);
  void classify(PaintCanvas& canvas) const;
  static void smoothBorders(PaintCanvas& canvas);
  void findPatterns();

  std::optional<PaintPalette> palette_;
};

}  // namespace synthetic_dataset::randomize
