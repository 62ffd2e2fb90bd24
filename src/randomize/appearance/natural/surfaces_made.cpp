#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "randomize/appearance/natural/cells.h"
#include "randomize/appearance/natural/marks.h"
#include "randomize/appearance/natural/noise_table.h"
#include "randomize/appearance/natural/quick_draws.h"
#include "randomize/appearance/natural/surfaces.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// Stripes of a cloth: one of a few tones for each place along its side.
std::vector<int> drawBands(base::RandomSource& random, int side, int tones) {
  const int period = side >> between(random, 0, 3);
  std::vector<int> band;
  while (static_cast<int>(band.size()) < period) {
    const int tone = below(random, tones);
    const int width = between(random, 1, 1 + period / 5);
    band.insert(band.end(), static_cast<std::size_t>(width), tone);
  }
  std::vector<int> bands;
  for (int i = 0; i < side; ++i) bands.push_back(band[static_cast<std::size_t>(i % period)]);
  return bands;
}

/// Adds a line of text: words of marks as wide as letters.
void addText(Surface& surface, base::RandomSource& random, const Block& line, int tone) {
  const int letter = std::max(2, line.height * 2 / 3);
  int x = line.x;
  while (x + letter <= line.x + line.width) {
    if (chance(random, 0.16)) {  // gap between words
      x += letter;
      continue;
    }
    const int stem = std::max(1, line.height / 5);
    const auto strokes = static_cast<unsigned>(between(random, 1, 31));
    const int wide = std::max(1, letter - stem);
    const int middle = line.y + (line.height - stem) / 2;
    const int low = line.y + line.height - stem;
    if ((strokes & 1U) != 0U) addBlock(surface, {x, line.y, stem, line.height}, tone);
    if ((strokes & 2U) != 0U) addBlock(surface, {x + wide - stem, line.y, stem, line.height}, tone);
    if ((strokes & 4U) != 0U) addBlock(surface, {x, line.y, wide, stem}, tone);
    if ((strokes & 8U) != 0U) addBlock(surface, {x, middle, wide, stem}, tone);
    if ((strokes & 16U) != 0U) addBlock(surface, {x, low, wide, stem}, tone);
    x += letter;
  }
}

void addParagraph(Surface& surface, base::RandomSource& random, const Block& area, int tone) {
  const int height = std::max(3, surface.side / between(random, 24, 80));
  for (int y = area.y; y + height <= area.y + area.height; y += height + height * 2 / 3) {
    const int width = chance(random, 0.2) ? area.width / 2 : area.width;
    addText(surface, random, {area.x, y, width, height}, tone);
  }
}

void addBars(Surface& surface, base::RandomSource& random, const Block& area, int tone) {
  for (int x = area.x; x < area.x + area.width;) {
    const int width = between(random, 1, std::max(2, area.width / 24));
    if (chance(random, 0.5)) addBlock(surface, {x, area.y, width, area.height}, tone);
    x += width;
  }
}

void addLogo(Surface& surface, base::RandomSource& random, const Block& area) {
  Stone disc;
  disc.shade = 0;
  for (int i = between(random, 1, 4); i > 0; --i) {
    disc.radius = std::max(2, std::min(area.width, area.height) * i / 9);
    disc.x = area.x + area.width / 2;
    disc.y = area.y + area.height / 2;
    disc.flat = chance(random, 0.6) ? 1.0 : random.uniform(0.2, 1.0);
    drawTurn(random, disc.turn_x, disc.turn_y);
    disc.tone = 32 * below(random, 8) + 16;
    addStone(surface, disc);
  }
}

/// Adds a photograph on paper: smooth, with few colours.
void addPicture(Surface& surface, base::RandomSource& random, const Block& area) {
  const NoiseTable& table = noise(Waves::kBroad);
  const int shift = below(random, NoiseTable::kSide);
  const int first = 64 * between(random, 1, 3);  // two colours and their shades
  for (int y = 0; y < area.height; ++y) {
    for (int x = 0; x < area.width; ++x) {
      const int value = 128 + table.at(2 * x + shift, 2 * y) + y * 60 / area.height;
      surface.tone[surface.index(area.x + x, area.y + y)] =
          static_cast<std::uint8_t>(first + std::clamp(value / 4, 0, 63));
    }
  }
}

}  // namespace

