#include <algorithm>
#include <cmath>

#include "randomize/appearance/natural/marks.h"
#include "randomize/appearance/natural/noise_table.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/surfaces.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// Adds noise for the soil below whatever grows or lies on it.
void soilUnder(Surface& surface, base::RandomSource& random, int tone) {
  const SurfaceNoise rough(surface, Waves::kMedium);
  const int shift = below(random, NoiseTable::kSide);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& own_tone, std::uint8_t& height) {
    const int value = rough.at(x, y, shift);
    own_tone = asByte(tone + value / 3);
    height = asByte(40 + value / 8);
  });
}

Hues plantHues(base::RandomSource& random) {
  const double draw = random.unit();
  return draw < 0.65 ? Hues::kGreen : draw < 0.85 ? Hues::kDry : Hues::kEarth;
}

}  // namespace

Surface grass(base::RandomSource& random, int bits) {
  Surface surface(bits);
  soilUnder(surface, random, 50);
  const int longest = surface.side / between(random, 16, 40);
  const int lean = between(random, -60, 60);
  const int count = surface.side * surface.side / between(random, 24, 44);
  const SurfaceNoise clumps(surface, Waves::kBroad);
  for (int i = 0; i < count; ++i) {
    const int x = below(random, surface.side);
    const int y = below(random, surface.side);
    const int tilt = lean + between(random, -200, 200);
    const int length = between(random, longest / 3 + 1, longest);
    const int clump = clumps.at(x, y);
    const int tone = std::clamp(between(random, 60, 230) + clump / 2, 40, 255);
    for (int j = 0; j < length; ++j) {
      const std::size_t place = surface.index(x + tilt * j / 256, y - j);
      const int shade = tone * (length + 2 * j) / (3 * length);
      surface.tone[place] = static_cast<std::uint8_t>(shade);
      surface.height[place] = static_cast<std::uint8_t>(tone / 2 + 40);
    }
  }
  const Hues hues = plantHues(random);
  const Colour soil = drawColour(random, Hues::kEarth);
  const Colour blade = drawColour(random, hues);
  addRamp(surface.palette, 0, 90, lit(soil, 120), lit(blade, 200));
  addRamp(surface.palette, 90, 255, lit(blade, 200),
          mixed(lit(blade, 340), drawColour(random, Hues::kDry), 90));
  surface.bump = between(random, 3, 8);
  surface.stains = between(random, 10, 60);
  return surface;
}

Surface foliage(base::RandomSource& random, int bits) {
  Surface surface(bits);
  soilUnder(surface, random, 20);
  const double size = surface.side / random.uniform(18.0, 50.0);
  const double flat = random.uniform(0.3, 0.7);
  const double reach = size * size * flat * 2.2;
  const int count = static_cast<int>(surface.side * surface.side / reach);
  Stone leaf;
  leaf.height = 60;
  for (int i = 0; i < count; ++i) {
    leaf.x = below(random, surface.side);
    leaf.y = below(random, surface.side);
    leaf.radius = size * random.uniform(0.5, 1.1);
    leaf.flat = flat;
    drawTurn(random, leaf.turn_x, leaf.turn_y);
    leaf.tone = 40 + 120 * i / count + below(random, 90);  // leaves on top receive more light
    leaf.shade = 30;
    addStone(surface, leaf);
  }
  const Hues hues = plantHues(random);
  const Colour green = drawColour(random, hues);
  addRamp(surface.palette, 0, 120, lit(green, 40), green);
  addRamp(
      surface.palette, 120, 255, green,
      mixed(lit(green, 380), drawColour(random, chance(random, 0.8) ? hues : Hues::kVivid), 80));
  surface.bump = between(random, 4, 14);
  return surface;
}

Surface gravel(base::RandomSource& random, int bits) {
  Surface surface(bits);
  soilUnder(surface, random, 50);
  // Power-law sizes, as for things that are broken again and again.
  const double least = surface.side / random.uniform(90.0, 180.0);
  const double most = least * random.uniform(2.5, 12.0);
  const double ends = 1.0 - least * least / (most * most);
  double area = 1.6 * surface.side * surface.side;
  Stone stone;
  while (area > 0.0) {
    stone.x = below(random, surface.side);
    stone.y = below(random, surface.side);
    stone.radius = least / std::sqrt(1.0 - ends * random.unit());
    stone.flat = random.uniform(0.5, 1.0);
    drawTurn(random, stone.turn_x, stone.turn_y);
    stone.tone = between(random, 90, 250);
    stone.shade = 60;
    addStone(surface, stone);
    area -= 3.14159 * stone.radius * stone.radius * stone.flat;
  }
  const Hues hues = chance(random, 0.6) ? Hues::kGrey : Hues::kEarth;
  const Colour dark = drawColour(random, hues);
  addRamp(surface.palette, 0, 110, lit(dark, 80), dark);
  addRamp(surface.palette, 110, 255, dark,
          drawColour(random, chance(random, 0.5) ? Hues::kCream : hues));
  surface.bump = between(random, 6, 20);
  return surface;
}

Surface rock(base::RandomSource& random, int bits) {
  Surface surface(bits);
  const NoiseTable& ridges = noise(chance(random, 0.6) ? Waves::kBroad : Waves::kMedium);
  const SurfaceNoise rough(surface, Waves::kMedium);
  const int step = surface.noiseStep();
  const int shift = below(random, NoiseTable::kSide);
  const int warp = between(random, 4, 40);
  const bool has_ridges = chance(random, 0.6);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
    const int moved_x = x * step + rough.at(x, y, 0, shift) * warp / 64;
    const int moved_y = y * step + rough.at(x, y, shift, 77) * warp / 64;
    const int value = ridges.at(moved_x + shift, moved_y);
    const int ridge = has_ridges ? 160 - 2 * std::abs(value) : value;
    const int fine = rough.at(x, y, shift);
    tone = asByte(110 + ridge / 2 + fine / 3);
    height = asByte(128 + ridge / 2 + fine / 4);
  });
  const double draw = random.unit();
  const Hues hues = draw < 0.5 ? Hues::kEarth : draw < 0.8 ? Hues::kGrey : Hues::kDry;
  const Colour colour = drawColour(random, hues);
  addRamp(surface.palette, 0, 150, lit(colour, 90), colour);
  addRamp(surface.palette, 150, 255, colour,
          mixed(lit(colour, 350), drawColour(random, Hues::kCream), 60));
  surface.bump = between(random, 4, 22);
  surface.stains = between(random, 10, 50);
  return surface;
}

Surface bark(base::RandomSource& random, int bits) {
  Surface surface(bits);
  const NoiseTable& streaks = noise(Waves::kStreaks);
  const SurfaceNoise rough(surface, Waves::kFine);
  const int step = surface.noiseStep();
  const int shift = below(random, NoiseTable::kSide);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
    const int moved = x * step + rough.at(x, y, 0, 77) / 8;
    const int streak = streaks.at(y * step, moved + shift);  // along y
    tone = height = asByte(230 - 2 * std::abs(streak) + rough.at(x, y, shift) / 3);
  });
  const Colour colour = drawColour(random, chance(random, 0.7) ? Hues::kEarth : Hues::kGrey);
  addRamp(surface.palette, 0, 255, lit(colour, 70), lit(colour, 330));
  surface.bump = between(random, 3, 10);
  return surface;
}

}  // namespace synthetic_dataset::randomize::natural
