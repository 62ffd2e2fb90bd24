#include <filesystem>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "output/verify/verification_fixture.h"

namespace synthetic_dataset::output {
namespace wrong_labels_test {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

/// Datasets whose files are as the manifest lists them, and whose labels are wrong.
class WrongLabels : public VerificationTest {
 protected:
  explicit WrongLabels(const std::string& format) : VerificationTest(format) {}

  void write(const Value::Map& parameters = {}) {
    VerificationTest::write({sceneOfBoth(0), sceneOfBoth(1)}, parameters);
    ASSERT_THAT(problems(), IsEmpty());
  }

  void editJson(const std::string& path, const std::function<void(json&)>& change) const {
    json content = json::parse(read(path));
    change(content);
    replace(path, content.dump());
  }

  void editPicture(const std::string& path, const std::function<void(cv::Mat&)>& change) const {
    cv::Mat picture = cv::imread(folder() + path, cv::IMREAD_UNCHANGED);
    ASSERT_FALSE(picture.empty());
    change(picture);
    std::vector<uchar> bytes;
    cv::imencode(".png", picture, bytes);
    replace(path, {bytes.begin(), bytes.end()});
  }

  void swapFiles(const std::string& one, const std::string& other) const {
    const std::string content = read(one);
    replace(one, read(other));
    replace(other, content);
  }
};

const std::string kScene1 = "scene 1, writer 'w': ";
const std::string kOfA = kScene1 + "object 'a' (cup): ";

struct WrongYolo : WrongLabels {
  WrongYolo() : WrongLabels("Yolo") {}
  void SetUp() override { write({{"main_list", "list.txt"}}); }
  // a at 99.5, 99.5, 149.5, 139.5: its centre is at 124.5 / 640, 119.5 / 480.
  const std::string file_ = "00000001.txt";
  const std::string line_ = "cup 0.19453 0.24896 0.07812 0.08333\n";
};

TEST_F(WrongYolo, HaveAnotherClass) {
  edit(file_, "cup", "jug");
  EXPECT_THAT(problems(), ElementsAre(kOfA + "has no label; it should have one",
                                      StartsWith(kScene1 + "found a label of class 'jug' at [")));
}

TEST_F(WrongYolo, HaveABoxThreePixelsAside) {
  edit(file_, line_, "cup 0.19922 0.24896 0.07812 0.08333\n");
  EXPECT_THAT(problems(), ElementsAre(StartsWith(kOfA + "found the box [102.5")));
}

TEST_F(WrongYolo, LackALine) {
  edit(file_, line_, "");
  EXPECT_THAT(problems(), ElementsAre(kOfA + "has no label; it should have one"));
}

TEST_F(WrongYolo, HaveALineTwice) {
  edit(file_, line_, line_ + line_);
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("that no object should have")));
}

TEST_F(WrongYolo, AreThoseOfAnotherScene) {
  edit("00000000.txt", "cup 0.19453", "cup 0.29453");
  swapFiles("00000000.txt", file_);
  EXPECT_THAT(problems(), ElementsAre(StartsWith(kOfA + "found the box")));
}

struct WrongCoco : WrongLabels {
  WrongCoco() : WrongLabels("Coco") {}
  const std::string file_ = "annotations/instances_train.json";

  /// The annotation of `a` in scene 1.
  void editAnnotation(const std::function<void(json&)>& change) const {
    editJson(file_, [&](json& content) { change(content["annotations"][2]); });
  }
};

TEST_F(WrongCoco, HaveAnotherCategory) {
  write();
  editAnnotation([](json& annotation) { annotation["category_id"] = 2; });
  EXPECT_THAT(problems(),
              ElementsAre(kOfA + "has no label; it should have one",
                          StartsWith(kScene1 + "found a label of class 'jug' of " + "object 'a'")));
}

TEST_F(WrongCoco, HaveABoxThreePixelsAside) {
  write();
  editAnnotation([](json& annotation) { annotation["bbox"] = {103, 100, 50, 40}; });
  EXPECT_THAT(problems(), ElementsAre(kOfA + "found the box [102.5, 99.5, 152.5, 139.5]; it " +
                                      "should be [99.5, 99.5, 149.5, 139.5]"));
}

TEST_F(WrongCoco, HaveAnotherMask) {
  write();
  editJson(file_, [](json& content) {
    content["annotations"][2]["segmentation"] = content["annotations"][3]["segmentation"];
  });
  EXPECT_THAT(problems(), ElementsAre(StartsWith(kOfA + "found the mask within [299.5")));
}

TEST_F(WrongCoco, HaveAnotherPolygon) {
  write({{"segmentation", "polygons"}});
  editAnnotation([](json& annotation) { annotation["segmentation"][0][0] = 90; });
  EXPECT_THAT(problems(), ElementsAre(StartsWith(kOfA + "found the polygon within [89.5")));
}

TEST_F(WrongCoco, LackAnAnnotation) {
  write();
  editJson(file_, [](json& content) { content["annotations"].erase(2); });
  EXPECT_THAT(problems(), ElementsAre(kOfA + "has no label; it should have one"));
}

TEST_F(WrongCoco, LackAnImage) {
  write();
  editJson(file_, [](json& content) { content["images"].erase(1); });
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("no file lists '")));
}

struct WrongKitti : WrongLabels {
  WrongKitti() : WrongLabels("Kitti") {}
};

TEST_F(WrongKitti, HaveABoxThreePixelsAside) {
  write();
  edit("training/label_2/000001.txt", " 100.000000 100.000000", " 100.000000 103.000000");
  EXPECT_THAT(problems(), ElementsAre(StartsWith(kOfA + "found the box [99.5, 102.5,")));
}

