#include "config/object_count.h"

#include <string>

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::config {
namespace object_count_test {

Value counted(const std::string& settings) {
  return Value(withCounts(*base::parseYaml(settings, "given").as<Value::Map>()));
}

Value yaml(const std::string& settings) { return base::parseYaml(settings, "expected"); }

TEST(WithCounts, MakesAnObjectMany) {
  EXPECT_EQ(counted("motion: placement\n"
                    "robot_list: [cone, car]\n"
                    "cone: {class: cone, id: 7, model: cone.sdf, count: 3}\n"
                    "car: {class: car, id: red}\n"),
            yaml("motion: placement\n"
                 "robot_list: [cone_1, cone_2, cone_3, car]\n"
                 "cone_1: {class: cone, id: 7, model: cone.sdf}\n"
                 "cone_2: {class: cone, id: 8, model: cone.sdf}\n"
                 "cone_3: {class: cone, id: 9, model: cone.sdf}\n"
                 "car: {class: car, id: red}\n"));
}

TEST(WithCounts, PutsTheNumberBehindAnIdThatIsAText) {
  EXPECT_EQ(counted("motion: placement\nrobot_list: cone\ncone: {class: cone, id: c, count: 2}\n"),
            yaml("motion: placement\nrobot_list: [cone_1, cone_2]\n"
                 "cone_1: {class: cone, id: c_1}\ncone_2: {class: cone, id: c_2}\n"));
}

TEST(WithCounts, SaysOfEachWhatIsSaidOfAllUnlessItHasItsOwn) {
  EXPECT_EQ(counted("motion: placement\n"
                    "robot_list: [cone]\n"
                    "cone: {class: cone, id: 1, count: 2}\n"
                    "randomize: {objects: {cone: {present: 0.5}, cone_2: {present: 0.1}}}\n"
                    "motions: [{robot_list: cone, cone: {safety_radius: 1.0}}]\n"),
            yaml("motion: placement\n"
                 "robot_list: [cone_1, cone_2]\n"
                 "cone_1: {class: cone, id: 1}\n"
                 "cone_2: {class: cone, id: 2}\n"
                 "randomize: {objects: {cone_1: {present: 0.5}, cone_2: {present: 0.1}}}\n"
                 "motions: [{robot_list: [cone_1, cone_2], cone_1: {safety_radius: 1.0}, "
                 "cone_2: {safety_radius: 1.0}}]\n"));
}

TEST(WithCounts, LeavesTheRestToWhoReadsTheSettings) {
  for (const char* settings :
       {"{robot_list: [cone], cone: {count: 3}}",                               // a recording
        "{motion: placement, robot_list: [cone], cone: {class: c}}",            // no count
        "{motion: placement, robot_list: [cone], cone: {class: c, count: 0}}",  // wrong
        "{motion: placement, robot_list: [cone], cone: {class: c, count: many}}",
        "{motion: placement, robot_list: [3, [1]], cone: 4}", "{motion: placement}"}) {
    EXPECT_EQ(counted(settings), yaml(settings)) << settings;
  }
}

}  // namespace object_count_test
}  // namespace synthetic_dataset::config
