#include "randomize/appearance/variety/repainting.h"

#include "randomize/appearance/variety/flat_index.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace synthetic_dataset::randomize {
namespace {

constexpr float kDarkest = 0.02F;  // lightness added to both sides of a ratio, to keep it finite

/// Fades out shading on nearly black colours, where it says little.
float shadeOn(float shade, const Eigen::Vector3f& colour, float contrast) {
  const float kept = contrast * std::min(1.0F, lightnessOf(colour) / 0.25F);
  return std::clamp(1.0F + kept * (shade - 1.0F), 0.25F, 1.8F);
}

Eigen::Vector3f asPaint(const Eigen::Vector3f& colour, const Eigen::Vector3f& from,
                        const Eigen::Vector3f& to, float contrast) {
  const float shade = (lightnessOf(colour) + kDarkest) / (lightnessOf(from) + kDarkest);
  return shadeOn(shade, from, contrast) * to + contrast * (colour - shade * from);
}

/// How colours of a canvas that are not painted over change. Changes are cached with 64 levels per
/// channel and added, so that finer differences stay.
class ColourChanges {
 public:
  ColourChanges(const PaintedModel& model, const VariantPaint& paint)
      : model_(model), paint_(paint), changes_(1U << 18U), is_known_(1U << 18U, 0) {}

  Eigen::Vector3f operator()(const cv::Vec4b& pixel) {
    const auto index = static_cast<std::size_t>(((pixel[0] >> 2) << 12) | ((pixel[1] >> 2) << 6) |
                                                (pixel[2] >> 2));
    const auto middle = [](std::uint8_t value) { return static_cast<float>(value & ~3) + 1.5F; };
    if (is_known_[index] == 0) {
      const Eigen::Vector3f colour =
          Eigen::Vector3f(middle(pixel[2]), middle(pixel[1]), middle(pixel[0])) / 255.0F;
      changes_[index] = repainted(colour, model_, paint_) - colour;
      is_known_[index] = 1;
    }
    return changes_[index];
  }

 private:
  const PaintedModel& model_;
  const VariantPaint& paint_;
  std::vector<Eigen::Vector3f> changes_;
  std::vector<std::uint8_t> is_known_;
};

/// The colour of a part at a height, with band edges as soft as those in a picture.
Eigen::Vector3f colourAt(const PartPaint& part, const Eigen::Vector3f& field, float height) {
  constexpr float kEdge = 0.004F;
  Eigen::Vector3f colour = field;
  for (const Band& band : part.bands) {
    const float inside = std::min(height - band.low, band.high - height);
    const float share = std::clamp(0.5F + inside / kEdge, 0.0F, 1.0F);
    colour += share * (band.colour - colour);
  }
  return colour;
}

/// Paints the texels of one canvas.
class CanvasPainter {
 public:
  CanvasPainter(const PaintCanvas& canvas, const PaintedModel& model, const VariantPaint& paint)
      : canvas_(canvas),
        model_(model),
        paint_(paint),
        changes_(model, paint),
        noise_(SolidNoise::shared()) {
    const Eigen::Vector3f size = model.parts.box_M.sizes().cast<float>();
    scale_ = 1.0F / std::max(size.maxCoeff(), 1e-6F);
    height_ = 1.0F / std::max(size.z(), 1e-6F);
    foot_ = static_cast<float>(model.parts.box_M.min().z());
    is_clean_ = paint.wear.isClean();
  }

  [[nodiscard]] Eigen::Vector3f colour(const cv::Vec4b& pixel, const PaintCanvas::Texel& texel) {
    const Eigen::Vector3f given = Eigen::Vector3f(pixel[2], pixel[1], pixel[0]) / 255.0F;
    Eigen::Vector3f colour;
    const PartPaint* part =
        texel.part >= 0 ? &paint_.parts[static_cast<std::size_t>(texel.part)] : nullptr;
    if (part != nullptr && (part->colour || !part->bands.empty())) {
      colour = paintedOver(given, pixel, texel, *part);
    } else {
      colour = given + changes_(pixel);
    }
    if (part != nullptr && part->print) {
      const float ink = part->print->inkAt(texel.p_M);
      colour += 0.9F * ink * (part->print->ink() - colour);
    }
    if (!is_clean_ && texel.part != PaintCanvas::kNone) {
      paint_.wear.apply(colour, scale_ * texel.p_M, height_ * (texel.p_M.z() - foot_), noise_);
    }
    return colour;
  }

