#include <locale>
#include <sstream>

#include <gmock/gmock.h>

#include "synthetic_dataset/object_model.h"

namespace synthetic_dataset {
namespace ply_test {

using testing::HasSubstr;

std::string plyOf(const ObjectModel& model, double scale) {
  std::ostringstream stream;
  writePly(stream, model, scale);
  return stream.str();
}

ObjectModel triangle() {
  ObjectModel model;
  model.vertices = {{{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}, {255, 0, 10}},
                    {{0.25, 0.0, 0.0}, {0.0, 0.0, 1.0}, {1, 2, 3}},
                    {{0.0, -1.5, 0.0}, {0.0, 0.0, 1.0}, {0, 0, 0}}};
  model.triangles = {{0, 2, 1}};
  return model;
}

TEST(Ply, HasVerticesWithNormalAndColourAndThenTriangles) {
  EXPECT_EQ(plyOf(triangle(), 1.0),
            "ply\n"
            "format ascii 1.0\n"
            "element vertex 3\n"
            "property float x\n"
            "property float y\n"
            "property float z\n"
            "property float nx\n"
            "property float ny\n"
            "property float nz\n"
            "property uchar red\n"
            "property uchar green\n"
            "property uchar blue\n"
            "element face 1\n"
            "property list uchar int vertex_indices\n"
            "end_header\n"
            "0 0 0 0 0 1 255 0 10\n"
            "0.25 0 0 0 0 1 1 2 3\n"
            "0 -1.5 0 0 0 1 0 0 0\n"
            "3 0 2 1\n");
}

TEST(Ply, ScalesPositionsAndNotNormals) {
  EXPECT_THAT(plyOf(triangle(), 1000.0), HasSubstr("\n250 0 0 0 0 1 1 2 3\n"));
}

TEST(Ply, WritesAModelWithoutSurface) {
  EXPECT_THAT(plyOf({}, 1.0), HasSubstr("element vertex 0\n"));
  EXPECT_THAT(plyOf({}, 1.0), HasSubstr("element face 0\n"));
}

TEST(Ply, TakesTheFewestDigitsThatReadBackAsTheSameFloat) {
  ObjectModel model;
  model.vertices = {{{0.1, 1.0 / 3.0, -0.0}, {0.0, 0.0, 1.0}, {}},
                    {{123456.789, 1e-7, 16777217.0}, {0.0, 0.0, 1.0}, {}}};
  const std::string text = plyOf(model, 1.0);
  EXPECT_THAT(text, HasSubstr("\n0.1 0.33333334 0 0 0 1 "));
  // A float has a significand of 24 bits: it cannot hold 16777217 = 2^24 + 1, and near 123456.789
  // floats are 1/128 apart.
  EXPECT_THAT(text, HasSubstr("\n123456.79 1e-07 16777216 0 0 1 "));
}

class CommaForPoint : public std::numpunct<char> {
  [[nodiscard]] char do_decimal_point() const override { return ','; }
};

TEST(Ply, IsTheSameInEveryLocale) {
  const std::string expected = plyOf(triangle(), 1.0);
  const std::locale earlier = std::locale::global({std::locale(), new CommaForPoint});
  const std::string found = plyOf(triangle(), 1.0);
  std::locale::global(earlier);
  EXPECT_EQ(found, expected);
}

}  // namespace ply_test
}  // namespace synthetic_dataset
