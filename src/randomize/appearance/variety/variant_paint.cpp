#include "randomize/appearance/variety/variant_paint.h"

#include <algorithm>
#include <cmath>

#include "randomize/appearance/variety/hue.h"

namespace synthetic_dataset::randomize {
namespace {

constexpr float kColourful = 0.25F;  // saturation; anything below is a grey

bool happens(base::RandomSource& random, double probability) { return random.unit() < probability; }

float between(base::RandomSource& random, double low, double high) {
  return static_cast<float>(random.uniform(low, high));
}

/// How a paint differs from the one on the model.
struct PaintChange {
  float hue;         ///< added, in whole turns
  float saturation;  ///< a factor
  float value;       ///< a factor
  float grey_value;  ///< a factor, for greys
  float tinge;       ///< added to greys: warm above 0, cold below
};

/// The same paint from another batch, or after some years.
PaintChange drawSlightChange(base::RandomSource& random) {
  PaintChange change{};
  change.hue = 0.008F * static_cast<float>(random.normal());
  change.saturation = between(random, 0.85, 1.06);
  change.value = between(random, 0.86, 1.08);
  change.grey_value = change.value;
  return change;
}

/// How far another maker's hue is from this one's, in whole turns: mostly a little.
float drawHueShift(base::RandomSource& random) {
  const double kind = random.unit();
  const auto normal = static_cast<float>(random.normal());
  if (kind < 0.75) return 0.02F * normal;
  if (kind < 0.93) return 0.05F * normal;
  return between(random, -0.5, 0.5);
}

/// The paint that another maker would use in its place.
PaintChange drawOtherMakers(base::RandomSource& random) {
  PaintChange change{};
  change.hue = drawHueShift(random);
  change.saturation = between(random, 0.78, 1.2);
  change.value = between(random, 0.78, 1.2);
  change.grey_value = between(random, 0.6, 1.7);
  change.tinge = between(random, -0.03, 0.03);
  return change;
}

bool isColourful(const Eigen::Vector3f& colour) { return toHue(colour).saturation > kColourful; }

Eigen::Vector3f changedPaint(const Eigen::Vector3f& colour, const PaintChange& change) {
  HueColour result = toHue(colour);
  if (isColourful(colour)) {
    result.hue += change.hue;
    result.saturation *= change.saturation;
    result.value = std::clamp(result.value * change.value, std::min(result.value, 0.12F), 1.0F);
    return toRgb(result);
  }
  // A grey stays grey; white is white with most makers.
  const bool is_light = result.value > 0.6F;
  const float factor = is_light ? std::clamp(change.grey_value, 0.8F, 1.06F) : change.grey_value;
  const float tinge = result.saturation + std::abs(change.tinge);
  const float hue = change.tinge == 0.0F ? result.hue : change.tinge > 0.0F ? 0.1F : 0.6F;
  return toRgb({hue, tinge, std::clamp(result.value * factor, 0.03F, 0.97F)});
}

/// The change of each paint. Paints of nearly the same hue change alike: one is the other's shadow.
std::vector<PaintChange> drawChanges(const std::vector<Paint>& paints, Variety variety,
                                     base::RandomSource& random) {
  constexpr float kSameHue = 0.1F;
  std::vector<PaintChange> changes;
  for (std::size_t i = 0; i < paints.size(); ++i) {
    base::RandomSource own(random.bits());
    changes.push_back(variety == Variety::kSameClass ? drawOtherMakers(own)
                                                     : drawSlightChange(own));
    for (std::size_t k = 0; k < i; ++k) {
      if (!isColourful(paints[i].colour) || !isColourful(paints[k].colour)) continue;
      const float off = toHue(paints[i].colour).hue - toHue(paints[k].colour).hue;
      if (std::abs(off - std::round(off)) > kSameHue) continue;
      changes[i] = changes[k];
      break;
    }
  }
  return changes;
}

/// A vivid colour, as on signs or goods.
Eigen::Vector3f drawAnyColour(base::RandomSource& random) {
  return toRgb({between(random, 0.0, 1.0), between(random, 0.5, 1.0), between(random, 0.35, 0.95)});
}

Eigen::Vector3f drawLightGrey(base::RandomSource& random) {
  return Eigen::Vector3f::Constant(between(random, 0.72, 0.97));
}

/// Draws how the parts of another model of the same class are painted.
class ClassPainter {
 public:
  ClassPainter(const PaintedModel& model, const VariantPaint& paint, base::RandomSource& random)
      : model_(model), paint_(paint), random_(random) {}

