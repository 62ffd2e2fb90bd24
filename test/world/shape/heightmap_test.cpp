#include "world/shape/heightmap.h"

#include <opencv2/imgcodecs.hpp>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace heightmap_test {

using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::FloatNear;
using testing::HasSubstr;
using testing::SizeIs;

/// Writes a picture and returns its file.
template <class Pixel>
std::filesystem::path writePicture(const TemporaryFolder& folder, const cv::Mat_<Pixel>& pixels) {
  const std::string file = (folder / "heights.png").string();
  cv::imwrite(file, pixels);
  return file;
}

Heightmap heightmapOf(const std::filesystem::path& file) {
  Heightmap heightmap;
  heightmap.file = file;
  heightmap.size = {4.0, 2.0, 10.0};
  heightmap.folder = file.parent_path();
  return heightmap;
}

GroundTexture texture(const TemporaryFolder& folder, const std::string& name, double size) {
  cv::imwrite((folder / name).string(), cv::Mat(2, 2, CV_8UC3, cv::Scalar(10, 20, 30)));
  return {name, "", size};
}

TEST(Heightmap, IsAsHighAsItsSizeAtTheBrightestPixel) {
  const TemporaryFolder folder;
  const auto file = writePicture(folder, cv::Mat_<uchar>({2, 2}, {0, 50, 100, 200}));
  EXPECT_THAT(readHeights(heightmapOf(file)).heights, ElementsAre(0.0F, 2.5F, 5.0F, 10.0F));
}

TEST(Heightmap, TakesTheValue1ForWhiteAsGazeboDoes) {
  const TemporaryFolder folder;
  const auto file = writePicture(folder, cv::Mat_<uchar>({2, 2}, {0, 1, 102, 204}));
  EXPECT_THAT(readHeights(heightmapOf(file)).heights,
              ElementsAre(0.0F, FloatNear(10.0F / 255.0F, 1e-6F), FloatNear(4.0F, 1e-6F),
                          FloatNear(8.0F, 1e-6F)));
}

TEST(Heightmap, KeepsThePrecisionOf16Bits) {
  const TemporaryFolder folder;
  const auto file = writePicture(folder, cv::Mat_<ushort>({2, 2}, {0, 1, 2, 50000}));
  EXPECT_THAT(
      readHeights(heightmapOf(file)).heights,
      ElementsAre(0.0F, FloatNear(2e-4F, 1e-7F), FloatNear(4e-4F, 1e-7F), FloatNear(10.0F, 1e-5F)));
}

TEST(Heightmap, TurnsUpsideDownWithANegativeSize) {
  const TemporaryFolder folder;
  Heightmap heightmap = heightmapOf(writePicture(folder, cv::Mat_<uchar>({2, 2}, {0, 0, 0, 9})));
  heightmap.size.z() = -10.0;
  EXPECT_FLOAT_EQ(readHeights(heightmap).heights.back(), -10.0F);
}

TEST(Heightmap, HasThePicturesFirstRowAtTheSideOfPositiveY) {
  const TemporaryFolder folder;
  Heightmap heightmap = heightmapOf(writePicture(folder, cv::Mat_<uchar>({2, 2}, {0, 255, 0, 0})));
  heightmap.centre = {100.0, 200.0, 300.0};
  const auto mesh = heightmapMesh(heightmap);
  EXPECT_EQ(mesh->positions.at(1), Eigen::Vector3f(102.0F, 201.0F, 310.0F));
  EXPECT_EQ(mesh->positions.at(2), Eigen::Vector3f(98.0F, 199.0F, 300.0F));
}

