#include <gmock/gmock.h>

#include "plugins/plugin_harness.h"

namespace synthetic_dataset {
namespace bounding_shape_writer_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pair;

class BoundingShape : public PluginTest {
 protected:
  BoundingShape() : PluginTest("synthetic_dataset/BoundingShape") {}

  /// A scene that knows the frame `sensor`: 1 m along the x axis of `map`, a quarter turn about z.
  [[nodiscard]] static Scene sceneWithSensor(std::vector<SceneObject> objects) {
    Scene result = scene(5, std::move(objects));
    result.setTransforms([](const std::string& target, const std::string& source) -> Pose {
      EXPECT_EQ(target, "sensor");
      EXPECT_EQ(source, "map");
      // p_map = (1, 0, 0) + R p_sensor with R (x, y, z) = (-y, x, z), hence
      // p_sensor = (y, 1 - x, z) of p_map.
      Pose X_SG = Pose::Identity();
      X_SG.linear() << 0.0, 1.0, 0.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0;
      X_SG.translation() << 0.0, 1.0, 0.0;
      return X_SG;
    });
    return result;
  }
};

TEST_F(BoundingShape, WritesIdAndVerticesInTheOutputFrame) {
  load({{"output_frame", "sensor"}});
  SceneObject shaped = object("a");  // at (0, 0, 10) in map
  shaped.bounding_shape_O = {{0.25, 0.5, -1.0}, {-0.125, 0.0, 2.0}};
  EXPECT_THAT(filesOf(sceneWithSensor({shaped})),
              ElementsAre(Pair("00000005.png", "<image>"), Pair("00000005.txt",
                                                                "a_id 0.50000 0.75000 9.00000 "
                                                                "0.00000 1.12500 12.00000\n")));
}

TEST_F(BoundingShape, LabelsObjectsOutOfViewToo) {
  load({{"output_frame", "sensor"}});
  SceneObject outside = object("z");
  outside.bounding_shape_O = {{0.0, 1.0, -20.0}};
  SceneObject inside = object("a");
  inside.bounding_shape_O = {{0.0, 1.0, 0.0}};
  EXPECT_EQ(filesOf(sceneWithSensor({outside, inside})).at("00000005.txt"),
            "z_id 1.00000 1.00000 -10.00000\na_id 1.00000 1.00000 10.00000\n");
}

TEST_F(BoundingShape, NeedsItsOutputFrame) {
  EXPECT_THAT(load({{"output_frame", "sensor"}}).requirements().frames, ElementsAre("sensor"));
}

TEST_F(BoundingShape, NeedsTheParameterOutputFrame) {
  load({});
  EXPECT_THAT(parameters_.errors(), ElementsAre(HasSubstr("w/output_frame: required")));
}

TEST_F(BoundingShape, IgnoresTheOriginalsTimeout) {
  load({{"output_frame", "sensor"}, {"tf_timeout", 1.0}});
  EXPECT_THAT(parameters_.unknownNames(), IsEmpty());
}

}  // namespace bounding_shape_writer_test
}  // namespace synthetic_dataset
