#include "world/shape/wall_map.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <opencv2/core/mat.hpp>

#include "synthetic_dataset/errors.h"
#include "world/shape/height_picture.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::world {
namespace {

constexpr std::size_t kMostBoxes = 200000;

/// A range of columns and rows of a picture; `right` and `bottom` are not included.
struct Block {
  int left, right, top, bottom;
};

bool isWall(const cv::Vec3f& pixel, int threshold) {
  const float mean = (pixel[0] + pixel[1] + pixel[2]) / 3.0F;
  constexpr float kRounding = 1e-3F;  // 255 * (v / 255) may lie just below v
  return std::floor(255.0F * mean + kRounding) <= static_cast<float>(threshold);
}

bool hasWall(const cv::Mat& picture, const Block& block, int threshold) {
  for (int row = block.top; row < block.bottom; ++row) {
    for (int column = block.left; column < block.right; ++column) {
      if (isWall(picture.at<cv::Vec3f>(row, column), threshold)) return true;
    }
  }
  return false;
}

/// The walls of one row of blocks.
std::vector<Block> wallsOfRow(const cv::Mat& picture, const WallMap& map, int top, int side) {
  std::vector<Block> walls;
  const int bottom = std::min(picture.rows, top + side);
  for (int left = 0; left < picture.cols; left += side) {
    const Block block{left, std::min(picture.cols, left + side), top, bottom};
    if (!hasWall(picture, block, map.threshold)) continue;
    if (!walls.empty() && walls.back().right == left) {
      walls.back().right = block.right;
    } else {
      walls.push_back(block);
    }
  }
  return walls;
}

std::vector<Block> wallsOf(const cv::Mat& picture, const WallMap& map) {
  const int side = std::max(1, static_cast<int>(std::sqrt(std::max(1, map.granularity))));
  std::vector<Block> walls;
  std::map<std::pair<int, int>, std::size_t> above;  // the wall that ends here, by its columns
  for (int top = 0; top < picture.rows; top += side) {
    std::map<std::pair<int, int>, std::size_t> here;
    for (const Block& wall : wallsOfRow(picture, map, top, side)) {
      const auto same = above.find({wall.left, wall.right});
      if (same != above.end()) {
        walls[same->second].bottom = wall.bottom;
      } else {
        walls.push_back(wall);
      }
      here[{wall.left, wall.right}] = same != above.end() ? same->second : walls.size() - 1;
    }
    above = std::move(here);
  }
  return walls;
}

void append(const Mesh& box, const Eigen::Vector3d& centre, Mesh& mesh) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const Eigen::Vector3f& position : box.positions) {
    mesh.positions.emplace_back(position + centre.cast<float>());
  }
  mesh.normals.insert(mesh.normals.end(), box.normals.begin(), box.normals.end());
  mesh.texture_coordinates.insert(mesh.texture_coordinates.end(), box.texture_coordinates.begin(),
                                  box.texture_coordinates.end());
  for (const std::uint32_t index : box.indices) mesh.indices.push_back(first + index);
}

}  // namespace

std::shared_ptr<const Mesh> wallMesh(const WallMap& map) {
  const std::vector<Block> walls = wallsOf(readNumbers(map.file).numbers, map);
  if (walls.empty() || walls.size() > kMostBoxes) {
    throw Error("picture '" + map.file.string() + "': makes " + std::to_string(walls.size()) +
                " walls; 1 to " + std::to_string(kMostBoxes) +
                " will do (a pixel is a wall if its brightness is not above the threshold, " +
                std::to_string(map.threshold) + ")");
  }
  auto mesh = std::make_shared<Mesh>();
  for (const Block& wall : walls) {
    const Eigen::Vector3d size(map.scale * (wall.right - wall.left),
                               map.scale * (wall.bottom - wall.top), map.height);
    const Eigen::Vector3d centre(0.5 * map.scale * (wall.left + wall.right),
                                 0.5 * map.scale * (wall.top + wall.bottom), 0.5 * map.height);
    append(*boxMesh(size), centre, *mesh);
  }
  return mesh;
}

}  // namespace synthetic_dataset::world
