#include <gmock/gmock.h>

#include "base/yaml_value.h"
#include "config/readers.h"

namespace synthetic_dataset::config {
namespace standing_config_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

struct Reading {
  explicit Reading(const std::string& group)
      : root(
            base::parseYaml("robot_list: [car]\ncar: {class: car, id: 1, " + group + "}", "test")) {
    objects = readObjects(root);
  }
  Parameters root;
  std::vector<scene::ObjectOptions> objects;
};

TEST(ReadStanding, TakesAPoseByAnglesOrByNumbers) {
  const Reading by_angles("model: /car.sdf, pose: {position: [1, 2, 3], rpy: [0, 0, 1.5707963]}");
  EXPECT_THAT(by_angles.root.errors(), IsEmpty());
  const scene::ObjectOptions& car = by_angles.objects.at(0);
  EXPECT_TRUE(car.stands);
  EXPECT_TRUE(car.X_GM->translation().isApprox(Eigen::Vector3d(1, 2, 3)));
  EXPECT_TRUE(car.X_GM->linear().col(0).isApprox(Eigen::Vector3d(0, 1, 0), 1e-6));
  const Reading by_numbers("model: /car.sdf, pose: [1, 2, 3, 0, 0, 0.7071068, 0.7071068]");
  EXPECT_TRUE(by_numbers.objects.at(0).X_GM->isApprox(*car.X_GM, 1e-6));
}

TEST(ReadStanding, TakesTheWorldsOwnPose) {
  const Reading reading("pose: world");
  EXPECT_THAT(reading.root.errors(), IsEmpty());
  EXPECT_TRUE(reading.objects.at(0).stands);
  EXPECT_FALSE(reading.objects.at(0).X_GM.has_value());
  EXPECT_FALSE(Reading("frame: base_link").objects.at(0).stands);
}

TEST(ReadStanding, RefusesWhatContradictsIt) {
  EXPECT_THAT(Reading("pose: world, frame: odom").root.errors(),
              ElementsAre(HasSubstr("car/frame: found together with pose")));
  EXPECT_THAT(Reading("pose: world, model: /car.sdf").root.errors(),
              ElementsAre(HasSubstr("car/pose: found world together with model")));
  EXPECT_THAT(Reading("pose: [1, 2, 3]").root.errors(),
              ElementsAre(HasSubstr("car/pose: found 3 numbers; it should be [x, y, z, qx")));
}

}  // namespace standing_config_test
}  // namespace synthetic_dataset::config