 private:
  Eigen::Vector3f paintedOver(const Eigen::Vector3f& given, const cv::Vec4b& pixel,
                              const PaintCanvas::Texel& texel, const PartPaint& part) {
    const Eigen::AlignedBox3f& box = model_.painted[static_cast<std::size_t>(texel.part)].box_M;
    const float height = (texel.p_M.z() - box.min().z()) / std::max(box.sizes().z(), 1e-6F);
    const Eigen::Vector3f& own = model_.palette().paints()[texel.paint].colour;
    const float shade = shadeOn(texel.shade, own, paint_.contrast);
    const Eigen::Vector3f below = given + changes_(pixel);
    Eigen::Vector3f field = below;
    if (part.colour) field = shade * *part.colour + part.detail * (below - shade * *part.colour);
    if (part.bands.empty()) return field;
    const Eigen::Vector3f flat = colourAt(part, field / std::max(shade, 1e-3F), height);
    return shade * flat;
  }

  const PaintCanvas& canvas_;
  const PaintedModel& model_;
  const VariantPaint& paint_;
  ColourChanges changes_;
  const SolidNoise& noise_;
  float scale_;
  float height_;
  float foot_;
  bool is_clean_;
};

/// Draws a short thin line, lighter or darker than what it cuts into.
void scratch(const PaintCanvas& canvas, base::RandomSource& random, cv::Mat& picture) {
  const int side = std::max(picture.rows, picture.cols);
  std::size_t start = 0;
  bool is_seen = false;
  for (int tries = 0; tries < 20 && !is_seen; ++tries) {
    start = random.index(canvas.texels.size());
    is_seen = canvas.texels[start].part != PaintCanvas::kNone;
  }
  const double angle = random.angle();
  const int length = static_cast<int>(random.uniform(0.005, 0.05) * side);
  const double bend = random.uniform(-0.02, 0.02);
  const bool is_light = random.unit() < 0.6;
  const double depth = random.uniform(0.25, 0.6);
  if (!is_seen) return;
  const std::size_t start_row = start / static_cast<std::size_t>(picture.cols);
  auto x = static_cast<double>(start % static_cast<std::size_t>(picture.cols));
  auto y = static_cast<double>(start_row);
  const std::int32_t part = canvas.texels[start].part;
  for (int step = 0; step < length; ++step) {
    const auto column = static_cast<int>(std::lround(x));
    const auto row = static_cast<int>(std::lround(y));
    if (row < 0 || column < 0 || row >= picture.rows || column >= picture.cols) return;
    const std::size_t index = flatIndex(row, column, picture.cols);
    if (canvas.texels[index].part != part) return;
    auto& pixel = picture.at<cv::Vec4b>(row, column);
    for (int i = 0; i < 3; ++i) {
      const double to = is_light ? 205.0 : 25.0;
      pixel[i] = cv::saturate_cast<std::uint8_t>(pixel[i] + depth * (to - pixel[i]));
    }
    x += std::cos(angle + bend * step);
    y += std::sin(angle + bend * step);
  }
}

}  // namespace

Eigen::Vector3f repainted(const Eigen::Vector3f& colour, const PaintedModel& model,
                          const VariantPaint& paint) {
  const std::vector<Paint>& paints = model.palette().paints();
  const PaintPalette::Likeness likeness = model.palette().likeness(colour);
  const auto as = [&](std::size_t i) {
    return asPaint(colour, paints[i].colour, paint.colours[i], paint.contrast);
  };
  Eigen::Vector3f first = as(likeness.first);
  if (likeness.share <= 0.0F) return first;
  return first + likeness.share * (as(likeness.second) - first);
}

cv::Mat repainted(const PaintCanvas& canvas, const PaintedModel& model, const VariantPaint& paint,
                  base::RandomSource& random) {
  CanvasPainter painter(canvas, model, paint);
  cv::Mat picture(canvas.picture.rows, canvas.picture.cols, CV_8UC4);
  for (int row = 0; row < picture.rows; ++row) {
    const auto* given = canvas.picture.ptr<cv::Vec4b>(row);
    auto* result = picture.ptr<cv::Vec4b>(row);
    const PaintCanvas::Texel* texels =
        &canvas.texels[static_cast<std::size_t>(row) * static_cast<std::size_t>(picture.cols)];
    for (int column = 0; column < picture.cols; ++column) {
      const Eigen::Vector3f colour = painter.colour(given[column], texels[column]);
      const auto byte = [&](int channel) {
        return static_cast<std::uint8_t>(std::clamp(255.0F * colour[channel] + 0.5F, 0.0F, 255.0F));
      };
      result[column] = {byte(2), byte(1), byte(0), given[column][3]};
    }
  }
  for (int i = 0; i < paint.wear.scratches; ++i) scratch(canvas, random, picture);
  return picture;
}

}  // namespace synthetic_dataset::randomize