TEST(Heightmap, FacesUpwards) {
  const TemporaryFolder folder;
  const auto file = writePicture(folder, cv::Mat_<uchar>({3, 3}, {0, 9, 5, 100, 7, 50, 3, 2, 200}));
  const auto mesh = heightmapMesh(heightmapOf(file));
  ASSERT_THAT(mesh->indices, SizeIs(3 * 2 * 4));
  for (std::size_t i = 0; i < mesh->indices.size(); i += 3) {
    const auto corner = [&](std::size_t k) { return mesh->positions[mesh->indices[i + k]]; };
    EXPECT_GT((corner(1) - corner(0)).cross(corner(2) - corner(0)).z(), 0.0F);
  }
  for (const auto& normal : mesh->normals) EXPECT_GT(normal.z(), 0.0F);
}

TEST(Heightmap, HasTheNormalOfItsSlope) {
  const TemporaryFolder folder;
  const auto file = writePicture(folder, cv::Mat_<uchar>({2, 2}, {0, 255, 0, 255}));
  const auto mesh = heightmapMesh(heightmapOf(file));  // 10 m up over 4 m
  const Eigen::Vector3f expected = Eigen::Vector3f(-10.0F, 0.0F, 4.0F).normalized();
  for (const auto& normal : mesh->normals) EXPECT_TRUE(normal.isApprox(expected, 1e-5F));
}

TEST(Heightmap, InterpolatesBetweenPixels) {
  const TemporaryFolder folder;
  Heightmap heightmap =
      heightmapOf(writePicture(folder, cv::Mat_<uchar>({2, 2}, {0, 100, 100, 200})));
  heightmap.sampling = 2;
  const HeightGrid grid = readHeights(heightmap);
  EXPECT_EQ(grid.columns, 3);
  EXPECT_FLOAT_EQ(grid.heights.at(1), 2.5F);
  EXPECT_FLOAT_EQ(grid.heights.at(4), 5.0F);
}

TEST(Heightmap, TakesPicturesOfAnySize) {
  const TemporaryFolder folder;
  const auto file = writePicture(folder, cv::Mat_<uchar>(cv::Mat_<uchar>::ones(3, 1500)));
  const HeightGrid grid = readHeights(heightmapOf(file));
  EXPECT_EQ(grid.columns, 1025);
  EXPECT_EQ(grid.rows, 3);
}

void notExpected(const std::string& message) { ADD_FAILURE() << message; }

TEST(Heightmap, RepeatsTexturesByTheirSize) {
  const TemporaryFolder folder;
  Heightmap heightmap = heightmapOf(writePicture(folder, cv::Mat_<uchar>({2, 2}, {0, 0, 0, 9})));
  heightmap.textures = {texture(folder, "grass.png", 0.5)};
  const ResourceFinder finder = test::finderIn(folder);
  TextureLoader textures(finder);
  const auto surfaces = heightmapSurfaces(heightmap, Material{}, textures, notExpected);
  ASSERT_THAT(surfaces, SizeIs(1));
  EXPECT_EQ(surfaces[0].mesh->texture_coordinates.at(0), Eigen::Vector2f(0.0F, 0.0F));
  EXPECT_EQ(surfaces[0].mesh->texture_coordinates.at(3), Eigen::Vector2f(8.0F, 4.0F));
  EXPECT_NE(surfaces[0].material.texture, nullptr);
}

TEST(Heightmap, LaysTexturesOverOneAnotherByHeight) {
  const TemporaryFolder folder;
  // A step: heights 0, 0, 5, 10 m in each row.
  Heightmap heightmap =
      heightmapOf(writePicture(folder, cv::Mat_<uchar>({2, 4}, {0, 0, 100, 200, 0, 0, 100, 200})));
  heightmap.textures = {texture(folder, "grass.png", 1), texture(folder, "rock.png", 1)};
  heightmap.blends = {{2.5, 5.0}};
  const ResourceFinder finder = test::finderIn(folder);
  TextureLoader textures(finder);
  const auto surfaces = heightmapSurfaces(heightmap, Material{}, textures, notExpected);
  ASSERT_THAT(surfaces, SizeIs(2));
  const Mesh& rock = *surfaces[1].mesh;
  EXPECT_EQ(rock.positions, surfaces[0].mesh->positions);
  EXPECT_THAT(surfaces[0].mesh->colours, SizeIs(0));
  ASSERT_THAT(rock.colours, SizeIs(8));
  EXPECT_EQ(rock.colours[1], Eigen::Vector4f(1.0F, 1.0F, 1.0F, 0.0F));
  EXPECT_FLOAT_EQ(rock.colours[2].w(), 0.5F);
  EXPECT_FLOAT_EQ(rock.colours[3].w(), 1.0F);
  EXPECT_THAT(rock.indices, SizeIs(3 * 2 * 2)) << "the low quarter has none of it";
}