Surface wood(base::RandomSource& random, int bits) {
  Surface surface(bits);
  Laying laying;
  laying.rows = chance(random, 0.3) ? 1 : between(random, 2, 9);
  laying.columns = laying.rows == 1 ? 1 : between(random, 1, 3);
  laying.is_random = true;
  laying.joint = laying.rows == 1 ? 0 : 1;
  const Cells cells(surface, laying, random);
  const SurfaceNoise streaks(surface, Waves::kStreaks);
  const int rings = between(random, 0, 5);
  const int spread = between(random, 20, 120);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
    const CellPlace place = cells.at(x, y);
    const int offset = static_cast<int>(place.hash & 511U);
    const int grain = streaks.at(x, y, offset, offset * 3);
    const int ring = (grain * rings + 4096) & 127;
    const int own = static_cast<int>((place.hash >> 16U) & 255U) - 128;
    const bool is_joint = place.border < 0 && laying.joint > 0;
    tone = asByte(is_joint ? 10 : 108 + grain / 2 + std::abs(ring - 64) + own * spread / 256);
    height = asByte(is_joint ? 40 : 120 + grain / 4);
  });
  const double draw = random.unit();
  const Colour colour = drawColour(random, draw < 0.7    ? Hues::kEarth
                                           : draw < 0.85 ? Hues::kDry
                                                         : Hues::kGrey);
  addRamp(surface.palette, 0, 255, lit(colour, between(random, 60, 150)), lit(colour, 360));
  surface.bump = between(random, 2, 8);
  surface.stains = between(random, 5, 40);
  return surface;
}

Surface cloth(base::RandomSource& random, int bits) {
  Surface surface(bits);
  const int tones = between(random, 1, 4);
  const std::vector<int> across = drawBands(random, surface.side, tones);
  const std::vector<int> along = chance(random, 0.5)
                                     ? drawBands(random, surface.side, tones)
                                     : std::vector<int>(static_cast<std::size_t>(surface.side), 0);
  const int thread = between(random, 1, 3);  // log2 of its width [px]
  const SurfaceNoise folds(surface, Waves::kBroad);
  const int shift = below(random, NoiseTable::kSide);
  const int depth = between(random, 0, 3);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
    const bool is_above = (((x >> thread) + (y >> thread)) & 1) != 0;
    const int slot =
        is_above ? across[static_cast<std::size_t>(x)] : along[static_cast<std::size_t>(y)];
    const int inside = (is_above ? y : x) & ((1 << thread) - 1);
    const int weave = 2 * inside < (1 << thread) ? 8 : -4;
    tone = asByte(64 * slot + 28 + weave + (is_above ? 8 : -8));
    height = asByte(128 + folds.at(x, y, shift) * depth / 2 + (is_above ? 3 : 0));
  });
  for (int slot = 0; slot < 4; ++slot) {
    addShades(surface.palette, 64 * slot, 64 * slot + 63, drawAnyColour(random), 120);
  }
  surface.bump = between(random, 4, 12);
  return surface;
}

Surface metal(base::RandomSource& random, int bits) {
  Surface surface(bits);
  const SurfaceNoise streaks(surface, Waves::kStreaks);
  const SurfaceNoise patches(surface, Waves::kBroad);
  const int shift = below(random, NoiseTable::kSide);
  const int waves = chance(random, 0.4) ? surface.side >> between(random, 2, 4) : 0;
  const int rust = chance(random, 0.45) ? between(random, 10, 80) : 200;
  Laying laying;
  laying.rows = between(random, 1, 4);
  laying.columns = between(random, 1, 4);
  const bool has_plates = waves == 0 && chance(random, 0.5);
  const Cells cells(surface, laying, random);
  forEachPixel(surface, [&](int x, int y, std::uint8_t& tone, std::uint8_t& height) {
    const int streak = streaks.at(x, y, shift);
    const int patch = patches.at(x, y, 0, shift) + streak / 4;
    int above = 100 + streak / 10;
    if (waves > 0) above += 2 * std::abs((x % waves) * 64 / waves - 32);
    if (has_plates && cells.at(x, y).border < 0) above = 20;
    const bool is_rusty = patch > rust;
    tone = asByte(is_rusty ? std::max(176, 220 + (patch - rust) / 3 - streak / 3)
                           : std::min(175, 90 + streak / 4));
    height = asByte(above + (is_rusty ? streak / 6 : 0));
  });
  const Colour colour =
      chance(random, 0.55) ? drawColour(random, Hues::kGrey) : drawAnyColour(random);
  addShades(surface.palette, 0, 175, colour, 80);
  addRamp(surface.palette, 176, 255, lit(drawColour(random, Hues::kBrick), 130),
          drawColour(random, Hues::kEarth));
  surface.bump = between(random, 5, 16);
  surface.stains = between(random, 5, 40);
  return surface;
}

