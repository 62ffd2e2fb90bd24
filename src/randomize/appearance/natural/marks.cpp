#include "randomize/appearance/natural/marks.h"

#include <algorithm>
#include <cmath>

#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {

void drawTurn(base::RandomSource& random, double& x, double& y) {
  double length = 0.0;
  while (length < 0.01 || length > 1.0) {
    x = random.uniform(-1.0, 1.0);
    y = random.uniform(-1.0, 1.0);
    length = x * x + y * y;
  }
  length = std::sqrt(length);
  x /= length;
  y /= length;
}

void addStone(Surface& surface, const Stone& stone) {
  const double across = stone.radius;
  const double along = std::max(0.5, stone.radius * stone.flat);
  const int reach = static_cast<int>(std::ceil(across));
  for (int y = -reach; y <= reach; ++y) {
    // The span within the ellipse: a x^2 + 2 b x + c <= 1.
    const double ux = stone.turn_x / across;
    const double uy = stone.turn_y * y / across;
    const double vx = -stone.turn_y / along;
    const double vy = stone.turn_x * y / along;
    const double a = ux * ux + vx * vx;
    const double b = ux * uy + vx * vy;
    const double c = uy * uy + vy * vy;
    const double root = b * b - a * (c - 1.0);
    if (root <= 0.0) continue;
    const double half = std::sqrt(root);
    const int first = static_cast<int>(std::ceil((-b - half) / a));
    const int last = static_cast<int>(std::floor((-b + half) / a));
    // 0 in the middle, 1 at the rim; the step grows linearly.
    double square = a * first * first + 2.0 * b * first + c;
    double step = a * (2 * first + 1) + 2.0 * b;
    for (int x = first; x <= last; ++x, square += step, step += 2.0 * a) {
      const std::size_t i = surface.index(stone.x + x, stone.y + y);
      const int rim = static_cast<int>(256.0 * square * square);
      surface.tone[i] =
          static_cast<std::uint8_t>(std::clamp(stone.tone - (stone.shade * rim >> 8), 0, 255));
      surface.height[i] =
          static_cast<std::uint8_t>(std::clamp(60 + (stone.height * (256 - rim) >> 8), 0, 255));
    }
  }
}

void addBlock(Surface& surface, const Block& block, int tone) {
  for (int y = block.y; y < block.y + block.height; ++y) {
    for (int x = block.x; x < block.x + block.width; ++x) {
      surface.tone[surface.index(x, y)] = static_cast<std::uint8_t>(tone);
    }
  }
}

void addCrack(Surface& surface, base::RandomSource& random, int length) {
  double x = below(random, surface.side);
  double y = below(random, surface.side);
  double way_x = 1.0;
  double way_y = 0.0;
  drawTurn(random, way_x, way_y);
  for (int i = 0; i < length; ++i) {
    const std::size_t place = surface.index(static_cast<int>(x) + 4 * surface.side,
                                            static_cast<int>(y) + 4 * surface.side);
    surface.tone[place] = static_cast<std::uint8_t>(surface.tone[place] / 3);
    surface.height[place] = 0;
    const double bend = random.uniform(-0.5, 0.5);
    const double turned_x = way_x - bend * way_y;
    const double turned_y = way_y + bend * way_x;
    const double norm = std::sqrt(turned_x * turned_x + turned_y * turned_y);
    way_x = turned_x / norm;
    way_y = turned_y / norm;
    x += 0.8 * way_x;
    y += 0.8 * way_y;
  }
}

void addSpecks(Surface& surface, base::RandomSource& random, int count, int tone, int spread) {
  for (int i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(below(random, surface.side * surface.side));
    const int speck = std::clamp(tone + between(random, -spread, spread), 0, 255);
    surface.tone[place] = static_cast<std::uint8_t>(speck);
  }
}

}  // namespace synthetic_dataset::randomize::natural
