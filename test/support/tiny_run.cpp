#include "support/tiny_run.h"

#include <utility>

#include "support/bag_builder.h"

namespace synthetic_dataset::test {
namespace {

constexpr char kWorld[] = R"(<sdf version="1.6"><world name="tiny">
<light name="sun" type="directional"><cast_shadows>true</cast_shadows>
  <direction>0.3 0.4 -1</direction><diffuse>0.8 0.8 0.8 1</diffuse></light>
<model name="floor"><static>true</static><link name="body">
  <collision name="slab"><pose>0 0 -0.1 0 0 0</pose><geometry><box><size>8 8 0.2</size></box></geometry></collision>
  <visual name="slab"><pose>0 0 -0.1 0 0 0</pose><geometry><box><size>8 8 0.2</size></box></geometry>
    <material><ambient>0.3 0.3 0.3 1</ambient><diffuse>0.3 0.3 0.3 1</diffuse></material></visual></link></model>
<model name="ball"><pose>0.3 -0.8 0.6 0 0 0</pose><link name="body">
  <inertial><mass>0.2</mass><inertia><ixx>0.001</ixx><iyy>0.001</iyy><izz>0.001</izz></inertia></inertial>
  <collision name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></collision>
  <visual name="skin"><geometry><sphere><radius>0.1</radius></sphere></geometry></visual></link></model>
%OBJECTS%</world></sdf>
)";

/// A model whose box spans its bounding shape: 0.4 m wide, from the ground up.
std::string boxModel(const std::string& name, const std::string& colour) {
  const std::string box =
      "<pose>0 0 0.2 0 0 0</pose><geometry><box><size>0.4 0.4 0.4</size></box></geometry>";
  return "<model name='" + name + "'><link name='body'><collision name='c'>" + box +
         "</collision><visual name='v'>" + box + "<material><ambient>" + colour +
         " 1</ambient><diffuse>" + colour + " 1</diffuse></material></visual></link></model>\n";
}

constexpr char kCamera[] = R"(image_width: 160
image_height: 120
camera_matrix: {rows: 3, cols: 3, data: [140, 0, 79.5, 0, 140, 59.5, 0, 0, 1]}
distortion_model: plumb_bob
distortion_coefficients: {rows: 1, cols: 5, data: [0, 0, 0, 0, 0]}
)";

Value point(double x, double y, double z) {
  return Value(Value::List{Value(x), Value(y), Value(z)});
}

}  // namespace

TinyRun::TinyRun(std::shared_ptr<const TemporaryFolder> folder) : folder_(std::move(folder)) {
  std::string world = kWorld;
  const std::string place = "%OBJECTS%";
  world.replace(world.find(place), place.size(),
                boxModel("alpha", "0.9 0.2 0.1") + boxModel("bravo", "0.1 0.3 0.9"));
  folder_->write("tiny.world", world);
  folder_->write("camera.yaml", kCamera);
  BagBuilder bag(*folder_ / "tiny.bag");
  bag.fix("map", "bravo/base_link", milliseconds(1000), poseAt(0.0, 1.0, 0.0));
  for (int i = 0; i <= 20; ++i) {
    bag.move("map", "alpha/base_link", milliseconds(1000 + 50 * i),
             poseAt(0.0, -0.5 + 0.05 * i, 0.0));
  }
  bag.close();
}

Value::Map TinyRun::object(const std::string& id) {
  Value::List corners;
  for (const double x : {-0.2, 0.2}) {
    for (const double y : {-0.2, 0.2}) {
      for (const double z : {0.0, 0.4}) corners.push_back(point(x, y, z));
    }
  }
  return {{"class", Value("box")},
          {"id", Value(id)},
          {"keypoints", Value(Value::List{point(0.2, 0, 0.4), point(-0.2, 0, 0.4)})},
          {"bounding_shape", Value(corners)}};
}

Value::Map TinyRun::parameters() const {
  const auto file = [&](const char* name) { return Value((*folder_ / name).string()); };
  // Three metres in front of the objects and half a metre up, looking along the global +x.
  const Value::List pose = {Value(-3.0), Value(0.2),  Value(0.5), Value(-0.5),
                            Value(0.5),  Value(-0.5), Value(0.5)};
  return {{"bag_file", file("tiny.bag")},
          {"simulated_rate", Value(4.0)},
          {"world", file("tiny.world")},
          {"camera", Value(Value::Map{{"info_file", file("camera.yaml")}, {"pose", Value(pose)}})},
          {"robot_list", Value(Value::List{Value("alpha"), Value("bravo")})},
          {"alpha", Value(object("alpha"))},
          {"bravo", Value(object("bravo"))},
          {"background_subtractor",
           Value(Value::Map{{"history_length", Value(1)}, {"var_threshold", Value(16.0)}})},
          {"output_folder", file("out")},
          {"yolo", Value(Value::Map{{"main_list", Value("list.txt")}})},
          {"bounding_shape", Value(Value::Map{{"output_frame", Value("map")}})}};
}

}  // namespace synthetic_dataset::test
