#include "world/shape/triangulation.h"

#include <cmath>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"
#include "world/shape/extrusion.h"

namespace synthetic_dataset::world {
namespace triangulation_test {

using Eigen::Vector2d;
using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;

Outline rectangle(double left, double bottom, double right, double top) {
  return {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
}

Outline reversed(Outline outline) { return {outline.rbegin(), outline.rend()}; }

/// The area of the triangles; fails the test if one runs clockwise.
double areaOf(const Triangulation& filled) {
  std::vector<Vector2d> points;
  for (const Outline& outline : filled.outlines) {
    points.insert(points.end(), outline.begin(), outline.end());
  }
  double sum = 0.0;
  for (const auto& [a, b, c] : filled.triangles) {
    Eigen::Matrix2d sides;
    sides << points[b] - points[a], points[c] - points[a];
    EXPECT_GE(sides.determinant(), 0.0);
    sum += 0.5 * sides.determinant();
  }
  return sum;
}

double filledArea(const std::vector<Outline>& outlines) { return areaOf(triangulate(outlines)); }

auto triangulating(const std::vector<Outline>& outlines) {
  return [outlines] { static_cast<void>(triangulate(outlines)); };
}

TEST(Triangulation, FillsEitherDirection) {
  EXPECT_DOUBLE_EQ(filledArea({rectangle(0, 0, 2, 3)}), 6.0);
  EXPECT_DOUBLE_EQ(filledArea({reversed(rectangle(0, 0, 2, 3))}), 6.0);
}

TEST(Triangulation, TakesAClosingPoint) {
  Outline closed = rectangle(0, 0, 1, 1);
  closed.push_back(closed.front());
  EXPECT_THAT(triangulate({closed}).outlines.front(), SizeIs(4));
}

TEST(Triangulation, FillsACombsTeeth) {
  Outline comb{{0, -1}, {20, -1}};
  for (int tooth = 9; tooth >= 0; --tooth) {
    comb.emplace_back(2 * tooth + 1, 0);
    comb.emplace_back(2 * tooth + 0.5, 5);
  }
  comb.emplace_back(0, 0);
  double shoelace = 0.0;
  for (std::size_t i = 0; i < comb.size(); ++i) {
    const Vector2d& a = comb[i];
    const Vector2d& b = comb[(i + 1) % comb.size()];
    shoelace += 0.5 * (a.x() * b.y() - a.y() * b.x());
  }
  EXPECT_NEAR(filledArea({comb}), shoelace, 1e-9);
}

TEST(Triangulation, LeavesHolesInEitherDirection) {
  const Outline hole = rectangle(1, 1, 2, 2);
  EXPECT_DOUBLE_EQ(filledArea({rectangle(0, 0, 4, 4), hole}), 15.0);
  EXPECT_DOUBLE_EQ(filledArea({reversed(hole), rectangle(0, 0, 4, 4)}), 15.0);
}

TEST(Triangulation, FillsIslandsWithinHoles) {
  EXPECT_NEAR(filledArea({rectangle(0, 0, 10, 10), rectangle(1, 1, 9, 9), rectangle(2, 2, 8, 8),
                          rectangle(3, 3, 4, 4), rectangle(6, 3, 7, 4), rectangle(3, 6, 4, 7)}),
              100.0 - 64.0 + 36.0 - 3.0, 1e-9);
}

TEST(Triangulation, LeavesManyHoles) {
  std::vector<Outline> outlines{rectangle(0, 0, 20, 20)};
  for (int i = 0; i < 9; ++i) {
    for (int j = 0; j < 9; ++j) {
      outlines.push_back(rectangle(2 * i + 1, 2 * j + 1, 2 * i + 2, 2 * j + 2));
    }
  }
  EXPECT_NEAR(filledArea(outlines), 400.0 - 81.0, 1e-9);
}

TEST(Triangulation, LeavesARoundHole) {
  Outline circle;
  for (int i = 0; i < 100; ++i) {
    circle.emplace_back(3 + std::cos(0.02 * M_PI * i), 3 + std::sin(0.02 * M_PI * i));
  }
  const double area = 50.0 * std::sin(0.02 * M_PI);  // of the regular polygon
  EXPECT_NEAR(filledArea({rectangle(0, 0, 6, 6), circle}), 36.0 - area, 1e-9);
}

TEST(Triangulation, NamesWhatIsNoOutline) {
  EXPECT_THAT(test::messagesOf(triangulating({{{0, 0}, {1, 0}}})),
              testing::ElementsAre(HasSubstr("has 2 different points; at least 3")));
  EXPECT_THAT(test::messagesOf(triangulating({{{0, 0}, {1, 0}, {0, 0}, {1, 0}}})),
              testing::Not(testing::IsEmpty()));
  EXPECT_THAT(test::messagesOf(triangulating({{{0, 0}, {1, 1}, {2, 2}}})),
              testing::ElementsAre(HasSubstr("encloses no area")));
}

TEST(Triangulation, NamesLinesThatCross) {
  EXPECT_THAT(
      test::messagesOf(triangulating({{{0, 0}, {2, 2}, {2, 0}, {0, 3}}})),
      testing::ElementsAre(AllOf(HasSubstr("crosses itself"), HasSubstr("(2.000, 2.000)"))));
  EXPECT_THAT(test::messagesOf(triangulating({rectangle(0, 0, 2, 2), rectangle(1, 1, 3, 3)})),
              testing::ElementsAre(HasSubstr("crosses itself")));
}

TEST(Extrusion, EnclosesItsVolume) {
  const auto mesh = extrudedMesh({{rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2)}, 2.0});
  double volume = 0.0;  // by the divergence theorem: a hole in the surface would change it
  for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) -> Eigen::Vector3d {
      return mesh->positions[mesh->indices[i + k]].cast<double>() + Eigen::Vector3d(5, 6, 7);
    };
    volume += corner(0).dot(corner(1).cross(corner(2))) / 6.0;
  }
  EXPECT_NEAR(volume, 30.0, 1e-4);
}

TEST(Extrusion, HasNormalsThatPointOutwards) {
  const auto mesh = extrudedMesh({{rectangle(0, 0, 4, 4), rectangle(1, 1, 2, 2)}, 2.0});
  for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return mesh->positions[mesh->indices[i + k]]; };
    const Eigen::Vector3f across =
        (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
    EXPECT_GT(across.dot(mesh->normals[mesh->indices[i]]), 0.99F);
  }
}

}  // namespace triangulation_test
}  // namespace synthetic_dataset::world
