#include "randomize/appearance/variety/texture_atlas.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

#include <Eigen/Geometry>

#include "randomize/appearance/variety/joined_sets.h"
#include "randomize/appearance/variety/texel_raster.h"

namespace synthetic_dataset::randomize {
namespace {

constexpr int kMargin = 3;  // [px] around each chart, for the coarser levels of a mipmap

/// Adjacent triangles, seen along an axis.
struct Chart {
  Eigen::AlignedBox2d box;  ///< [m]
  Eigen::Vector2d corner;   ///< where its lower corner is placed [px]
};

/// One of six directions, by axis and sign.
std::size_t directionOf(const Eigen::Vector3f& normal) {
  Eigen::Index axis = 0;
  normal.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<std::size_t>(axis) + (normal[axis] < 0.0F ? 1 : 0);
}

Eigen::Vector2d seenAlong(std::size_t direction, const Eigen::Vector3f& p) {
  const std::size_t axis = direction / 2;
  if (axis == 0) return {p.y(), -p.z()};
  if (axis == 1) return {p.x(), -p.z()};
  return {p.x(), p.y()};
}

/// Places the charts in rows. @return whether they fit at this many texels per metre
bool pack(std::vector<Chart>& charts, const std::vector<std::size_t>& order, double density,
          int side) {
  double x = 0.0;
  double y = 0.0;
  double row = 0.0;
  for (const std::size_t i : order) {
    const Eigen::Vector2d size =
        (density * charts[i].box.sizes()).array().ceil() + 2.0 * kMargin + 1.0;
    if (size.x() > side) return false;
    if (x + size.x() > side) {
      y += row;
      x = row = 0.0;
    }
    row = std::max(row, size.y());
    if (y + row > side) return false;
    charts[i].corner = {x + kMargin, y + kMargin};
    x += size.x();
  }
  return true;
}

/// @return texels per metre; nothing if there are too many charts
std::optional<double> packAll(std::vector<Chart>& charts, int side) {
  std::vector<std::size_t> order(charts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return charts[a].box.sizes().y() > charts[b].box.sizes().y();
  });
  double area = 0.0;
  for (const Chart& chart : charts) area += chart.box.sizes().prod();
  double density = side / std::sqrt(std::max(area, 1e-12));
  for (int tries = 0; tries < 60; ++tries) {
    if (pack(charts, order, density, side)) return density;
    density *= 0.93;
  }
  return std::nullopt;
}

/// The unlit colour of a place on a surface.
cv::Vec4b lookAt(const world::Surface& surface, const std::array<std::uint32_t, 3>& triangle,
                 const Eigen::Vector3d& weights) {
  const world::Mesh& mesh = *surface.mesh;
  Eigen::Vector4f colour = surface.material.diffuse;
  colour[3] = 1.0F;
  Eigen::Vector2f place = Eigen::Vector2f::Zero();
  Eigen::Vector4f own = Eigen::Vector4f::Zero();
  for (std::size_t i = 0; i < 3; ++i) {
    const auto weight = static_cast<float>(weights[static_cast<Eigen::Index>(i)]);
    if (!mesh.texture_coordinates.empty()) {
      place += weight * mesh.texture_coordinates[triangle[i]];
    }
    if (!mesh.colours.empty()) own += weight * mesh.colours[triangle[i]];
  }
  if (!mesh.colours.empty()) colour = colour.cwiseProduct(own);
  if (surface.material.texture && !mesh.texture_coordinates.empty()) {
    const cv::Vec4b texel =
        texelAt(surface.material.texture->pixels, texturePlace(surface.material, place));
    for (int i = 0; i < 3; ++i) colour[i] *= static_cast<float>(texel[2 - i]) / 255.0F;
  }
  const auto byte = [&](int channel) {
    return cv::saturate_cast<std::uint8_t>(255.0F * colour[channel]);
  };
  return {byte(2), byte(1), byte(0), 255};
}

/// Extends what is filled beyond its edges.
void fillMargins(cv::Mat& picture, cv::Mat& filled) {
  for (int round = 0; round < 2 * kMargin; ++round) {
    const cv::Mat before = filled.clone();
    for (int row = 0; row < picture.rows; ++row) {
      for (int column = 0; column < picture.cols; ++column) {
        if (before.at<std::uint8_t>(row, column) != 0) continue;
        for (const auto& [dr, dc] :
             std::array<std::pair<int, int>, 4>{{{0, -1}, {0, 1}, {-1, 0}, {1, 0}}}) {
          const int r = row + dr;
          const int c = column + dc;
          if (r < 0 || c < 0 || r >= picture.rows || c >= picture.cols) continue;
          if (before.at<std::uint8_t>(r, c) == 0) continue;
          picture.at<cv::Vec4b>(row, column) = picture.at<cv::Vec4b>(r, c);
          filled.at<std::uint8_t>(row, column) = 1;
          break;
        }
      }
    }
  }
}

using Triangle = std::array<std::uint32_t, 3>;

Triangle triangleAt(const world::Mesh& mesh, std::size_t number) {
  return {mesh.indices[3 * number], mesh.indices[3 * number + 1], mesh.indices[3 * number + 2]};
}

/// Finds vertices at the same place: each receives the number of the first one there.
std::vector<std::uint32_t> samePlaces(const world::Mesh& mesh) {
  std::vector<std::uint32_t> order(mesh.positions.size());
  std::iota(order.begin(), order.end(), std::uint32_t{0});
  const auto key = [&](std::uint32_t i) {
    const Eigen::Vector3f& p = mesh.positions[i];
    return std::tuple(p.x(), p.y(), p.z(), i);
  };
  std::sort(order.begin(), order.end(),
            [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  std::vector<std::uint32_t> first(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const bool is_same = i > 0 && mesh.positions[order[i]] == mesh.positions[order[i - 1]];
    first[order[i]] = is_same ? first[order[i - 1]] : order[i];
  }
  return first;
}

/// The charts of a mesh: triangles that share edges and face the same way.
struct Charts {
  explicit Charts(const world::Mesh& mesh) {
    const std::size_t count = mesh.indices.size() / 3;
    const std::vector<std::uint32_t> places = samePlaces(mesh);
    std::vector<std::size_t> facing;
    JoinedSets sets(count);
    using Edge = std::tuple<std::uint32_t, std::uint32_t, std::size_t>;  // and the direction
    std::map<Edge, std::size_t> known;                                   // one of its triangles
    for (std::size_t k = 0; k < count; ++k) {
      const Triangle triangle = triangleAt(mesh, k);
      const Eigen::Vector3f& a = mesh.positions[triangle[0]];
      facing.push_back(
          directionOf((mesh.positions[triangle[1]] - a).cross(mesh.positions[triangle[2]] - a)));
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = places[triangle[i]];
        const std::uint32_t to = places[triangle[(i + 1) % 3]];
        const auto [edge, is_new] =
            known.try_emplace({std::min(from, to), std::max(from, to), facing.back()}, k);
        if (!is_new) sets.join(edge->second, k);
      }
    }
    std::map<std::size_t, std::size_t> numbers;
    for (std::size_t k = 0; k < count; ++k) {
      const auto [entry, is_new] = numbers.try_emplace(sets.find(k), charts.size());
      if (is_new) {
        charts.emplace_back();
        directions.push_back(facing[k]);
      }
      of_triangle.push_back(entry->second);
      for (const std::uint32_t index : triangleAt(mesh, k)) {
        charts[entry->second].box.extend(seenAlong(facing[k], mesh.positions[index]));
      }
    }
  }

  /// The place of a chart's vertex [px].
  [[nodiscard]] Eigen::Vector2d place(std::size_t chart, const Eigen::Vector3f& p) const {
    return charts[chart].corner +
           density * (seenAlong(directions[chart], p) - charts[chart].box.min());
  }

  std::vector<Chart> charts;
  std::vector<std::size_t> directions;   ///< one per chart
  std::vector<std::size_t> of_triangle;  ///< the chart of each triangle
  double density = 0.0;                  ///< [px/m]
};

/// Splits the mesh: each vertex is repeated for every chart that uses it.
std::shared_ptr<world::Mesh> split(const world::Mesh& mesh, const Charts& charts, int side) {
  auto result = std::make_shared<world::Mesh>();
  std::map<std::pair<std::uint32_t, std::size_t>, std::uint32_t> numbers;
  for (std::size_t k = 0; k < charts.of_triangle.size(); ++k) {
    const std::size_t chart = charts.of_triangle[k];
    for (const std::uint32_t index : triangleAt(mesh, k)) {
      const auto [entry, is_new] =
          numbers.try_emplace({index, chart}, static_cast<std::uint32_t>(result->positions.size()));
      if (is_new) {
        result->positions.push_back(mesh.positions[index]);
        result->normals.push_back(mesh.normals[index]);
        const Eigen::Vector2d place = charts.place(chart, mesh.positions[index]) / side;
        result->texture_coordinates.emplace_back(place.cast<float>());
      }
      result->indices.push_back(entry->second);
    }
  }
  return result;
}

}  // namespace

cv::Vec4b texelAt(const cv::Mat& pixels, const Eigen::Vector2f& place) {
  struct Neighbours {
    int low;
    int high;
    float share;
  };
  const auto neighbours = [](float coordinate, int count) {
    const float scaled = (coordinate - std::floor(coordinate)) * static_cast<float>(count) - 0.5F;
    const float low = std::floor(scaled);
    const int index = static_cast<int>(low);
    return Neighbours{(index + count) % count, (index + 1) % count, scaled - low};
  };
  const Neighbours x = neighbours(place.x(), pixels.cols);
  const Neighbours y = neighbours(place.y(), pixels.rows);
  cv::Vec4b result;
  for (int i = 0; i < 4; ++i) {
    const auto row = [&](int index) {
      const auto a = static_cast<float>(pixels.at<cv::Vec4b>(index, x.low)[i]);
      return a + x.share * (static_cast<float>(pixels.at<cv::Vec4b>(index, x.high)[i]) - a);
    };
    const float above = row(y.low);
    result[i] = cv::saturate_cast<std::uint8_t>(above + y.share * (row(y.high) - above));
  }
  return result;
}

std::optional<UnwrappedSurface> unwrapped(const world::Surface& surface, int side) {
  constexpr std::size_t kMostCharts = 3000;
  constexpr double kMostHidden = 0.1;  // of the texels
  Charts charts(*surface.mesh);
  if (charts.charts.size() > kMostCharts) return std::nullopt;
  const std::optional<double> density = packAll(charts.charts, side);
  if (!density) return std::nullopt;
  charts.density = *density;
  UnwrappedSurface result{split(*surface.mesh, charts, side), cv::Mat(side, side, CV_8UC4)};
  result.picture.setTo(cv::Scalar::all(255));
  cv::Mat filled = cv::Mat::zeros(side, side, CV_8UC1);
  std::size_t drawn = 0;
  std::size_t hidden = 0;
  for (std::size_t k = 0; k < charts.of_triangle.size(); ++k) {
    const Triangle triangle = triangleAt(*surface.mesh, k);
    std::array<Eigen::Vector2d, 3> corners;
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i] = charts.place(charts.of_triangle[k], surface.mesh->positions[triangle[i]]);
    }
    forEachTexel(corners, [&](int column, int row, const Eigen::Vector3d& weights) {
      if (row < 0 || column < 0 || row >= side || column >= side) return;
      auto& is_filled = filled.at<std::uint8_t>(row, column);
      ++drawn;
      hidden += is_filled;
      is_filled = 1;
      result.picture.at<cv::Vec4b>(row, column) = lookAt(surface, triangle, weights);
    });
  }
  const bool is_plain = !surface.material.texture && surface.mesh->colours.empty();
  if (!is_plain && static_cast<double>(hidden) > kMostHidden * static_cast<double>(drawn)) {
    return std::nullopt;
  }
  if (is_plain) {  // edges that cover no texel centre need the colour too
    const cv::Vec4b colour = lookAt(surface, triangleAt(*surface.mesh, 0), {1.0, 0.0, 0.0});
    result.picture.setTo(cv::Scalar(colour[0], colour[1], colour[2], colour[3]));
  } else {
    fillMargins(result.picture, filled);
  }
  return result;
}

}  // namespace synthetic_dataset::randomize