  PartPaint draw(const PaintedPart& part) {
    const float height = part.box_M.sizes().z() /
                         std::max(static_cast<float>(model_.parts.box_M.sizes().z()), 1e-6F);
    const bool is_large = part.share > 0.08 && height > 0.25F;
    PartPaint result;
    // A generator of its own, so that the parts' draws do not depend on one another.
    base::RandomSource own(random_.bits());
    switch (part.pattern) {
      case PaintedPart::Pattern::kBanded:
        if (is_large) paintBanded(part, own, result);
        break;
      case PaintedPart::Pattern::kPlain:
        paintPlain(part, is_large, own, result);
        break;
      case PaintedPart::Pattern::kPicture:
        paintPicture(part, is_large, own, result);
        break;
    }
    if (is_large && happens(own, 0.3)) {
      const Eigen::Vector3f under = result.colour.value_or(paint_.colours[part.paint]);
      result.print.emplace(part.box_M, inkOn(under, own), own);
    }
    return result;
  }

 private:
  /// Moves stripes, or changes their number, down to none.
  void paintBanded(const PaintedPart& part, base::RandomSource& random, PartPaint& result) const {
    if (happens(random, 0.2)) return;  // stripes stay, in other colours
    const std::size_t field = fieldOf(part);
    result.colour = paint_.colours[field];
    if (happens(random, 0.06)) result.colour = otherPaint(field, random);
    if (happens(random, 0.18)) return;  // plain
    result.bands = drawBands(bandColour(part, field, random), random);
  }

  void paintPlain(const PaintedPart& part, bool is_large, base::RandomSource& random,
                  PartPaint& result) const {
    if (happens(random, 0.25)) result.colour = otherPaint(part.paint, random);
    if (!is_large || !happens(random, 0.15)) return;
    if (!result.colour) result.colour = paint_.colours[part.paint];
    result.bands = drawBands(bandColour(part, part.paint, random), random);
  }

  void paintPicture(const PaintedPart& part, bool is_large, base::RandomSource& random,
                    PartPaint& result) const {
    const double kind = random.unit();
    if (kind < 0.15) {
      result.colour = paint_.colours[part.paint];  // without its picture
      result.detail = between(random, 0.0, 0.25);
    } else if (kind < 0.35) {
      result.colour = paint_.colours[part.paint];  // a paler picture
      result.detail = between(random, 0.4, 0.8);
    }
    if (!is_large || !happens(random, 0.08)) return;
    result.bands = drawBands(bandColour(part, part.paint, random), random);
  }

  /// The paint between a part's bands: the most common one, preferring colours to greys.
  [[nodiscard]] std::size_t fieldOf(const PaintedPart& part) const {
    std::size_t best = part.paint;
    double most = 0.0;
    for (std::size_t i = 0; i < part.paints.size(); ++i) {
      const float saturation = toHue(model_.palette().paints()[i].colour).saturation;
      const double score = part.paints[i] * (0.35 + saturation);
      if (score > most) {
        most = score;
        best = i;
      }
    }
    return best;
  }

