#include <opencv2/imgcodecs.hpp>

#include <gmock/gmock.h>

#include "world/sdf/sdf_loader_support.h"
#include "world/world_loader.h"

namespace synthetic_dataset::world {
namespace sdf_loader_geometry_test {

using namespace test;

constexpr const char* kSquareWithHole =
    "<polyline><point>0 0</point><point>4 0</point><point>4 4</point><point>0 4</point>"
    "<height>2</height></polyline>"
    "<polyline><point>1 1</point><point>2 1</point><point>2 2</point><point>1 2</point>"
    "<height>2</height></polyline>";

Eigen::AlignedBox3f boxOf(const Mesh& mesh) {
  Eigen::AlignedBox3f box;
  for (const auto& position : mesh.positions) box.extend(position);
  return box;
}

TEST(SdfGeometry, ExtrudesPolylines) {
  const TemporaryFolder folder;
  const Visual visual = loadVisual(folder, visualElement(kSquareWithHole));
  const Mesh& mesh = *visual.surfaces.at(0).mesh;
  EXPECT_EQ(boxOf(mesh).min(), Eigen::Vector3f(0, 0, 0));
  EXPECT_EQ(boxOf(mesh).max(), Eigen::Vector3f(4, 4, 2));
  EXPECT_THAT(mesh.indices, SizeIs(3 * (2 * 8 + 2 * 8))) << "both caps and eight walls";
}

TEST(SdfGeometry, MakesHeightmapsInTheirTextures) {
  const TemporaryFolder folder;
  cv::imwrite((folder / "heights.png").string(), cv::Mat_<uchar>({2, 2}, {0, 100, 100, 200}));
  cv::imwrite((folder / "grass.png").string(), cv::Mat(2, 2, CV_8UC3, cv::Scalar(0, 99, 0)));
  cv::imwrite((folder / "rock.png").string(), cv::Mat(2, 2, CV_8UC3, cv::Scalar(99, 99, 99)));
  const Visual visual = loadVisual(
      folder,
      visualElement("<heightmap><uri>heights.png</uri><size>20 20 5</size><pos>0 0 1</pos>"
                    "<texture><size>2</size><diffuse>grass.png</diffuse><normal>rock.png</normal>"
                    "</texture><texture><size>4</size><diffuse>rock.png</diffuse></texture>"
                    "<blend><min_height>1</min_height><fade_dist>1</fade_dist></blend>"
                    "</heightmap>"));
  ASSERT_THAT(visual.surfaces, SizeIs(2));
  EXPECT_EQ(boxOf(*visual.surfaces[0].mesh).min(), Eigen::Vector3f(-10, -10, 1));
  EXPECT_EQ(boxOf(*visual.surfaces[0].mesh).max(), Eigen::Vector3f(10, 10, 6));
  EXPECT_THAT(visual.surfaces[0].material.texture->file, HasSubstr("grass.png"));
  EXPECT_NE(visual.surfaces[0].material.normal_map, nullptr);
  EXPECT_EQ(visual.surfaces[1].material.normal_map, nullptr);
  EXPECT_THAT(visual.surfaces[1].mesh->colours, SizeIs(4));
}

TEST(SdfGeometry, CollidesWithAllKinds) {
  const TemporaryFolder folder;
  cv::imwrite((folder / "map.png").string(), cv::Mat_<uchar>({2, 2}, {0, 100, 100, 255}));
  const auto collision = [](const std::string& name, const std::string& geometry) {
    return "<collision name='" + name + "'><geometry>" + geometry + "</geometry></collision>";
  };
  const Description world = loadText(
      folder,
      worldFile(modelElement(
          "m",
          "<static>true</static>" +
              linkElement(
                  collision("a", kSquareWithHole) +
                  collision("b", "<heightmap><uri>map.png</uri><size>2 2 1</size></heightmap>") +
                  collision("c",
                            "<image><uri>map.png</uri><scale>0.5</scale><height>2</height>"
                            "<threshold>150</threshold><granularity>1</granularity>"
                            "</image>")))));
  const auto& collisions = world.models.at(0).links.at(0).collisions;
  ASSERT_THAT(collisions, SizeIs(3));
  for (const Collision& each : collisions) {
    EXPECT_FALSE(std::get<MeshShape>(each.shape).mesh->indices.empty());
  }
  EXPECT_EQ(boxOf(*std::get<MeshShape>(collisions[2].shape).mesh).max(), Eigen::Vector3f(1, 1, 2));
  EXPECT_THAT(world.notes, IsEmpty());
}

TEST(SdfGeometry, NotesThatAMovingPolylineCollidesAsItsHull) {
  const TemporaryFolder folder;
  const std::string link = linkElement("<collision name='c'><geometry>" +
                                       std::string(kSquareWithHole) + "</geometry></collision>");
  EXPECT_THAT(loadText(folder, worldFile(modelElement("m", link))).notes,
              Contains(HasSubstr("collision 'c': a polyline; while it moves, its convex hull")));
}

TEST(SdfGeometry, DrawsAVastPlaneAsFarAsAnybodySees) {
  const TemporaryFolder folder;
  const Visual visual = loadVisual(
      folder,
      visualElement("<plane><normal>0 0 1</normal><size>1000000000 1000000000</size></plane>"));
  EXPECT_EQ(boxOf(*visual.surfaces.at(0).mesh).sizes().x(), 1e5F);
}

}  // namespace sdf_loader_geometry_test
}  // namespace synthetic_dataset::world
