#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgproc.hpp>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace labelme_writer_test {

using nlohmann::json;

class LabelMe : public PluginTest {
 protected:
  LabelMe() : PluginTest("synthetic_dataset/LabelMe") {
    dataset_.classes = {{0, "cup"}, {2, "fork lift"}};
  }

  [[nodiscard]] json contentOf(const Scene& scene,
                               const std::string& path = "train/00000000.json") const {
    return json::parse(filesOf(scene).at(path));
  }
};

TEST_F(LabelMe, DescribesTheImageBesideIt) {
  load({});
  Scene third = scene(3, {});
  third.split = "val";
  third.name = "front/00000003";
  const json content = contentOf(third, "val/front/00000003.json");
  EXPECT_EQ(content["imagePath"], "00000003.png");
  EXPECT_EQ(content["imageHeight"], 480);
  EXPECT_EQ(content["imageWidth"], 640);
  EXPECT_TRUE(content["imageData"].is_null());
  EXPECT_EQ(content["shapes"], json::array());
  EXPECT_EQ(filesOf(third).count("val/front/00000003.png"), 1U);
}

TEST_F(LabelMe, WritesPolygonsThatAreTheMaskWhenFilledWithTheirRim) {
  load({});
  SceneObject ring = seen("a", {100, 100, 50, 50});
  ring.visible_mask = painted(ring.visible_mask(), {120, 120, 10, 10}, false);
  SceneObject dropped = seen("b", {300, 100, 50, 50});
  dropped.dropped = true;
  const json shapes = contentOf(scene(0, {ring, dropped}))["shapes"];
  ASSERT_EQ(shapes.size(), 1U);
  EXPECT_EQ(shapes[0]["label"], "a_class");
  EXPECT_EQ(shapes[0]["description"], "a");
  EXPECT_EQ(shapes[0]["group_id"], 1);
  EXPECT_EQ(shapes[0]["shape_type"], "polygon");
  std::vector<cv::Point> points;
  for (const json& point : shapes[0]["points"]) {
    points.emplace_back(point[0].get<int>(), point[1].get<int>());
  }
  cv::Mat filled(480, 640, CV_8UC1, cv::Scalar(0));
  cv::fillPoly(filled, std::vector<std::vector<cv::Point>>{points}, 255);
  EXPECT_EQ(cv::countNonZero(filled != ring.visible_mask().whole()), 0);
}

TEST_F(LabelMe, WritesRectanglesWhenAskedTo) {
  load({{"shape", "rectangle"}});
  const json shape = contentOf(scene(0, {seen("a", {10, 20, 30, 40})}))["shapes"][0];
  EXPECT_EQ(shape["shape_type"], "rectangle");
  EXPECT_EQ(shape["points"], json({{10.0, 20.0}, {40.0, 60.0}}));
}

TEST_F(LabelMe, ListsTheClassesAsItsConvertersWantThem) {
  load({});
  runAll({});
  EXPECT_EQ(test::readFile(folder() + "labels.txt"), "__ignore__\n_background_\ncup\nfork lift\n");
}

}  // namespace labelme_writer_test
}  // namespace synthetic_dataset
