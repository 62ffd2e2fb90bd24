#include "randomize/appearance/object_variety.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include <gmock/gmock.h>

#include <opencv2/core.hpp>

#include "randomize/appearance/variety/paint_canvas.h"
#include "world/shape/shape_meshes.h"

namespace synthetic_dataset::randomize {
namespace object_variety_test {

constexpr double kHeight = 1.0;  // [m]
constexpr double kFoot = 0.05;   // [m], of it

/// A cone without caps, with a texture around it.
std::shared_ptr<const world::Mesh> coneMesh() {
  constexpr int kSides = 24;
  auto mesh = std::make_shared<world::Mesh>();
  const auto add = [&](int side, bool is_top) {
    const double angle = 2.0 * M_PI * side / kSides;
    const double radius = is_top ? 0.03 : 0.15;
    const double z = is_top ? kHeight : kFoot;
    const Eigen::Vector3d p(radius * std::cos(angle), radius * std::sin(angle), z);
    const Eigen::Vector3d n(std::cos(angle), std::sin(angle), 0.12 / (kHeight - kFoot));
    mesh->positions.push_back(p.cast<float>());
    mesh->normals.push_back(n.normalized().cast<float>());
    mesh->texture_coordinates.emplace_back(static_cast<float>(side) / kSides, is_top ? 0.0F : 1.0F);
  };
  for (int side = 0; side <= kSides; ++side) {
    add(side, false);
    add(side, true);
  }
  for (std::uint32_t side = 0; side < kSides; ++side) {
    const std::uint32_t first = 2 * side;
    for (const std::uint32_t step : {0U, 2U, 3U, 0U, 3U, 1U}) mesh->indices.push_back(first + step);
  }
  return mesh;
}

/// White stripes on orange.
std::shared_ptr<const world::Texture> stripes() {
  auto texture = std::make_shared<world::Texture>();
  texture->file = "stripes.png";
  texture->pixels = cv::Mat(128, 128, CV_8UC4, cv::Scalar(20, 70, 225, 255));
  for (const int top : {20, 70}) {
    texture->pixels.rowRange(top, top + 25).setTo(cv::Scalar(240, 240, 240, 255));
  }
  return texture;
}

/// A striped cone on a dark foot, which is a box in one colour.
world::Model cone() {
  world::Material striped;
  striped.texture = stripes();
  world::Material dark;
  dark.diffuse = {0.1F, 0.1F, 0.1F, 1.0F};
  world::Visual body;
  body.surfaces.push_back({coneMesh(), striped});
  world::Visual foot;
  foot.X_LV.translation().z() = 0.5 * kFoot;
  foot.surfaces.push_back({world::boxMesh({0.4, 0.4, kFoot}), dark});
  world::Collision collision;
  collision.X_LC.translation().z() = 0.5 * kFoot;
  collision.shape = world::BoxShape{{0.4, 0.4, kFoot}};
  world::Link link;
  link.visuals = {body, foot};
  link.collisions = {collision};
  world::Model model;
  model.name = "cone";
  model.links.push_back(link);
  return model;
}

/// The corners of all triangles, in the model's frame.
std::vector<Eigen::Vector3d> cornersOf(const world::Model& model) {
  std::vector<Eigen::Vector3d> corners;
  for (const SurfacePart& part : ModelParts(model).surfaces) {
    for (const std::uint32_t index : surfaceOf(model, part).mesh->indices) {
      corners.push_back(part.p_M[index]);
    }
  }
  return corners;
}

const cv::Mat& pictureOf(const VariedModel& variant) {
  return variant.model.links.at(0).visuals.at(0).surfaces.at(0).material.texture->pixels;
}

std::vector<std::uint8_t> bytesOf(const VariedModel& variant) {
  std::vector<std::uint8_t> bytes;
  for (const world::Visual& visual : variant.model.links.at(0).visuals) {
    const cv::Mat& pixels = visual.surfaces.at(0).material.texture->pixels;
    bytes.insert(bytes.end(), pixels.datastart, pixels.dataend);
    for (const Eigen::Vector3f& p : visual.surfaces.at(0).mesh->positions) {
      const auto* first = reinterpret_cast<const std::uint8_t*>(p.data());
      bytes.insert(bytes.end(), first, first + sizeof(float) * 3);
    }
  }
  return bytes;
}

/// Mean red, green, blue of a picture's row, 0 .. 255.
Eigen::Vector3d rowColour(const cv::Mat& picture, int row) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int column = 0; column < picture.cols; ++column) {
    const cv::Vec4b& pixel = picture.at<cv::Vec4b>(row, column);
    sum += Eigen::Vector3d(pixel[2], pixel[1], pixel[0]);
  }
  return sum / picture.cols;
}