Surface print(base::RandomSource& random, int bits) {
  Surface surface(bits);
  const int side = surface.side;
  addBlock(surface, {0, 0, side, side}, 16);
  const int columns = between(random, 1, 3);
  const int margin = side / between(random, 16, 32);
  const int width = (side - margin) / columns - margin;
  for (int column = 0; column < columns; ++column) {
    int y = margin;
    while (y < side - 2 * margin) {
      const int height = std::min(side - margin - y, side / between(random, 3, 12));
      const Block area{margin + column * (width + margin), y, width, height};
      const int tone = 32 * between(random, 1, 7) + 16;
      const double draw = random.unit();
      if (draw < 0.35) {
        addParagraph(surface, random, area, chance(random, 0.8) ? 48 : tone);
      } else if (draw < 0.5) {
        addText(surface, random, {area.x, area.y, area.width, std::max(4, area.height / 2)}, tone);
      } else if (draw < 0.65) {
        addPicture(surface, random, area);
      } else if (draw < 0.75) {
        addBlock(surface, area, tone);
        addText(surface, random,
                {area.x + 4, area.y + area.height / 4, area.width - 8, area.height / 2}, 16);
      } else if (draw < 0.85) {
        addLogo(surface, random, area);
      } else if (draw < 0.92) {
        addBars(surface, random, area, 48);
      }
      y += height + margin / 2 + 1;
    }
  }
  std::fill(surface.height.begin(), surface.height.end(), std::uint8_t{128});
  const bool is_dark = chance(random, 0.2);
  const Colour paper =
      chance(random, 0.6) ? drawColour(random, Hues::kCream) : drawAnyColour(random);
  const Colour ink = drawColour(random, is_dark ? Hues::kCream : Hues::kDark);
  addShades(surface.palette, 0, 31, is_dark ? lit(paper, 70) : paper, 20);
  addShades(surface.palette, 32, 63, ink, 20);
  for (int slot = 2; slot < 8; ++slot) {
    const Colour colour =
        chance(random, 0.4) ? drawColour(random, Hues::kVivid) : drawAnyColour(random);
    addShades(surface.palette, 32 * slot, 32 * slot + 31, colour, 50);
  }
  surface.bump = 0;
  surface.stains = between(random, 2, 20);
  return surface;
}

/// Dead leaves model (Lee, Mumford and Huang 2001): shapes that occlude one another, whose sizes
/// follow a power law with the third power.
Surface leaves(base::RandomSource& random, int bits) {
  Surface surface(bits);
  const double least = surface.side / 100.0;
  const double most = surface.side / 3.0;
  const double ends = 1.0 - least * least / (most * most);
  double area = 3.0 * surface.side * surface.side;
  Stone leaf;
  while (area > 0.0) {
    leaf.x = below(random, surface.side);
    leaf.y = below(random, surface.side);
    leaf.radius = least / std::sqrt(1.0 - ends * random.unit());
    leaf.flat = chance(random, 0.4) ? 1.0 : random.uniform(0.15, 1.0);
    drawTurn(random, leaf.turn_x, leaf.turn_y);
    leaf.tone = 16 * below(random, 16) + 15;
    leaf.shade = below(random, 14);
    if (chance(random, 0.5)) {
      addStone(surface, leaf);
    } else {
      const int wide = static_cast<int>(2.0 * leaf.radius);
      const int high = std::max(1, static_cast<int>(2.0 * leaf.radius * leaf.flat));
      addBlock(surface, {leaf.x, leaf.y, wide, high}, leaf.tone - leaf.shade);
    }
    area -= 3.5 * leaf.radius * leaf.radius * leaf.flat;
  }
  for (int slot = 0; slot < 16; ++slot) {
    const Colour colour = drawAnyColour(random);
    addRamp(surface.palette, 16 * slot, 16 * slot + 15, lit(colour, 140), colour);
  }
  surface.bump = between(random, 2, 10);
  return surface;
}

}  // namespace synthetic_dataset::randomize::natural
