#include "world/shape/heightmap.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "world/shape/height_picture.h"

namespace synthetic_dataset::world {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;
using Eigen::Vector4f;

constexpr int kMostPoints = 1025;  // on a side: two million triangles in all

/// The number of grid points on a side with this many pixels.
int pointsOf(int pixels, unsigned sampling) {
  const double points = (pixels - 1.0) * std::max(1U, sampling) + 1.0;
  return static_cast<int>(std::min<double>(points, kMostPoints));
}

/// The picture's first channel between its pixels, as Gazebo interpolates.
double interpolated(const cv::Mat& picture, double x, double y) {
  const int left = std::min(static_cast<int>(x), picture.cols - 2);
  const int top = std::min(static_cast<int>(y), picture.rows - 2);
  const double dx = x - left;
  const double dy = y - top;
  const auto value = [&](int row, int column) -> double {
    return picture.at<cv::Vec3f>(row, column)[0];
  };
  const double upper = (1.0 - dx) * value(top, left) + dx * value(top, left + 1);
  const double lower = (1.0 - dx) * value(top + 1, left) + dx * value(top + 1, left + 1);
  return (1.0 - dy) * upper + dy * lower;
}

float brightnessOf(const cv::Vec3f& pixel) { return pixel[0] + pixel[1] + pixel[2]; }

/// The red of the brightest pixel, which has the height given by the heightmap's size. In 8-bit
/// pictures, Gazebo 11 takes a value of 1 for the brightest possible: it divides only values above
/// 1 by 255 (common::Image::MaxColor, ignition::math::Color::Clamp).
double brightestOf(const NumberPicture& picture) {
  cv::Vec3f brightest(0.0F, 0.0F, 0.0F);
  for (int row = 0; row < picture.numbers.rows; ++row) {
    for (int column = 0; column < picture.numbers.cols; ++column) {
      cv::Vec3f pixel = picture.numbers.at<cv::Vec3f>(row, column);
      for (int i = 0; picture.has_eight_bits && i < 3; ++i) {
        if (std::lround(255.0F * pixel[i]) == 1) pixel[i] = 1.0F;
      }
      if (brightnessOf(pixel) > brightnessOf(brightest)) brightest = pixel;
    }
  }
  return brightest[0];
}

/// The distances between neighbouring grid points along x and y.
Eigen::Vector2d stepOf(const Heightmap& heightmap, const HeightGrid& grid) {
  return {heightmap.size.x() / (grid.columns - 1), heightmap.size.y() / (grid.rows - 1)};
}

/// The normal at a point, from the slopes between its neighbours.
Vector3f normalAt(const HeightGrid& grid, const Eigen::Vector2d& step, int row, int column) {
  const auto height = [&](int r, int c) -> double {
    return grid.heights[static_cast<std::size_t>(r) * static_cast<std::size_t>(grid.columns) +
                        static_cast<std::size_t>(c)];
  };
  const int left = std::max(0, column - 1);
  const int right = std::min(grid.columns - 1, column + 1);
  const int up = std::max(0, row - 1);
  const int down = std::min(grid.rows - 1, row + 1);
  const double slope_x = (height(row, right) - height(row, left)) / ((right - left) * step.x());
  const double slope_y = (height(up, column) - height(down, column)) / ((down - up) * step.y());
  return Eigen::Vector3d(-slope_x, -slope_y, 1.0).normalized().cast<float>();
}

void addQuadrangles(const HeightGrid& grid, Mesh& mesh) {
  const auto columns = static_cast<std::uint32_t>(grid.columns);
  for (std::uint32_t row = 0; row + 1 < static_cast<std::uint32_t>(grid.rows); ++row) {
    for (std::uint32_t column = 0; column + 1 < columns; ++column) {
      const std::uint32_t corner = row * columns + column;
      const std::uint32_t below = corner + columns;
      mesh.indices.insert(mesh.indices.end(),
                          {corner, below, below + 1, corner, below + 1, corner + 1});
    }
  }
}

/// @param tile  size of the texture on the ground [m]
std::shared_ptr<Mesh> meshOf(const Heightmap& heightmap, const HeightGrid& grid, double tile) {
  auto mesh = std::make_shared<Mesh>();
  const Eigen::Vector2d step = stepOf(heightmap, grid);
  std::size_t next = 0;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      const Eigen::Vector2d passed(column * step.x(), row * step.y());
      const Eigen::Vector3d from_centre(passed.x() - 0.5 * heightmap.size.x(),
                                        0.5 * heightmap.size.y() - passed.y(),
                                        grid.heights[next++]);
      mesh->positions.push_back((heightmap.centre + from_centre).cast<float>());
      mesh->normals.push_back(normalAt(grid, step, row, column));
      mesh->texture_coordinates.push_back((passed / tile).cast<float>());
    }
  }
  addQuadrangles(grid, *mesh);
  return mesh;
}

