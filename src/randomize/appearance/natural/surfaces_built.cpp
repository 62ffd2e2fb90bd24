#include <algorithm>

#include "randomize/appearance/natural/cells.h"
#include "randomize/appearance/natural/marks.h"
#include "randomize/appearance/natural/noise_table.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/surfaces.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// The look of laid pieces: their tones start at 64; lower ones are for joints.
struct Pieces {
  int spread = 60;               ///< from piece to piece
  int noise = 60;                ///< within a piece
  int bevel = 3;                 ///< width of the rounded edge [px]
  int slope = 38;                ///< gain in height for each pixel
  bool has_two_colours = false;  ///< at random: tones from 160 are the second
};

void lay(Surface& surface, const Laying& laying, const Pieces& pieces, Waves waves,
         base::RandomSource& random) {
  const Cells cells(surface, laying, random);
  const SurfaceNoise table(surface, waves);
  const int shift_x = below(random, NoiseTable::kSide);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
    const CellPlace place = cells.at(x, y);
    if (place.border < 0) {
      tone = asByte(30 + table.at(x, y, 99) / 5);
      height = asByte(40 + table.at(x, y) / 8);
      return;
    }
    // Each piece shows a different part of the noise.
    const int offset = static_cast<int>(place.hash & 255U);
    const int rough = table.at(x, y, shift_x + offset, 2 * offset);
    const int own = static_cast<int>((place.hash >> 8U) & 255U) - 128;
    const int value = (pieces.has_two_colours ? 112 : 160) + (own * pieces.spread >> 8) +
                      (rough * pieces.noise >> 7);
    const bool is_second = pieces.has_two_colours && (place.hash >> 31U) != 0U;
    tone = asByte(std::clamp(value, 64, pieces.has_two_colours ? 159 : 255) + (is_second ? 96 : 0));
    const int edge = std::min(place.border + 1, pieces.bevel + 1);
    height = asByte(40 + pieces.slope * edge + (rough >> 3));
  });
}

/// Fills a surface with noise around a tone.
void roughen(Surface& surface, base::RandomSource& random, Waves waves, int tone, int spread) {
  const SurfaceNoise table(surface, waves);
  const SurfaceNoise grain(surface, Waves::kGrain);
  const int shift_x = below(random, NoiseTable::kSide);
  const int shift_y = below(random, NoiseTable::kSide);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& own_tone, std::uint8_t& height) {
    const int rough = table.at(x, y, shift_x, shift_y);
    const int fine = grain.at(x, y, shift_y, shift_x);
    own_tone = asByte(tone + (rough * spread >> 6) + (fine >> 3));
    height = asByte(128 + (rough >> 2) + (fine >> 1));
  });
}

}  // namespace

Surface brick(base::RandomSource& random, int bits) {
  Surface surface(bits);
  Laying laying;
  laying.rows = 2 * between(random, 3, 8);
  laying.columns = std::max(1, laying.rows / between(random, 2, 4));
  laying.shift = chance(random, 0.8) ? 128 : 85;
  laying.joint = std::max(1, surface.side / laying.rows / between(random, 12, 24));
  laying.wobble = below(random, 3);
  Pieces pieces;
  pieces.spread = between(random, 30, 150);
  pieces.noise = between(random, 20, 80);
  lay(surface, laying, pieces, chance(random, 0.5) ? Waves::kMedium : Waves::kFine, random);
  const Colour mortar = drawColour(random, chance(random, 0.7) ? Hues::kGrey : Hues::kCream);
  addShades(surface.palette, 0, 63, mortar, 50);
  const double draw = random.unit();
  const Hues hues = draw < 0.6    ? Hues::kBrick
                    : draw < 0.75 ? Hues::kEarth
                    : draw < 0.9  ? Hues::kGrey
                                  : Hues::kCream;
  addRamp(surface.palette, 64, 255, lit(drawColour(random, hues), 170),
          drawColour(random, chance(random, 0.8) ? hues : Hues::kEarth));
  surface.bump = between(random, 6, 20);
  surface.stains = between(random, 10, 50);
  return surface;
}