TEST(Heightmap, LeavesOutTexturesThatAreHidden) {
  const TemporaryFolder folder;
  Heightmap heightmap = heightmapOf(writePicture(folder, cv::Mat_<uchar>({2, 2}, {9, 9, 9, 9})));
  heightmap.textures = {texture(folder, "a.png", 1), texture(folder, "b.png", 1),
                        texture(folder, "c.png", 1)};
  heightmap.blends = {{5.0, 0.0}, {20.0, 1.0}};
  const ResourceFinder finder = test::finderIn(folder);
  TextureLoader textures(finder);
  const auto surfaces = heightmapSurfaces(heightmap, Material{}, textures, notExpected);
  ASSERT_THAT(surfaces, SizeIs(1));
  EXPECT_THAT(surfaces[0].material.texture->file, HasSubstr("b.png"));
}

TEST(Heightmap, StaysWhereItsPicturesAreMissing) {
  const TemporaryFolder folder;
  Heightmap heightmap = heightmapOf(writePicture(folder, cv::Mat_<uchar>({2, 2}, {9, 9, 9, 9})));
  heightmap.textures = {{"gone.png", "away.png", 1.0}};
  const ResourceFinder finder = test::finderIn(folder);
  TextureLoader textures(finder);
  std::vector<std::string> missing;
  const auto surfaces =
      heightmapSurfaces(heightmap, Material{}, textures,
                        [&](const std::string& message) { missing.push_back(message); });
  ASSERT_THAT(surfaces, SizeIs(1));
  EXPECT_EQ(surfaces[0].material.texture, nullptr);
  EXPECT_THAT(missing, testing::ElementsAre(HasSubstr("gone.png"), HasSubstr("away.png")));
}

TEST(Heightmap, NamesAPictureThatWillNotDo) {
  const TemporaryFolder folder;
  const auto reading = [&](const std::filesystem::path& file) {
    return [file] { static_cast<void>(readHeights(heightmapOf(file))); };
  };
  EXPECT_THAT(test::messagesOf(reading(folder.write("empty.png", ""))),
              testing::ElementsAre(AllOf(HasSubstr("empty.png"), HasSubstr("is empty"))));
  EXPECT_THAT(test::messagesOf(reading(folder.write("text.png", "no picture"))),
              testing::ElementsAre(AllOf(HasSubstr("text.png"), HasSubstr("cannot be decoded"))));
  EXPECT_THAT(test::messagesOf(reading(writePicture(folder, cv::Mat_<uchar>({1, 1}, {9})))),
              testing::ElementsAre(HasSubstr("has 1 x 1 pixels; at least 2 x 2 are needed")));
}

TEST(Heightmap, RefusesAPictureTooLargeToDecode) {
  const TemporaryFolder folder;
  std::string png("\x89PNG\r\n\x1A\n\0\0\0\x0DIHDR\0\x01\x86\xA0\0\x01\x86\xA0\x08\0\0\0\0", 29);
  const auto file = folder.write("vast.png", png);
  EXPECT_THAT(test::messagesOf([&] { static_cast<void>(readHeights(heightmapOf(file))); }),
              testing::ElementsAre(HasSubstr("is too large: 100000 x 100000 pixels")));
}

}  // namespace heightmap_test
}  // namespace synthetic_dataset::world