/// How often the lightness changes strongly from row to row.
int stripeEdges(const cv::Mat& picture) {
  int edges = 0;
  for (int row = 2; row < picture.rows; row += 2) {
    const double step = rowColour(picture, row).mean() - rowColour(picture, row - 2).mean();
    edges += std::abs(step) > 25.0 ? 1 : 0;
  }
  return edges;
}

TEST(ObjectVariety, TheFirstIsTheModelItself) {
  const world::Model model = cone();
  const ObjectVariety variety(model, Variety::kSameClass, 1);
  const VariedModel first = variety.variant(0);
  EXPECT_FALSE(first.shape);
  for (std::size_t i = 0; i < 2; ++i) {
    const world::Surface& given = model.links[0].visuals[i].surfaces[0];
    const world::Surface& same = first.model.links[0].visuals[i].surfaces[0];
    EXPECT_EQ(same.mesh, given.mesh);
    EXPECT_EQ(same.material.texture, given.material.texture);
    EXPECT_EQ(same.material.diffuse, given.material.diffuse);
  }
}

TEST(ObjectVariety, TheSameObjectKeepsEveryVertexAndItsPattern) {
  const world::Model model = cone();
  const ObjectVariety variety(model, Variety::kSameObject, 1);
  for (int number = 1; number < 12; ++number) {
    const VariedModel worn = variety.variant(number);
    EXPECT_FALSE(worn.shape);
    EXPECT_EQ(cornersOf(worn.model), cornersOf(model));
    const cv::Mat& picture = pictureOf(worn);
    ASSERT_EQ(picture.size(), stripes()->pixels.size());
    // White stays lighter than orange, and orange red rather than blue, however worn it is.
    EXPECT_GT(rowColour(picture, 32).mean(), rowColour(picture, 57).mean() + 15.0) << number;
    EXPECT_GT(rowColour(picture, 57)[0], rowColour(picture, 57)[2] + 15.0) << number;
  }
}

TEST(ObjectVariety, OthersOfTheClassHaveOtherProportionsWithinLimits) {
  const world::Model model = cone();
  const ObjectVariety variety(model, Variety::kSameClass, 1);
  const Eigen::Vector3d before = ModelParts(model).box_M.sizes();
  std::vector<double> heights;
  std::vector<double> slendernesses;
  for (int number = 1; number < 40; ++number) {
    const Eigen::AlignedBox3d box = ModelParts(variety.variant(number).model).box_M;
    const Eigen::Vector3d factor = box.sizes().cwiseQuotient(before);
    EXPECT_GE(factor.z(), ShapeChange::kLowest - 1e-6);
    EXPECT_LE(factor.z(), ShapeChange::kHighest + 1e-6);
    for (int axis = 0; axis < 2; ++axis) {
      EXPECT_GE(factor[axis], ShapeChange::kNarrowest);
      EXPECT_LE(factor[axis], ShapeChange::kWidest);
    }
    EXPECT_NEAR(factor.x(), factor.y(), 0.1 * factor.x()) << "what is round stays nearly so";
    EXPECT_NEAR(box.min().z(), 0.0, 1e-6) << "it stands where it stood";
    heights.push_back(factor.z());
    slendernesses.push_back(factor.z() / factor.x());
  }
  const auto spread = [](const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return *high / *low;
  };
  EXPECT_GT(spread(heights), 1.5);
  EXPECT_GT(spread(slendernesses), 1.6);
}

TEST(ObjectVariety, NormalsStayUnitAndOutside) {
  const ObjectVariety variety(cone(), Variety::kSameClass, 3);
  for (int number = 1; number < 12; ++number) {
    const VariedModel varied = variety.variant(number);
    for (const world::Visual& visual : varied.model.links[0].visuals) {
      const world::Mesh& mesh = *visual.surfaces[0].mesh;
      for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
        const Eigen::Vector3f& a = mesh.positions[mesh.indices[k]];
        const Eigen::Vector3f face = (mesh.positions[mesh.indices[k + 1]] - a)
                                         .cross(mesh.positions[mesh.indices[k + 2]] - a)
                                         .normalized();
        for (std::size_t i = 0; i < 3; ++i) {
          const Eigen::Vector3f& normal = mesh.normals[mesh.indices[k + i]];
          EXPECT_NEAR(normal.norm(), 1.0F, 1e-5F);
          EXPECT_GT(normal.dot(face), 0.97F);
        }
      }
    }
  }
}

