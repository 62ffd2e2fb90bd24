#include "world/material/gazebo_materials.h"

#include <cstdlib>

#include <gmock/gmock.h>

#include <opencv2/core.hpp>
#include <opencv2/imgcodecs.hpp>

#include "world/material/gazebo_pictures.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace gazebo_materials_test {

using test::TemporaryFolder;
using testing::HasSubstr;

class GazeboMaterialTest : public testing::Test {
 protected:
  ~GazeboMaterialTest() override { unsetenv("GAZEBO_RESOURCE_PATH"); }

  ResourceFinder finderOfResources() const {
    setenv("GAZEBO_RESOURCE_PATH", folder_.path().c_str(), 1);
    return test::finderIn(folder_);
  }

  TemporaryFolder folder_;
  ResourceFinder finder_ = finderOfResources();
  TextureLoader textures_{finder_};
};

TEST_F(GazeboMaterialTest, HasTheColoursOfGazebosScript) {
  const auto grey = gazeboMaterial("Gazebo/Grey", textures_);
  ASSERT_TRUE(grey);
  EXPECT_EQ(grey->diffuse, Eigen::Vector4f(0.7F, 0.7F, 0.7F, 1));
  EXPECT_EQ(gazeboMaterial("Gazebo/FlatBlack", textures_)->diffuse.x(), 0.1F);
  EXPECT_EQ(gazeboMaterial("Gazebo/BlueLaser", textures_)->diffuse, Eigen::Vector4f(0, 0, 1, 0.4F));
  EXPECT_EQ(gazeboMaterial("Gazebo/RedGlow", textures_)->emissive, Eigen::Vector3f(1, 0, 0));
  EXPECT_FALSE(gazeboMaterial("Gazebo/JointAnchor", textures_)->lit);
}

TEST_F(GazeboMaterialTest, IsNothingForOtherNames) {
  EXPECT_FALSE(gazeboMaterial("Grey", textures_));
  EXPECT_FALSE(gazeboMaterial("Gazebo/", textures_));
  EXPECT_FALSE(gazeboMaterial("Gazebo/Gray", textures_));
  EXPECT_THAT(nearGazeboMaterial("Gazebo/Gray"), HasSubstr("did you mean 'Gazebo/Grey'?"));
}

TEST_F(GazeboMaterialTest, SharesItsPicture) {
  const auto wood = gazeboMaterial("Gazebo/Wood", textures_);
  ASSERT_NE(wood->texture, nullptr);
  EXPECT_EQ(wood->texture, gazeboMaterial("Gazebo/Wood", textures_)->texture);
}

TEST_F(GazeboMaterialTest, PrefersThePictureOfAnInstalledGazebo) {
  std::filesystem::create_directories(folder_ / "media/materials/textures");
  cv::imwrite((folder_ / "media/materials/textures/bricks.png").string(),
              cv::Mat(1, 1, CV_8UC3, cv::Scalar(1, 2, 3)));
  EXPECT_EQ(gazeboMaterial("Gazebo/Bricks", textures_)->texture->pixels.at<cv::Vec4b>(0, 0),
            cv::Vec4b(1, 2, 3, 255));
}

TEST(GazeboPicture, IsTheSameEachTime) {
  const cv::Mat first = paintGazeboPicture("wood.jpg");
  EXPECT_EQ(first.type(), CV_8UC4);
  EXPECT_EQ(cv::norm(first, paintGazeboPicture("wood.jpg"), cv::NORM_INF), 0.0);
}

TEST(GazeboPicture, FitsItselfAtItsEdges) {
  for (const char* file : {"wood.jpg", "grass.jpg", "clouds.jpg", "sidewalk.jpg"}) {
    const cv::Mat picture = paintGazeboPicture(file);
    const int last = picture.cols - 1;
    const double seam = cv::norm(picture.col(0), picture.col(last), cv::NORM_L1);
    const double inside = cv::norm(picture.col(last / 2), picture.col(last / 2 + 1), cv::NORM_L1);
    const double grey_level = 3.0 * picture.rows;  // one level in all rows and channels
    EXPECT_LT(seam, 2.0 * inside + grey_level) << file;
  }
}

}  // namespace gazebo_materials_test
}  // namespace synthetic_dataset::world
