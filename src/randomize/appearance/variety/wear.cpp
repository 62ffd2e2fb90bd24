#include "randomize/appearance/variety/wear.h"

namespace synthetic_dataset::randomize {
namespace {

float risingFrom(float low, float high, float value) {
  const float t = std::clamp((value - low) / (high - low), 0.0F, 1.0F);
  return t * t * (3.0F - 2.0F * t);
}

}  // namespace

Wear drawWear(base::RandomSource& random, double strength) {
  const auto draw = [&](double low, double high) {
    return static_cast<float>(random.uniform(low, high));
  };
  const double age = strength * std::pow(random.unit(), 1.6);
  const auto amount = [&](double most) { return draw(0.0, most * age); };
  Wear wear;
  wear.fading = amount(0.7);
  wear.dirt = amount(0.85);
  // From grey dust to brown soil.
  const float lightness = draw(0.15, 0.5);
  const float brown = draw(0.0, 0.35);
  wear.dirt_colour = lightness * Eigen::Vector3f(1.0F + 0.5F * brown, 1.0F, 1.0F - brown);
  wear.splashes = draw(0.0, 0.9);
  wear.scuffs = amount(0.9);
  wear.scuff_lightness = draw(0.0, 1.0) < 0.6F ? draw(0.6, 0.9) : draw(0.05, 0.25);
  wear.streaks = amount(0.8);
  wear.scratches = static_cast<int>(amount(90.0));
  for (int i = 0; i < 3; ++i) wear.offset[i] = static_cast<float>(random.unit());
  return wear;
}

void Wear::apply(Eigen::Vector3f& colour, const Eigen::Vector3f& place, float height,
                 const SolidNoise& noise) const {
  const float blotches = noise.at(1.3F * place + offset);
  const float grain = noise.at(5.1F * place + offset);
  // Sunlight bleaches: towards a paler grey of about the same lightness.
  const float pale = 0.75F * lightnessOf(colour) + 0.2F;
  colour += fading * (0.4F + 0.6F * blotches) * (Eigen::Vector3f::Constant(pale) - colour);
  if (scuffs > 0.0F) {
    const float where =
        noise.at(Eigen::Vector3f(2.9F * place.x(), 2.9F * place.y(), 5.0F * place.z()) + offset);
    const float bare = risingFrom(0.96F - 0.28F * scuffs, 1.0F, 0.75F * where + 0.25F * grain);
    const float grey = 0.7F * scuff_lightness + 0.3F * lightnessOf(colour);
    colour += 0.85F * bare * (Eigen::Vector3f::Constant(grey) - colour);
  }
  if (streaks > 0.0F) {
    const float where =
        noise.at(Eigen::Vector3f(4.7F * place.x(), 4.7F * place.y(), 0.35F * place.z()) + offset);
    const float wet = risingFrom(0.62F, 0.95F, where) * (0.5F + 0.5F * grain);
    colour += 0.7F * streaks * wet * (0.6F * dirt_colour - colour);
  }
  const float low = (1.0F - height) * (1.0F - height);
  const float muck = 0.55F * blotches + 0.45F * grain + splashes * low;
  const float limit = 1.1F - 0.75F * dirt;
  const float covered = std::min(3.0F * dirt, 1.0F) * (0.35F + 0.5F * dirt) *
                        risingFrom(limit - 0.25F, limit + 0.3F, muck);
  const Eigen::Vector3f soiled = dirt_colour * (0.75F + 0.5F * grain);
  colour += covered * (soiled - colour);
}

}  // namespace synthetic_dataset::randomize