  [[nodiscard]] Eigen::Vector3f bandColour(const PaintedPart& part, std::size_t field,
                                           base::RandomSource& random) const {
    std::size_t second = field;
    double most = 0.05;
    for (std::size_t i = 0; i < part.paints.size(); ++i) {
      if (i == field || part.paints[i] < most) continue;
      most = part.paints[i];
      second = i;
    }
    const double kind = random.unit();
    if (kind < 0.72 && second != field) return paint_.colours[second];
    if (kind < 0.9) return drawLightGrey(random);
    if (kind < 0.96) return otherPaint(field, random);
    return drawAnyColour(random);
  }

  /// One of the model's other colours, more likely the more common it is.
  [[nodiscard]] Eigen::Vector3f otherPaint(std::size_t than, base::RandomSource& random) const {
    const std::vector<Paint>& paints = model_.palette().paints();
    double all = 0.0;
    for (std::size_t i = 0; i < paints.size(); ++i) all += i == than ? 0.0 : paints[i].share;
    double drawn = random.unit() * all;
    for (std::size_t i = 0; i < paints.size(); ++i) {
      if (i == than) continue;
      drawn -= paints[i].share;
      if (drawn <= 0.0) return paint_.colours[i];
    }
    return changedPaint(paint_.colours[than], drawOtherMakers(random));
  }

  [[nodiscard]] static std::vector<Band> drawBands(const Eigen::Vector3f& colour,
                                                   base::RandomSource& random) {
    const double kind = random.unit();
    const std::size_t count = kind < 0.36 ? 1 : kind < 0.8 ? 2 : kind < 0.93 ? 3 : 4;
    // Alternating gaps and bands that fill the height, with a gap at the foot and one at the top.
    std::vector<float> lengths;
    float sum = 0.0F;
    for (std::size_t i = 0; i < 2 * count + 1; ++i) {
      const bool is_band = i % 2 == 1;
      const float length = is_band ? between(random, 0.35, 1.0) : between(random, 0.25, 1.0);
      lengths.push_back(count == 1 && !is_band ? 1.6F * length : length);
      sum += lengths.back();
    }
    std::vector<Band> bands;
    float at = 0.0F;
    for (std::size_t i = 0; i < lengths.size(); ++i) {
      const float next = at + lengths[i] / sum;
      if (i % 2 == 1) bands.push_back({at, next, colour});
      at = next;
    }
    return bands;
  }

  [[nodiscard]] static Eigen::Vector3f inkOn(const Eigen::Vector3f& under,
                                             base::RandomSource& random) {
    if (happens(random, 0.15)) return drawAnyColour(random);
    const bool is_light = lightnessOf(under) > 0.5F;
    const double low = is_light ? 0.03 : 0.75;
    return Eigen::Vector3f::Constant(between(random, low, low + 0.2));
  }

  const PaintedModel& model_;
  const VariantPaint& paint_;
  base::RandomSource& random_;
};

}  // namespace

VariantPaint drawPaint(const PaintedModel& model, Variety variety, base::RandomSource& random) {
  const bool is_class = variety == Variety::kSameClass;
  VariantPaint paint;
  const std::vector<Paint>& paints = model.palette().paints();
  const std::vector<PaintChange> changes = drawChanges(paints, variety, random);
  for (std::size_t i = 0; i < paints.size(); ++i) {
    paint.colours.push_back(changedPaint(paints[i].colour, changes[i]));
  }
  paint.contrast = is_class ? between(random, 0.6, 1.15) : between(random, 0.9, 1.1);
  paint.wear = drawWear(random, is_class ? 1.0 : 0.7);
  paint.roughness = is_class ? between(random, -0.2, 0.3) : between(random, -0.1, 0.2);
  paint.parts.resize(model.painted.size());
  if (!is_class) return paint;
  ClassPainter painter(model, paint, random);
  std::vector<PartPaint> parts;
  for (const PaintedPart& part : model.painted) parts.push_back(painter.draw(part));
  paint.parts = std::move(parts);
  return paint;
}

}  // namespace synthetic_dataset::randomize
