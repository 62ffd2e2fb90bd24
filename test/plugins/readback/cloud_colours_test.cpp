#include "plugins/readback/cloud_colours.h"

#include <gmock/gmock.h>

#include "plugins/readback/label_overlay.h"

namespace synthetic_dataset::formats {
namespace cloud_colours_test {

TEST(CloudColours, AreThoseOfTheSameClassInImages) {
  LabelledCloud cloud;
  cloud.classes = {{1, "drone"}, {7, "rover"}};
  const auto colours = classColours(cloud, {"drone", "cup", "rover"});
  EXPECT_EQ(colours.at(1).colour, labelColour(0));
  EXPECT_EQ(colours.at(7).colour, labelColour(2));
}

TEST(CloudColours, AreDullerForClassesOfTheWorld) {
  LabelledCloud cloud;
  cloud.classes = {{1, "rover"}, {2, "floor"}, {3, "Car"}};
  cloud.objects[1] = {"Car", "Car 1", {}};
  const auto colours = classColours(cloud, {"rover"});
  EXPECT_FALSE(colours.at(1).is_of_world);
  EXPECT_TRUE(colours.at(2).is_of_world);
  EXPECT_NE(colours.at(2).colour, labelColour(1));
  EXPECT_FALSE(colours.at(3).is_of_world) << "an object has it, under a name of the format's";
}

}  // namespace cloud_colours_test
}  // namespace synthetic_dataset::formats
