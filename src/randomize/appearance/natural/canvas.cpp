#include "randomize/appearance/natural/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "randomize/appearance/natural/noise_table.h"
#include "randomize/appearance/natural/paint_pixel.h"
#include "randomize/appearance/natural/quick_draws.h"

namespace synthetic_dataset::randomize::natural {
namespace {

/// Paints a row from `left` to `right`; the pixels at both ends in proportion to their coverage.
void paintBetween(const RowPainter& painter, cv::Vec4b* row, int width, double left, double right) {
  const double low = std::max(0.0, left);
  const double high = std::min(static_cast<double>(width), right);
  if (high <= low) return;
  int first = static_cast<int>(low);
  int last = static_cast<int>(high);
  const auto light = [&](int x) { return painter.lightAt(x); };
  if (first == last) {
    painter.put(row[first], first, light(first), static_cast<int>(256.0 * (high - low)));
    return;
  }
  if (low > first) {
    painter.put(row[first], first, light(first), static_cast<int>(256.0 * (first + 1 - low)));
    ++first;
  }
  if (last < width) {
    painter.put(row[last], last, light(last), static_cast<int>(256.0 * (high - last)));
  }
  painter.putSpan(row, first, last - 1);
}

/// Steps along a row, giving the square of the distance from a middle; 256 at the radius.
class Walk {
 public:
  Walk(int first, double middle, double radius)
      : place_(static_cast<std::int64_t>(65536.0 * (first + 0.5 - middle) / radius)),
        step_(static_cast<std::int64_t>(65536.0 / radius)) {}

  [[nodiscard]] int next() {
    const std::int64_t place = place_ >> 4;
    place_ += step_;
    return static_cast<int>(place * place >> 16);
  }

 private:
  std::int64_t place_;
  std::int64_t step_;
};

}  // namespace

Paint paintOf(const Tile& tile, base::RandomSource& random, double scale, const Point& turn) {
  const auto fixed = [](double places) {
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(places * 65536.0));
  };
  Paint paint;
  paint.tile = &tile;
  paint.level = levelOf(tile, scale);
  paint.u = static_cast<std::uint32_t>(random.bits());
  paint.v = static_cast<std::uint32_t>(random.bits());
  paint.u_x = fixed(scale * turn.x);
  paint.v_x = fixed(-scale * turn.y);
  paint.u_y = fixed(scale * turn.y);
  paint.v_y = fixed(scale * turn.x);
  return paint;
}

void fillPolygon(Canvas& canvas, const std::vector<Point>& points, const Paint& paint) {
  double top = points.front().y;
  double bottom = top;
  for (const Point& point : points) {
    top = std::min(top, point.y);
    bottom = std::max(bottom, point.y);
  }
  const int first = static_cast<int>(std::ceil(std::max(0.0, top) - 0.5));
  const int last = static_cast<int>(std::ceil(std::min<double>(canvas.rows, bottom) - 0.5)) - 1;
  RowPainter painter(paint);
  std::array<double, 64> crossings{};
  for (int y = std::max(0, first); y <= last; ++y) {
    const double height = y + 0.5;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Point& a = points[i];
      const Point& b = points[i + 1 == points.size() ? 0 : i + 1];
      if ((a.y <= height) == (b.y <= height) || count == crossings.size()) continue;
      crossings[count++] = a.x + (b.x - a.x) * ((height - a.y) / (b.y - a.y));
    }
    std::sort(crossings.begin(), crossings.begin() + static_cast<std::ptrdiff_t>(count));
    painter.startRow(y);
    for (std::size_t i = 0; i + 1 < count; i += 2) {
      paintBetween(painter, canvas[y], canvas.cols, crossings[i], crossings[i + 1]);
    }
  }
}

void fillRectangle(Canvas& canvas, const Point& low, const Point& high, const Paint& paint) {
  fillPolygon(canvas, {low, {high.x, low.y}, high, {low.x, high.y}}, paint);
}

void fillLine(Canvas& canvas, const Point& from, const Point& to, double width_from,
              double width_to, const Paint& paint) {
  const double x = to.x - from.x;
  const double y = to.y - from.y;
  const double length = std::sqrt(x * x + y * y);
  if (length < 1e-3) return;
  const Point side{-0.5 * y / length, 0.5 * x / length};
  fillPolygon(canvas,
              {{from.x + side.x * width_from, from.y + side.y * width_from},
               {to.x + side.x * width_to, to.y + side.y * width_to},
               {to.x - side.x * width_to, to.y - side.y * width_to},
               {from.x - side.x * width_from, from.y - side.y * width_from}},
              paint);
}