/// The weight of a texture at each point (Gazebo's Heightmap::InitBlendMaps).
std::vector<float> weightsOf(const HeightGrid& grid, const GroundBlend& blend) {
  std::vector<float> weights;
  for (const float height : grid.heights) {
    const double above = height - blend.min_height;
    const double weight = blend.fade_dist > 0.0 ? above / blend.fade_dist : (above > 0.0 ? 1 : 0);
    weights.push_back(static_cast<float>(std::clamp(weight, 0.0, 1.0)));
  }
  return weights;
}

/// Sets the weights as the alpha of the mesh's colours, and removes the triangles without any
/// weight.
void fade(Mesh& mesh, const std::vector<float>& weights) {
  for (const float weight : weights) mesh.colours.emplace_back(1.0F, 1.0F, 1.0F, weight);
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
    const std::uint32_t* corner = &mesh.indices[i];
    const bool seen = weights[corner[0]] + weights[corner[1]] + weights[corner[2]] > 0.0F;
    if (seen) indices.insert(indices.end(), corner, corner + 3);
  }
  mesh.indices = std::move(indices);
}

/// The ground is kept even if its pictures are missing.
Material materialOf(const GroundTexture& ground, const Heightmap& heightmap,
                    TextureLoader& textures, const MissingPicture& missing) {
  MaterialSource source;
  source.material.diffuse.setOnes();
  source.material.specular.setZero();
  source.texture.emplace();
  source.texture->uri = ground.diffuse;
  source.texture->folder = heightmap.folder;
  if (!ground.normal.empty()) {
    source.normal_map = source.texture;
    source.normal_map->uri = ground.normal;
  }
  return withPictures(source, textures, missing);
}

bool allAre(const std::vector<float>& weights, float value) {
  return std::all_of(weights.begin(), weights.end(), [&](float each) { return each == value; });
}

}  // namespace

HeightGrid readHeights(const Heightmap& heightmap) {
  const NumberPicture read = readNumbers(heightmap.file);
  const cv::Mat& picture = read.numbers;
  if (picture.cols < 2 || picture.rows < 2) {
    throw Error("heightmap '" + heightmap.file.string() + "': has " + std::to_string(picture.cols) +
                " x " + std::to_string(picture.rows) + " pixels; at least 2 x 2 are needed");
  }
  const double brightest = brightestOf(read);
  const double scale = brightest > 0.0 ? heightmap.size.z() / brightest : 0.0;
  HeightGrid grid;
  grid.columns = pointsOf(picture.cols, heightmap.sampling);
  grid.rows = pointsOf(picture.rows, heightmap.sampling);
  for (int row = 0; row < grid.rows; ++row) {
    const double y = row * (picture.rows - 1.0) / (grid.rows - 1.0);
    for (int column = 0; column < grid.columns; ++column) {
      const double x = column * (picture.cols - 1.0) / (grid.columns - 1.0);
      grid.heights.push_back(static_cast<float>(scale * interpolated(picture, x, y)));
    }
  }
  return grid;
}

std::shared_ptr<const Mesh> heightmapMesh(const Heightmap& heightmap) {
  return meshOf(heightmap, readHeights(heightmap), 1.0);
}

std::vector<Surface> heightmapSurfaces(const Heightmap& heightmap, const Material& plain,
                                       TextureLoader& textures, const MissingPicture& missing) {
  const HeightGrid grid = readHeights(heightmap);
  if (heightmap.textures.empty()) return {{meshOf(heightmap, grid, 1.0), plain}};
  std::vector<Surface> surfaces;
  for (std::size_t i = 0; i < heightmap.textures.size() && i <= heightmap.blends.size(); ++i) {
    const GroundTexture& ground = heightmap.textures[i];
    auto mesh = meshOf(heightmap, grid, ground.size);
    if (i > 0) {
      const std::vector<float> weights = weightsOf(grid, heightmap.blends[i - 1]);
      if (allAre(weights, 0.0F)) continue;
      if (allAre(weights, 1.0F)) {
        surfaces.clear();  // it hides the ones below it
      } else {
        fade(*mesh, weights);
      }
    }
    surfaces.push_back({std::move(mesh), materialOf(ground, heightmap, textures, missing)});
  }
  return surfaces;
}

}  // namespace synthetic_dataset::world
