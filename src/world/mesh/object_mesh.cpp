#include "world/mesh/object_mesh.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "world/material/material_conversions.h"
#include "world/mesh/farthest_pair.h"
#include "world/mesh/mesh_normals.h"

namespace synthetic_dataset::world {
namespace {

using Rgb = Eigen::Vector3f;  ///< linear red, green, blue

Rgb decoded(const Rgb& encoded) { return encoded.unaryExpr(&linearComponent); }

/// The index of the pixel that a texture coordinate falls on, in a repeating picture.
int texel(float place, int count) {
  const float part = place - std::floor(place);
  return std::clamp(static_cast<int>(part * static_cast<float>(count)), 0, count - 1);
}

/// Makes the vertices of one surface.
class SurfaceVertices {
 public:
  SurfaceVertices(const Surface& surface, const Pose& X_OV)
      : mesh_(*surface.mesh), material_(surface.material), X_OV_(X_OV), normals_(mesh_.normals) {
    if (normals_.size() != mesh_.positions.size()) {
      Mesh complete = mesh_;
      complete.normals.assign(mesh_.positions.size(), Eigen::Vector3f::Zero());
      completeNormals(complete);
      normals_ = complete.normals;
    }
  }

  /// Adds the surface's triangles, and those vertices that they use, to a model.
  void addTo(ObjectModel& model) const {
    constexpr std::int32_t kUnused = -1;
    std::vector<std::int32_t> numbers(mesh_.positions.size(), kUnused);
    for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3) {
      ObjectModel::Triangle triangle{};
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::int32_t& number = numbers[mesh_.indices[i + corner]];
        if (number == kUnused) {
          number = static_cast<std::int32_t>(model.vertices.size());
          model.vertices.push_back(vertex(i, corner));
        }
        triangle[corner] = number;
      }
      model.triangles.push_back(triangle);
    }
  }

 private:
  [[nodiscard]] ObjectModel::Vertex vertex(std::size_t triangle, std::size_t corner) const {
    const std::uint32_t index = mesh_.indices[triangle + corner];
    ObjectModel::Vertex result;
    result.position = X_OV_ * mesh_.positions[index].cast<double>();
    result.normal = (X_OV_.linear() * normals_[index].cast<double>()).normalized();
    Rgb colour = decoded(material_.diffuse.head<3>());
    if (mesh_.colours.size() == mesh_.positions.size()) {
      colour = colour.cwiseProduct(decoded(mesh_.colours[index].head<3>()));
    }
    if (const auto painted = pictureColour(triangle, corner)) {
      colour = colour.cwiseProduct(*painted);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const float encoded = encodedComponent(colour[static_cast<Eigen::Index>(i)]);
      result.colour[i] = static_cast<std::uint8_t>(std::lround(255.0F * encoded));
    }
    return result;
  }

  /// The picture's colour slightly inside the triangle: at the corner itself, a picture that is
  /// shown once could give the colour of its opposite edge.
  [[nodiscard]] std::optional<Rgb> pictureColour(std::size_t triangle, std::size_t corner) const {
    if (!material_.texture || mesh_.texture_coordinates.size() != mesh_.positions.size()) {
      return std::nullopt;
    }
    constexpr float kInside = 0.01F;  // of the way to the triangle's centre
    const auto at = [&](std::size_t i) -> const Eigen::Vector2f& {
      return mesh_.texture_coordinates[mesh_.indices[triangle + i]];
    };
    const Eigen::Vector2f centre = (at(0) + at(1) + at(2)) / 3.0F;
    const Eigen::Vector2f own = at(corner) + kInside * (centre - at(corner));
    const Eigen::Vector2f place =
        own.cwiseProduct(material_.texture_scale) + material_.texture_offset;
    if (!place.allFinite()) return std::nullopt;
    const cv::Mat& pixels = material_.texture->pixels;
    const auto& pixel =
        pixels.at<cv::Vec4b>(texel(place.y(), pixels.rows), texel(place.x(), pixels.cols));
    return decoded(Rgb(pixel[2], pixel[1], pixel[0]) / 255.0F);
  }

  const Mesh& mesh_;
  const Material& material_;
  Pose X_OV_;
  std::vector<Eigen::Vector3f> normals_;
};

}  // namespace

ObjectModel objectModel(const std::vector<const Link*>& links, const std::vector<Pose>& X_OL) {
  ObjectModel model;
  for (std::size_t i = 0; i < links.size(); ++i) {
    for (const Visual& visual : links[i]->visuals) {
      for (const Surface& surface : visual.surfaces) {
        SurfaceVertices(surface, X_OL.at(i) * visual.X_LV).addTo(model);
      }
    }
  }
  std::vector<Eigen::Vector3d> points;
  points.reserve(model.vertices.size());
  for (const ObjectModel::Vertex& vertex : model.vertices) points.push_back(vertex.position);
  model.diameter = largestDistance(std::move(points));
  return model;
}

}  // namespace synthetic_dataset::world