void fillEllipse(Canvas& canvas, const Point& middle, double wide, double high, const Paint& paint,
                 const Point& turn) {
  const double ax = turn.x / wide;
  const double bx = -turn.y / high;
  const double reach = std::sqrt(wide * wide * turn.y * turn.y + high * high * turn.x * turn.x);
  const int first = std::max(0, static_cast<int>(std::ceil(middle.y - reach - 0.5)));
  const int last = std::min(canvas.rows - 1, static_cast<int>(middle.y + reach));
  RowPainter painter(paint);
  for (int y = first; y <= last; ++y) {
    const double dy = y + 0.5 - middle.y;
    const double ay = turn.y * dy / wide;
    const double by = turn.x * dy / high;
    const double a = ax * ax + bx * bx;
    const double b = ax * ay + bx * by;
    const double root = b * b - a * (ay * ay + by * by - 1.0);
    if (root <= 0.0) continue;
    const double half = std::sqrt(root);
    painter.startRow(y);
    paintBetween(painter, canvas[y], canvas.cols, middle.x + (-b - half) / a,
                 middle.x + (-b + half) / a);
  }
}

void fillBlob(Canvas& canvas, const Blob& blob, const Paint& paint) {
  const double reach = 1.0 + blob.ragged / 256.0;
  const int left = std::max(0, static_cast<int>(blob.middle.x - reach * blob.wide));
  const int right = std::min(canvas.cols, static_cast<int>(blob.middle.x + reach * blob.wide) + 1);
  const int top = std::max(0, static_cast<int>(blob.middle.y - reach * blob.high));
  const int bottom = std::min(canvas.rows, static_cast<int>(blob.middle.y + reach * blob.high) + 1);
  const NoiseTable& edge = noise(Waves::kMedium);
  const bool is_coarse = blob.zoom >= 200;  // otherwise single noise places would be visible
  RowPainter painter(paint);
  for (int y = top; y < bottom; ++y) {
    painter.startRow(y);
    const double dy = (y + 0.5 - blob.middle.y) / blob.high;
    const int of_row = 256 - static_cast<int>(256.0 * dy * dy);
    if (of_row + (127 * blob.ragged >> 6) <= 0) continue;
    const int row = y * blob.zoom + 256 * blob.shift;
    Walk walk(left, blob.middle.x, blob.wide);
    cv::Vec4b* pixels = canvas[y];
    for (int x = left; x < right; ++x) {
      const int square = walk.next();
      if (of_row - square + (127 * blob.ragged >> 6) <= 0) continue;
      const int column = x * blob.zoom + 1792 * blob.shift;
      const int value = is_coarse ? edge.at(column >> 8, row >> 8) : edge.smoothAt(column, row);
      const int inside = of_row - square + (value * blob.ragged >> 6);
      if (inside <= 0) continue;
      const int light = painter.lightAt(x) + (value * blob.clumps >> 8);
      painter.put(pixels[x], x, light, std::min(256, inside * 8));
    }
  }
}

void addHaze(Canvas& canvas, const Point& middle, double wide, double high, const Colour& colour,
             int opacity) {
  const int left = std::max(0, static_cast<int>(middle.x - wide));
  const int right = std::min(canvas.cols, static_cast<int>(middle.x + wide) + 1);
  const int top = std::max(0, static_cast<int>(middle.y - high));
  const int bottom = std::min(canvas.rows, static_cast<int>(middle.y + high) + 1);
  const Lanes lanes = lanesOf(colour);
  for (int y = top; y < bottom; ++y) {
    const double dy = (y + 0.5 - middle.y) / high;
    const int of_row = 256 - static_cast<int>(256.0 * dy * dy);
    Walk walk(left, middle.x, wide);
    cv::Vec4b* pixels = canvas[y];
    for (int x = left; x < right; ++x) {
      const int inside = of_row - walk.next();
      if (inside <= 0) continue;
      const int share = (inside * inside >> 8) * opacity >> 8;
      setPixel(pixels[x], mixedLanes(lanesOf(pixels[x]), lanes, share));
    }
  }
}

}  // namespace synthetic_dataset::randomize::natural
