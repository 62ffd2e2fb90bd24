#include "randomize/appearance/variety/paint_canvas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "randomize/appearance/variety/canvas_making.h"
#include "randomize/appearance/variety/flat_index.h"
#include "randomize/appearance/variety/texel_raster.h"
#include "randomize/appearance/variety/textured_triangle.h"

namespace synthetic_dataset::randomize {
namespace {

Eigen::Vector3f colourOf(const cv::Vec4b& pixel) {
  return Eigen::Vector3f(pixel[2], pixel[1], pixel[0]) / 255.0F;
}

/// Caches a result for each colour, with 64 levels per channel.
template <class Result>
class ByColour {
 public:
  template <class Make>
  const Result& get(const cv::Vec4b& pixel, const Make& make) {
    const auto index = static_cast<std::size_t>(((pixel[0] >> 2) << 12) | ((pixel[1] >> 2) << 6) |
                                                (pixel[2] >> 2));
    std::optional<Result>& result = results_[index];
    if (!result) {
      const auto middle = [](std::uint8_t value) { return static_cast<float>(value & ~3) + 1.5F; };
      result = make(Eigen::Vector3f(middle(pixel[2]), middle(pixel[1]), middle(pixel[0])) / 255.0F);
    }
    return *result;
  }

 private:
  std::vector<std::optional<Result>> results_{1U << 18U};
};

/// Extends what is known about texels a little beyond the triangles' edges.
void growOutwards(PaintCanvas& canvas) {
  constexpr int kRounds = 4;
  const int width = canvas.picture.cols;
  const int height = canvas.picture.rows;
  std::vector<std::pair<std::size_t, std::size_t>> copies;  // to, from
  for (int round = 0; round < kRounds; ++round) {
    copies.clear();
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const std::size_t i = flatIndex(row, column, width);
        if (canvas.texels[i].part != PaintCanvas::kNone) continue;
        const auto from = [&](bool is_there, std::size_t other) {
          if (!is_there || canvas.texels[other].part == PaintCanvas::kNone) return false;
          copies.emplace_back(i, other);
          return true;
        };
        const auto row_length = static_cast<std::size_t>(width);
        if (from(column > 0, i - 1) || from(column + 1 < width, i + 1)) continue;
        if (from(row > 0, i - row_length)) continue;
        (void)from(row + 1 < height, i + row_length);
      }
    }
    for (const auto& [to, from] : copies) canvas.texels[to] = canvas.texels[from];
  }
}

}  // namespace

PaintedModel::PaintedModel(const world::Model& original)
    : model([&] {
        world::Model copy = original;
        makeCanvases(copy);
        return copy;
      }()),
      parts(model) {
  if (parts.box_M.isEmpty()) return;
  levels = levelsOf(model, parts);
  ColourCount colours;
  std::map<const world::Texture*, std::size_t> numbers;  // only looked up: their order does not
                                                         // matter
  for (std::size_t i = 0; i < parts.surfaces.size(); ++i) {
    const world::Surface& surface = surfaceOf(model, parts.surfaces[i]);
    if (!isPaintable(surface)) continue;
    if (!surface.material.texture || surface.mesh->texture_coordinates.empty()) {
      untextured.push_back(i);
      continue;
    }
    const auto [entry, is_new] =
        numbers.try_emplace(surface.material.texture.get(), canvases.size());
    if (is_new) canvases.push_back({{}, surface.material.texture->pixels, {}});
    canvases[entry->second].surfaces.push_back(i);
  }
  for (PaintCanvas& canvas : canvases) place(canvas, colours);
  for (const std::size_t i : untextured) {
    const world::Surface& surface = surfaceOf(model, parts.surfaces[i]);
    colours.add(surface.material.diffuse.head<3>(), areaOf(surface, parts.surfaces[i]));
  }
  palette_.emplace(colours);
  for (PaintCanvas& canvas : canvases) {
    classify(canvas);
    smoothBorders(canvas);
  }
  findPatterns();
  for (PaintCanvas& canvas : canvases) growOutwards(canvas);
}

