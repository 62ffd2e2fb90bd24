#include <gtest/gtest.h>

#include <pluginlib/class_loader.hpp>

#include "synthetic_dataset/hand_made.h"
#include "synthetic_dataset/tested_writer.h"

using namespace synthetic_dataset;

TEST(BoxTableWriter, HasARowForEachObjectThatIsSeen) {
  pluginlib::ClassLoader<LabelWriter> loader("synthetic_dataset", "synthetic_dataset::LabelWriter");
  const auto writer = loader.createUniqueInstance("box_table_writer/BoxTable");
  const SceneObject cup = handMadeObject("cup", {10, 20, 30, 40});
  const SceneObject fork = hidden(handMadeObject("fork", {50, 60, 10, 10}));
  TestedWriter tested(*writer, {{"table", Value("boxes.csv")}}, handMadeDataset({cup, fork}));

  tested.write(handMadeScene(0, {cup, fork}));

  EXPECT_EQ(tested.finalize().texts.at("/w/boxes.csv"),
            "image,object,class,left,top,right,bottom\n"
            "images/00000000.png,cup,cup_class,9.5,19.5,39.5,59.5\n");
}

int main(int argc, char** argv) {
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
