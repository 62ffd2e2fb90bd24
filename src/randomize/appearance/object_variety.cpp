#include "randomize/appearance/object_variety.h"

#include <algorithm>
#include <utility>

#include "base/random/random_source.h"
#include "randomize/appearance/variety/canvas_making.h"
#include "randomize/appearance/variety/paint_canvas.h"
#include "randomize/appearance/variety/repainting.h"
#include "randomize/appearance/variety/variant_paint.h"
#include "world/material/material_conversions.h"

namespace synthetic_dataset::randomize {
namespace {

void roughen(float amount, world::Material& material) {
  const bool has_highlight = material.shininess > 0.0F;
  if (has_highlight) {
    const float before = world::roughnessOfShininess(material.shininess);
    material.shininess = world::shininessOfRoughness(std::clamp(before + amount, 0.05F, 1.0F));
  }
  material.roughness = std::clamp(material.roughness + amount, 0.05F, 1.0F);
}

/// Replaces a material's colour, adjusting its ambient colour to match.
void recolour(const Eigen::Vector3f& colour, world::Material& material) {
  for (int i = 0; i < 3; ++i) {
    constexpr float kDark = 0.02F;
    const float before = material.diffuse[i];
    material.diffuse[i] = std::clamp(colour[i], 0.0F, 1.0F);
    material.ambient[i] = before > kDark
                              ? std::min(material.ambient[i] / before * material.diffuse[i], 1.0F)
                              : material.diffuse[i];
  }
  material.is_default = false;
}

void paint(const PaintedModel& painted, const VariantPaint& paint, base::RandomSource& random,
           world::Model& model) {
  for (const PaintCanvas& canvas : painted.canvases) {
    auto texture = std::make_shared<world::Texture>();
    const world::Surface& first = surfaceOf(model, painted.parts.surfaces[canvas.surfaces.front()]);
    texture->file = first.material.texture->file;
    texture->pixels = repainted(canvas, painted, paint, random);
    for (const std::size_t i : canvas.surfaces) {
      world::Material& material = surfaceOf(model, painted.parts.surfaces[i]).material;
      setTexture(texture, material);
      roughen(paint.roughness, material);
    }
  }
  for (const std::size_t i : painted.untextured) {
    world::Material& material = surfaceOf(model, painted.parts.surfaces[i]).material;
    recolour(repainted(Eigen::Vector3f(material.diffuse.head<3>()), painted, paint), material);
    roughen(paint.roughness, material);
  }
}

}  // namespace

ObjectVariety::ObjectVariety(const world::Model& model, Variety variety, std::uint64_t seed)
    : model_(std::make_unique<world::Model>(model)),
      variety_(variety),
      seed_(seed),
      painted_(std::make_unique<PaintedModel>(model)) {}

ObjectVariety::~ObjectVariety() = default;
ObjectVariety::ObjectVariety(ObjectVariety&&) noexcept = default;

VariedModel ObjectVariety::variant(int number) const {
  if (number == 0 || painted_->parts.box_M.isEmpty()) return {*model_, std::nullopt};
  base::RandomSource of_paint(seed_, number, "randomize/variety/paint");
  VariedModel result{painted_->model, std::nullopt};
  const VariantPaint drawn = drawPaint(*painted_, variety_, of_paint);
  paint(*painted_, drawn, of_paint, result.model);
  if (variety_ == Variety::kSameClass) {
    base::RandomSource of_shape(seed_, number, "randomize/variety/shape");
    result.shape.emplace(painted_->parts, painted_->levels, of_shape);
    result.shape->apply(painted_->parts, result.model);
  }
  return result;
}

}  // namespace synthetic_dataset::randomize