/// Finds the place of each texel, and how much of each colour is visible.
void PaintedModel::place(PaintCanvas& canvas, ColourCount& colours) {
  const cv::Mat& picture = canvas.picture;
  canvas.texels.resize(picture.total());
  const float same = 0.03F * static_cast<float>(parts.box_M.sizes().z());
  std::size_t seen = 0;
  std::size_t shared = 0;
  for (const std::size_t i : canvas.surfaces) {
    const SurfacePart& part = parts.surfaces[i];
    const world::Surface& surface = surfaceOf(model, part);
    const std::vector<std::uint32_t>& indices = surface.mesh->indices;
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> numbers;  // by piece and level
    for (std::size_t k = 0; k + 2 < indices.size(); k += 3) {
      const double z =
          (part.p_M[indices[k]].z() + part.p_M[indices[k + 1]].z() + part.p_M[indices[k + 2]].z()) /
          3.0;
      const auto [entry, is_new] =
          numbers.try_emplace({part.piece[indices[k]], levelAt(levels, z)}, painted.size());
      if (is_new) painted.emplace_back();
      PaintedPart& here = painted[entry->second];
      const TexturedTriangle triangle(surface, part, k, picture);
      const Eigen::Matrix3d& p_M = triangle.p_M;
      for (std::size_t c = 0; c < 3; ++c) here.box_M.extend(part.p_M[indices[k + c]].cast<float>());
      const double area = 0.5 * (p_M.col(1) - p_M.col(0)).cross(p_M.col(2) - p_M.col(0)).norm();
      here.share += area / std::max(parts.area, 1e-12);
      const Eigen::Vector2d ab = triangle.corners[1] - triangle.corners[0];
      const Eigen::Vector2d ac = triangle.corners[2] - triangle.corners[0];
      const double texels = 0.5 * std::abs(ab.x() * ac.y() - ab.y() * ac.x());
      constexpr double kMostTexels = 2.0e7;  // a texture that repeats very often
      if (!(texels < kMostTexels)) continue;
      const auto number = static_cast<std::int32_t>(entry->second);
      forEachTexel(triangle.corners, [&](int column, int row, const Eigen::Vector3d& weights) {
        const std::size_t index = wrappedIndex(column, row, picture);
        PaintCanvas::Texel& texel = canvas.texels[index];
        const auto& pixel = picture.at<cv::Vec4b>(static_cast<int>(index) / picture.cols,
                                                  static_cast<int>(index) % picture.cols);
        colours.add(colourOf(pixel), area / texels);
        const Eigen::Vector3f p = (p_M * weights).cast<float>();
        if (texel.part == PaintCanvas::kNone) {
          texel.p_M = p;
          texel.part = number;
          ++seen;
        } else if (std::abs(texel.p_M.z() - p.z()) > same) {
          ++shared;
        }
      });
    }
  }
  constexpr double kMostShared = 0.15;
  if (static_cast<double>(shared) <= kMostShared * static_cast<double>(seen)) return;
  for (PaintCanvas::Texel& texel : canvas.texels) {
    if (texel.part != PaintCanvas::kNone) texel.part = PaintCanvas::kSomewhere;
  }
}

void PaintedModel::classify(PaintCanvas& canvas) const {
  const auto likeness_of = [&](const Eigen::Vector3f& colour) {
    return palette().likeness(colour);
  };
  ByColour<PaintPalette::Likeness> known;
  constexpr float kDark = 0.02F;
  constexpr float kMixed = 0.1F;
  for (std::size_t i = 0; i < canvas.texels.size(); ++i) {
    const cv::Vec4b& pixel = canvas.picture.at<cv::Vec4b>(
        static_cast<int>(i) / canvas.picture.cols, static_cast<int>(i) % canvas.picture.cols);
    const PaintPalette::Likeness& likeness = known.get(pixel, likeness_of);
    PaintCanvas::Texel& texel = canvas.texels[i];
    texel.paint = static_cast<std::uint8_t>(likeness.first);
    texel.is_mixed = likeness.share > kMixed;
    texel.shade = (lightnessOf(colourOf(pixel)) + kDark) /
                  (lightnessOf(palette().paints()[likeness.first].colour) + kDark);
  }
}