Surface tiles(base::RandomSource& random, int bits) {
  Surface surface(bits);
  Laying laying;
  laying.rows = 2 * between(random, 1, 6);
  laying.columns = chance(random, 0.7) ? laying.rows : std::max(1, laying.rows / 2);
  laying.shift = chance(random, 0.3) ? 128 : 0;
  laying.joint = std::max(1, surface.side / laying.rows / between(random, 16, 50));
  Pieces pieces;
  pieces.spread = chance(random, 0.3) ? between(random, 60, 180) : below(random, 40);
  pieces.noise = between(random, 5, 80);
  pieces.has_two_colours = chance(random, 0.25);
  lay(surface, laying, pieces, chance(random, 0.6) ? Waves::kBroad : Waves::kFine, random);
  const Hues joints[] = {Hues::kDark, Hues::kGrey, Hues::kCream};
  addShades(surface.palette, 0, 63, drawColour(random, joints[below(random, 3)]), 30);
  const Colour colour = drawAnyColour(random);
  if (pieces.has_two_colours) {
    addShades(surface.palette, 64, 159, colour, 70);
    addShades(surface.palette, 160, 255, drawAnyColour(random), 70);
  } else {
    addRamp(surface.palette, 64, 255, lit(colour, 190),
            mixed(lit(colour, 290), drawAnyColour(random), 50));
  }
  surface.bump = between(random, 3, 14);
  surface.stains = between(random, 5, 30);
  return surface;
}

Surface concrete(base::RandomSource& random, int bits) {
  Surface surface(bits);
  const int spread = between(random, 20, 50);
  roughen(surface, random, Waves::kBroad, 128, spread);
  const int area = surface.side * surface.side;
  if (chance(random, 0.6)) addSpecks(surface, random, area / between(random, 60, 600), 40, 30);
  for (int cracks = chance(random, 0.4) ? between(random, 1, 4) : 0; cracks > 0; --cracks) {
    addCrack(surface, random, between(random, surface.side / 4, 2 * surface.side));
  }
  if (chance(random, 0.4)) {  // joints between slabs
    Laying laying;
    laying.rows = between(random, 1, 3);
    laying.columns = between(random, 1, 3);
    laying.joint = 1 + surface.side / 256;
    const Cells cells(surface, laying, random);
    forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
      if (cells.at(x, y).border >= 0) return;
      tone /= 2;
      height = 20;
    });
  }
  const Hues hues = chance(random, 0.75)  ? Hues::kGrey
                    : chance(random, 0.5) ? Hues::kCream
                                          : Hues::kEarth;
  const Colour colour = drawColour(random, hues);
  addShades(surface.palette, 0, 255, colour, between(random, 90, 150));
  surface.bump = between(random, 3, 14);
  surface.stains = between(random, 10, 60);
  return surface;
}

Surface asphalt(base::RandomSource& random, int bits) {
  Surface surface(bits);
  roughen(surface, random, Waves::kFine, 100, 30);
  const int area = surface.side * surface.side;
  addSpecks(surface, random, area / between(random, 4, 12), 130, 70);
  addSpecks(surface, random, area / between(random, 20, 80), 220, 30);
  addSpecks(surface, random, area / between(random, 8, 20), 30, 25);
  for (int cracks = chance(random, 0.35) ? between(random, 1, 6) : 0; cracks > 0; --cracks) {
    addCrack(surface, random, between(random, surface.side / 4, 3 * surface.side));
  }
  const Colour colour = lit(drawColour(random, chance(random, 0.85) ? Hues::kGrey : Hues::kEarth),
                            between(random, 130, 260));
  addShades(surface.palette, 0, 255, colour, between(random, 80, 160));
  surface.bump = between(random, 4, 12);
  surface.stains = between(random, 10, 60);
  return surface;
}

Surface plaster(base::RandomSource& random, int bits) {
  Surface surface(bits);
  roughen(surface, random, chance(random, 0.5) ? Waves::kBroad : Waves::kFine, 150,
          between(random, 2, 24));
  addShades(surface.palette, 0, 255, drawAnyColour(random), between(random, 40, 120));
  if (chance(random, 0.25)) {  // paint that has flaked off in places
    const SurfaceNoise table(surface, Waves::kBroad);
    const int shift = below(random, NoiseTable::kSide);
    const int level = between(random, 50, 90);
    addShades(surface.palette, 0, 63, drawAnyColour(random), 80);
    forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
      const bool is_off = table.at(x, y, shift) > level;
      tone = is_off ? asByte(tone / 4) : std::max<std::uint8_t>(tone, 64);
      if (is_off) height /= 2;
    });
  }
  surface.bump = chance(random, 0.4) ? between(random, 8, 24) : between(random, 1, 6);
  surface.stains = between(random, 5, 50);
  return surface;
}

}  // namespace synthetic_dataset::randomize::natural
