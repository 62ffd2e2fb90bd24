#include "randomize/appearance/natural/things.h"

#include <algorithm>

#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// Draws a branch and those that grow from it.
void addBranches(Canvas& canvas, const Point& from, const Point& way, double width, int depth,
                 const Paint& paint, base::RandomSource& random) {
  const Point to{from.x + way.x, from.y + way.y};
  fillLine(canvas, from, to, width, 0.7 * width, paint);
  if (depth == 0) return;
  const int count = between(random, 2, 3);
  for (int i = 0; i < count; ++i) {
    const double bend = random.uniform(-0.9, 0.9);
    const double length = random.uniform(0.55, 0.85);
    const Point next{length * (way.x - bend * way.y), length * (way.y + bend * way.x)};
    addBranches(canvas, to, next, 0.65 * width, depth - 1, paint, random);
  }
}

void addConifer(Canvas& canvas, const Standing& at, double height, const SceneMaterials& chosen,
                base::RandomSource& random) {
  const Tile& needles = oneOf(chosen.crowns, random);
  const double wide = height * random.uniform(0.16, 0.28);
  for (int i = 0; i < 7; ++i) {
    const double share = i / 7.0;
    Blob blob;
    blob.wide = wide * (1.05 - share);
    blob.high = height * 0.12;
    blob.middle = {at.foot.x, at.foot.y - height * (0.12 + 0.85 * share)};
    blob.ragged = 130;
    blob.zoom = static_cast<int>(std::clamp(256.0 * 100.0 / height, 120.0, 1500.0));
    blob.shift = below(random, 512);
    blob.clumps = 120;
    Paint paint = standingPaint(needles, random, std::clamp(60.0 / height, 0.7, 4.0), at);
    paint.light = 150 + 12 * i;
    paint.light_x = static_cast<int>(at.sun * 256.0 * 60.0 / std::max(4.0, wide));
    fillBlob(canvas, blob, paint);
  }
}

void addCrown(Canvas& canvas, const Standing& at, double height, const SceneMaterials& chosen,
              base::RandomSource& random) {
  const Tile& leaves = oneOf(chosen.crowns, random);
  const double wide = height * random.uniform(0.22, 0.45);
  const double high = height * random.uniform(0.25, 0.36);
  const double middle_y = at.foot.y - height + high;
  const int count = between(random, 5, 9);
  const int zoom =
      static_cast<int>(std::clamp(256.0 * 90.0 / std::max(10.0, height), 90.0, 1024.0));
  for (int i = 0; i < count; ++i) {
    const Point turn = drawnTurn(random);
    const double out = i == 0 ? 0.0 : random.uniform(0.3, 0.75);
    Blob blob;
    blob.middle = {at.foot.x + out * turn.x * wide, middle_y + out * turn.y * high};
    const double size = i == 0 ? 0.8 : random.uniform(0.3, 0.55);
    blob.wide = size * wide;
    blob.high = size * high;
    blob.ragged = 150;
    blob.zoom = zoom;
    blob.shift = below(random, 512);
    blob.clumps = 200;
    Paint paint = standingPaint(leaves, random, std::clamp(70.0 / height, 0.7, 4.0), at);
    const double above = -turn.y * out;  // -1 .. 1
    paint.light =
        i == 0 ? 130 : 190 + static_cast<int>(90.0 * above + 50.0 * at.sun * turn.x * out);
    paint.middle_x = static_cast<int>(blob.middle.x);
    paint.middle_y = static_cast<int>(blob.middle.y);
    paint.light_y = -static_cast<int>(256.0 * 50.0 / std::max(3.0, blob.high));
    fillBlob(canvas, blob, paint);
  }
}

}  // namespace

void addTree(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
             base::RandomSource& random) {
  const double height = at.metre * random.uniform(3.0, 11.0);
  addShadow(canvas, at, 0.3 * height);
  const double draw = random.unit();
  if (draw < 0.2) {
    addConifer(canvas, at, height, chosen, random);
    return;
  }
  Paint paint = standingPaint(oneOf(chosen.trunks, random), random, 1.0, at);
  paint.light = between(random, 130, 230);
  paint.round = 150;
  const double width = std::max(1.2, height * random.uniform(0.03, 0.06));
  if (draw < 0.45) {
    const double lean = random.uniform(-0.06, 0.06);
    addBranches(canvas, at.foot, {lean * height, -0.3 * height}, width,
                std::clamp(static_cast<int>(height / 25.0), 2, 5), paint, random);
    return;
  }
  fillLine(canvas, at.foot,
           {at.foot.x + random.uniform(-0.05, 0.05) * height, at.foot.y - 0.6 * height}, width,
           0.6 * width, paint);
  addCrown(canvas, at, height, chosen, random);
}

void addBush(Canvas& canvas, const Standing& at, const SceneMaterials& chosen,
             base::RandomSource& random) {
  const Tile& leaves = oneOf(chosen.crowns, random);
  const double size = at.metre * random.uniform(0.3, 1.2);
  addShadow(canvas, at, 1.1 * size);
  for (int i = between(random, 1, 4); i > 0; --i) {
    Blob blob;
    blob.wide = size * random.uniform(0.6, 1.2);
    blob.high = size * random.uniform(0.4, 0.9);
    blob.middle = {at.foot.x + size * random.uniform(-0.8, 0.8), at.foot.y - 0.7 * blob.high};
    blob.ragged = 120;
    blob.zoom = static_cast<int>(std::clamp(256.0 * 50.0 / size, 64.0, 1500.0));
    blob.shift = below(random, 512);
    blob.clumps = 160;
    Paint paint = standingPaint(leaves, random, std::clamp(30.0 / size, 0.7, 4.0), at);
    paint.middle_y = static_cast<int>(blob.middle.y);
    paint.light = 200;
    paint.light_y = -static_cast<int>(256.0 * 70.0 / std::max(3.0, blob.high));
    fillBlob(canvas, blob, paint);
  }
}

}  // namespace synthetic_dataset::randomize::natural