/// Texels at the border of two paints are a mixture. They take the shade of their surroundings, so
/// that no trace remains of a border that is painted over.
void PaintedModel::smoothBorders(PaintCanvas& canvas) {
  constexpr int kNear = 2;    // [px]
  constexpr int kAround = 4;  // [px]
  const int width = canvas.picture.cols;
  const int height = canvas.picture.rows;
  const auto at = [&](int column, int row) -> PaintCanvas::Texel& {
    return canvas.texels[flatIndex(row, column, width)];
  };
  std::vector<std::pair<int, int>> mixed;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const PaintCanvas::Texel& texel = at(column, row);
      if (texel.part == PaintCanvas::kNone) continue;
      bool is_mixed = texel.is_mixed;
      for (int step = -kNear; step <= kNear && !is_mixed; ++step) {
        const int c = std::clamp(column + step, 0, width - 1);
        const int r = std::clamp(row + step, 0, height - 1);
        for (const PaintCanvas::Texel* other : {&at(c, row), &at(column, r)}) {
          is_mixed = is_mixed || (other->part == texel.part && other->paint != texel.paint);
        }
      }
      if (is_mixed) mixed.emplace_back(column, row);
    }
  }
  for (const auto& [column, row] : mixed) at(column, row).is_mixed = true;
  std::vector<float> shades;
  for (const auto& [column, row] : mixed) {
    float sum = 0.0F;
    int count = 0;
    for (int r = std::max(row - kAround, 0); r <= std::min(row + kAround, height - 1); r += 2) {
      for (int c = std::max(column - kAround, 0); c <= std::min(column + kAround, width - 1);
           c += 2) {
        const PaintCanvas::Texel& other = at(c, r);
        if (other.is_mixed || other.part != at(column, row).part) continue;
        sum += other.shade;
        ++count;
      }
    }
    shades.push_back(count > 0 ? sum / static_cast<float>(count) : 1.0F);
  }
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    at(mixed[i].first, mixed[i].second).shade = shades[i];
  }
}

/// A part is banded if each of its heights has nearly a single paint, and different heights differ.
void PaintedModel::findPatterns() {
  constexpr std::size_t kHeights = 48;
  constexpr double kPlain = 0.93;
  constexpr double kBanded = 0.88;
  const std::size_t paints = palette().paints().size();
  std::vector<std::vector<double>> counts(painted.size(),
                                          std::vector<double>(kHeights * paints, 0.0));
  for (const PaintCanvas& canvas : canvases) {
    for (const PaintCanvas::Texel& texel : canvas.texels) {
      if (texel.part < 0) continue;
      const auto number = static_cast<std::size_t>(texel.part);
      const Eigen::AlignedBox3f& box = painted[number].box_M;
      const float t = (texel.p_M.z() - box.min().z()) / std::max(box.sizes().z(), 1e-6F);
      const auto height =
          std::min(static_cast<std::size_t>(std::clamp(t, 0.0F, 1.0F) * kHeights), kHeights - 1);
      counts[number][height * paints + texel.paint] += 1.0;
    }
  }
  for (std::size_t i = 0; i < painted.size(); ++i) {
    PaintedPart& part = painted[i];
    part.paints.assign(paints, 0.0);
    double all = 0.0;
    double pure = 0.0;
    for (std::size_t height = 0; height < kHeights; ++height) {
      const double* here = &counts[i][height * paints];
      pure += *std::max_element(here, here + paints);
      for (std::size_t k = 0; k < paints; ++k) {
        part.paints[k] += here[k];
        all += here[k];
      }
    }
    if (all <= 0.0) continue;
    for (double& share : part.paints) share /= all;
    part.paint = static_cast<std::size_t>(std::max_element(part.paints.begin(), part.paints.end()) -
                                          part.paints.begin());
    if (part.paints[part.paint] > kPlain) continue;
    part.pattern =
        pure > kBanded * all ? PaintedPart::Pattern::kBanded : PaintedPart::Pattern::kPicture;
  }
}

}  // namespace synthetic_dataset::randomize