TEST(ObjectVariety, CollisionsAndPointsFollowTheShape) {
  const world::Model model = cone();
  const ObjectVariety variety(model, Variety::kSameClass, 5);
  for (int number = 1; number < 8; ++number) {
    const VariedModel varied = variety.variant(number);
    const std::vector<Eigen::Vector3d> before = cornersOf(model);
    const std::vector<Eigen::Vector3d> after = cornersOf(varied.model);
    ASSERT_EQ(before.size(), after.size());
    Eigen::AlignedBox3d moved_points;
    for (const Eigen::Vector3d& p : before) moved_points.extend(varied.shape->moved(p));
    const Eigen::AlignedBox3d box = ModelParts(varied.model).box_M;
    EXPECT_TRUE(moved_points.sizes().isApprox(box.sizes(), 1e-4));
    const world::Collision& collision = varied.model.links[0].collisions[0];
    Eigen::AlignedBox3d solid;
    for (const Eigen::Vector3f& p : std::get<world::MeshShape>(collision.shape).mesh->positions) {
      solid.extend(collision.X_LC * p.cast<double>());
    }
    EXPECT_NEAR(solid.sizes().x(), box.sizes().x(), 1e-4) << "the foot is its widest part";
    EXPECT_NEAR(solid.min().z(), 0.0, 1e-5);
  }
}

TEST(ObjectVariety, OthersOfTheClassHaveOtherStripesAndNoneIsBlack) {
  const ObjectVariety variety(cone(), Variety::kSameClass, 1);
  std::vector<int> edges;
  for (int number = 1; number < 40; ++number) {
    const VariedModel varied = variety.variant(number);
    edges.push_back(stripeEdges(pictureOf(varied)));
    EXPECT_GT(cv::mean(pictureOf(varied))[2] + cv::mean(pictureOf(varied))[1], 60.0) << number;
  }
  EXPECT_LE(*std::min_element(edges.begin(), edges.end()), 1) << "some are plain";
  EXPECT_GE(*std::max_element(edges.begin(), edges.end()), 6) << "some have more than two";
}

TEST(ObjectVariety, FollowsFromTheSeedAndTheNumber) {
  const world::Model model = cone();
  const ObjectVariety one(model, Variety::kSameClass, 1);
  const ObjectVariety again(cone(), Variety::kSameClass, 1);
  const ObjectVariety other(model, Variety::kSameClass, 2);
  (void)again.variant(5);  // in whatever order they are made
  EXPECT_EQ(bytesOf(one.variant(3)), bytesOf(again.variant(3)));
  EXPECT_NE(bytesOf(one.variant(3)), bytesOf(one.variant(4)));
  EXPECT_NE(bytesOf(one.variant(3)), bytesOf(other.variant(3)));
}

TEST(ObjectVariety, WhatIsInvisibleStaysSo) {
  world::Model model;
  model.links.emplace_back();
  const ObjectVariety variety(model, Variety::kSameClass, 1);
  EXPECT_FALSE(variety.variant(1).shape);
}

// --- How a model is prepared for paint ---

TEST(PaintedModel, FindsThePaintsAndTheStripes) {
  const PaintedModel painted(cone());
  EXPECT_EQ(painted.palette().paints().size(), 3U);
  ASSERT_EQ(painted.canvases.size(), 2U) << "the foot has got a texture";
  const auto banded = std::count_if(
      painted.painted.begin(), painted.painted.end(),
      [](const PaintedPart& part) { return part.pattern == PaintedPart::Pattern::kBanded; });
  EXPECT_EQ(banded, 1);
}

/// Each face of a box shows the whole picture; to be painted by place, it needs its own texels.
TEST(PaintedModel, UnwrapsWhatShowsTheSameTexelsTwice) {
  world::Model model;
  world::Visual visual;
  world::Material material;
  material.texture = stripes();
  visual.surfaces.push_back({world::boxMesh({0.4, 0.4, 0.6}), material});
  model.links.emplace_back().visuals.push_back(visual);
  const PaintedModel painted(model);
  ASSERT_EQ(painted.canvases.size(), 1U);
  EXPECT_NE(painted.canvases[0].picture.size(), stripes()->pixels.size());
  for (const PaintCanvas::Texel& texel : painted.canvases[0].texels) {
    ASSERT_NE(texel.part, PaintCanvas::kSomewhere);
  }
  EXPECT_EQ(cornersOf(painted.model), cornersOf(model));
}

/// Glass stays as it is.
TEST(PaintedModel, LeavesWhatIsSeenThrough) {
  world::Model model = cone();
  model.links[0].visuals[0].surfaces[0].material.texture_is_glass = true;
  const VariedModel varied = ObjectVariety(model, Variety::kSameClass, 1).variant(2);
  EXPECT_EQ(varied.model.links[0].visuals[0].surfaces[0].material.texture,
            model.links[0].visuals[0].surfaces[0].material.texture);
}

}  // namespace object_variety_test
}  // namespace synthetic_dataset::randomize