TEST_F(WrongKitti, LackWhatNobodyNeedCareFor) {
  Scene scene = sceneOfBoth(0);
  scene.objects[0].dropped = true;
  VerificationTest::write({scene});
  ASSERT_THAT(problems(), IsEmpty());
  edit("training/label_2/000000.txt", "DontCare", "cup");
  EXPECT_THAT(problems(), testing::SizeIs(2));
}

struct WrongPascalVoc : WrongLabels {
  WrongPascalVoc() : WrongLabels("PascalVoc") {}
  void SetUp() override { write(); }
};

TEST_F(WrongPascalVoc, HaveABoxOnePixelAside) {
  edit("Annotations/00000001.xml", "<xmin>101<", "<xmin>102<");
  EXPECT_THAT(problems(), ElementsAre(kOfA + "found the box [100.5, 99.5, 149.5, 139.5]; it " +
                                      "should be [99.5, 99.5, 149.5, 139.5]"));
}

TEST_F(WrongPascalVoc, HaveAnotherName) {
  edit("Annotations/00000001.xml", "<name>cup<", "<name>mug<");
  EXPECT_THAT(problems(), testing::SizeIs(2));
}

TEST_F(WrongPascalVoc, HaveAPixelOfAnotherInAMask) {
  editPicture("SegmentationObject/00000001.png", [](cv::Mat& picture) {
    const cv::Vec3b background(0, 0, 0);
    if (picture.channels() == 3) picture.at<cv::Vec3b>(110, 110) = background;
  });
  EXPECT_THAT(problems(), ElementsAre(kOfA + "found the mask of 1999 pixels; it should be 2000"));
}

struct WrongPoses : WrongLabels, testing::WithParamInterface<std::string> {
  WrongPoses() : WrongLabels(GetParam()) {}
};

TEST_P(WrongPoses, AreTold) {
  write();
  // Moves scene 1's `a` a decimetre to the right in the manifest, to a distance of
  // sqrt(0.2^2 + 0.2^2 + 10^2).
  change(
      "UPDATE scene_object SET x = x + 0.1, distance = 10.00399920031984 WHERE scene = 1 AND "
      "object = 0");
  EXPECT_THAT(problems(), ElementsAre(testing::AllOf(StartsWith(kScene1 + "object 'a'"),
                                                     HasSubstr("found the pose [0.1, 0.2, 10; "),
                                                     HasSubstr("should be [0.2, 0.2, 10; "))));
}

INSTANTIATE_TEST_SUITE_P(Formats, WrongPoses,
                         testing::Values("Bop", "Dope", "ImageFolder", "PvNet"),
                         [](const auto& format) { return format.param; });

struct WrongDope : WrongLabels {
  WrongDope() : WrongLabels("Dope") {}
};

TEST_F(WrongDope, LackWhatIsBeforeTheCamera) {
  write();
  editJson("00000001.json", [](json& content) { content["objects"].erase(0); });
  EXPECT_THAT(problems(), ElementsAre(kOfA + "has no label; it should have one"));
}

TEST_F(WrongDope, HaveAWarningThatTheWriterDoesNotGive) {
  write();
  change("INSERT INTO warning VALUES (1, 0, 1, 'writer ''w'': a: part of it is behind', '')");
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("a: part of it is behind\", which it should not")));
}

struct WrongBop : WrongLabels {
  WrongBop() : WrongLabels("Bop") {}
};

TEST_F(WrongBop, HaveTheMasksOfOthers) {
  write();
  swapFiles("train/000000/mask_visib/000001_000000.png",
            "train/000000/mask_visib/000001_000001.png");
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("found the mask within [299.5"),
                                      HasSubstr("found the mask within [99.5")));
}

struct WrongMasks : WrongLabels {
  WrongMasks() : WrongLabels("Cityscapes") {}
};

TEST_F(WrongMasks, OfCityscapesAreTold) {
  write();
  editPicture("gtFine/train/camera/camera_000001_000019_gtFine_instanceIds.png",
              [](cv::Mat& picture) { picture.at<ushort>(110, 110) = 0; });
  EXPECT_THAT(problems(), ElementsAre(kOfA + "found the mask of 1999 pixels; it should be 2000"));
}

struct WrongStvNet : WrongLabels {
  WrongStvNet() : WrongLabels("StvNet") {}
};

TEST_F(WrongStvNet, HaveAnotherMask) {
  write();
  editPicture("a/mask/00000001.png", [](cv::Mat& mask) { mask.at<uchar>(10, 10) = 255; });
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("found the mask within [9.5, 9.5")));
}

struct WrongUltralytics : WrongLabels {
  WrongUltralytics() : WrongLabels("UltralyticsYolo") {}
  const std::string file_ = "labels/train/00000001.txt";
};

TEST_F(WrongUltralytics, HaveAnotherClass) {
  write({{"task", "obb"}});
  edit(file_, [](std::string text) {
    text.front() = '1';
    return text;
  });
  EXPECT_THAT(problems(), testing::SizeIs(2));
}

TEST_F(WrongUltralytics, HaveABoxAPixelWider) {
  write({{"task", "detect"}});
  edit(file_, " 0.07812500 ", " 0.07968750 ");
  EXPECT_THAT(problems(), ElementsAre(StartsWith(kOfA + "found the box [99,")));
}

TEST_F(WrongUltralytics, HaveAPolygonWithAnotherPoint) {
  write({{"task", "segment"}});
  edit(file_, [](std::string text) {
    const std::size_t end = text.find('\n');
    return text.substr(0, end) + " 0.00078125 0.50000000" + text.substr(end);
  });
  EXPECT_THAT(problems(), ElementsAre(StartsWith(kOfA + "found the polygon within [0,")));
}

}  // namespace wrong_labels_test
}  // namespace synthetic_dataset::output
