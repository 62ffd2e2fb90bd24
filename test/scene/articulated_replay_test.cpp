/// Objects whose links follow the recording, from a bag to labels.

#include <filesystem>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>

#include "run/generator.h"
#include "run/setup/run_setup.h"
#include "scene/object_motion.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"
#include "support/robot_arm.h"
#include "support/tiny_run.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::scene {
namespace articulated_replay_test {

using test::milliseconds;
using test::poseAt;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

Pose turnedAboutY(const Eigen::Vector3d& position, double angle) {
  return makePose(position, Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY())));
}

/// The tiny run, in which alpha is the robot arm and its shoulder and elbow turn.
class ArticulatedReplay : public testing::Test {
 protected:
  void SetUp() override {
    test::preparePluginEnvironment();
    alpha = test::TinyRun::object("alpha");
    alpha["model"] = Value(run.folder().write("arm.urdf", test::kRobotArm).string());
    alpha.erase("bounding_shape");
    parameters["robot_list"] = Value(Value::List{Value("alpha")});
  }

  /// Poses of the moving links in their parents, i times 50 ms after the start.
  static Pose shoulder(int i) { return poseAt(0, 0, 0.2, 0.1 * i); }
  static Pose elbow(int i) { return turnedAboutY({0, 0, 0.5}, -0.06 * i); }

  /// The arm as in many URDFs: the root is a point on the ground, 0.3 m below the base.
  static std::string armAboveTheGround() {
    std::string model = test::kRobotArm;
    const std::string before = "  <link name=\"nose\"/>";
    return model.replace(
        model.find(before), before.size(),
        before +
            "<link name='ground'/><joint name='lift' type='fixed'><parent "
            "link='ground'/><child link='base_link'/><origin xyz='0 0 0.3'/></joint>");
  }

  /// Records the links' frames below `prefix`, from the sample `first` on.
  void recordLinks(const std::string& prefix = "alpha/", int first = 0) {
    test::BagBuilder bag(run.folder() / "links.bag");
    for (int i = 0; i <= 20; ++i) {
      const Stamp stamp = milliseconds(1000 + 50 * i);
      bag.move("alpha/base_link", prefix + "upper", stamp, shoulder(i));
      if (i >= first) bag.move(prefix + "upper", prefix + "fore", stamp, elbow(i));
    }
    bag.close();
    parameters["bag_file"] = Value(Value::List{Value((run.folder() / "tiny.bag").string()),
                                               Value((run.folder() / "links.bag").string())});
  }

  run::MotionSetup setUp() {
    parameters["alpha"] = Value(alpha);
    return std::move(run::setUpRun(Value(parameters), {test::pluginXml()}).motions.front());
  }

  std::vector<std::string> errors() {
    return test::messagesOf([&] { setUp(); });
  }

  using LinkPoses = std::map<std::string, Pose>;

  /// X_WL of alpha's links in the scene at 1000 + 50 i ms, after all earlier scenes have been run.
  LinkPoses linksAt(const run::MotionSetup& setup, ObjectMotion& motion, int i) {
    for (const Stamp stamp : setup.timeline.stamps) {
      if (stamp <= reached) continue;
      if (stamp > milliseconds(1000 + 50 * i)) break;
      reached = stamp;
      setup.world->advanceTo(stamp,
                             [&](int object, Stamp time) { return motion.at(object, time); });
    }
    LinkPoses poses;
    for (std::size_t k = 0; k < setup.world->links().size(); ++k) {
      const world::LinkInstance& link = setup.world->links()[k];
      if (link.object == 0) poses[link.link->name] = setup.world->linkPoses()[k];
    }
    return poses;
  }

  LinkPoses linksAt(int i) {
    reached = Stamp(0);
    const run::MotionSetup setup = setUp();
    ObjectMotion motion(*setup.frames, setup.config.objects, setup.world->links(),
                        setup.driven_links);
    return linksAt(setup, motion, i);
  }

  /// The pose of the base in the tiny run's bag.
  static Pose base(int i) { return poseAt(0.0, -0.5 + 0.05 * i, 0.0); }

  test::TinyRun run;
  Value::Map parameters = run.parameters();
  Value::Map alpha;
  Stamp reached{0};  ///< the world's time
};

void expectAt(const Pose& found, const Pose& expected) {
  EXPECT_TRUE(found.matrix().isApprox(expected.matrix(), 1e-9)) << "found\n"
                                                                << found.matrix() << "\nexpected\n"
                                                                << expected.matrix();
}

TEST_F(ArticulatedReplay, LinksFollowTheirFrames) {
  recordLinks();
  LinkPoses links = linksAt(15);
  expectAt(links["base_link"], base(15));
  expectAt(links["upper"], base(15) * shoulder(15));
  expectAt(links["fore"], base(15) * shoulder(15) * elbow(15));
}

TEST_F(ArticulatedReplay, LinksWithoutTfRideOnTheirParents) {
  recordLinks();
  LinkPoses links = linksAt(10);
  expectAt(links["gripper"], base(10) * shoulder(10) * elbow(10) * poseAt(0, 0, 0.42));
  expectAt(links["nose"], base(10) * poseAt(0.2, 0, 0.1));
}

TEST_F(ArticulatedReplay, WithoutTfForLinksTheModelMovesAsOnePiece) {
  const run::MotionSetup setup = setUp();
  EXPECT_THAT(setup.driven_links, ElementsAre(ElementsAre(IsEmpty())));
  EXPECT_THAT(setup.diagnostics.messages(base::Severity::kNote),
              ElementsAre("alpha: no TF moves its joints 'shoulder', 'elbow', "
                          "'slide'; they stay where the model places them"));
  expectAt(linksAt(5)["gripper"], base(5) * poseAt(0, 0, 1.12));
}

TEST_F(ArticulatedReplay, NotesSayHowManyLinksFollow) {
  recordLinks();
  EXPECT_THAT(
      setUp().diagnostics.messages(base::Severity::kNote),
      ElementsAre("alpha: 3 of 5 links follow TF", HasSubstr("no TF moves its joints 'slide'")));
}

TEST_F(ArticulatedReplay, FramesMayHaveNoPrefix) {
  recordLinks("");
  alpha["link_frames"] = Value("{link}");
  expectAt(linksAt(15)["fore"], base(15) * shoulder(15) * elbow(15));
}

TEST_F(ArticulatedReplay, FramesMayBeNamedOneByOne) {
  recordLinks("weird_");
  alpha["link_frames"] = Value(Value::Map{{"upper", Value("weird_upper")}});
  LinkPoses links = linksAt(15);
  expectAt(links["upper"], base(15) * shoulder(15));
  expectAt(links["fore"], base(15) * shoulder(15) * poseAt(0, 0, 0.5));
}

TEST_F(ArticulatedReplay, NamesLinksAndFramesThatDoNotExist) {
  recordLinks();
  alpha["link_frames"] =
      Value(Value::Map{{"uper", Value("alpha/upper")}, {"fore", Value("alpha/four")}});
  EXPECT_THAT(errors(), testing::UnorderedElementsAre(
                            AllOf(HasSubstr("alpha/link_frames/uper: the model has no link 'uper'"),
                                  HasSubstr("did you mean 'upper'?")),
                            AllOf(HasSubstr("alpha/link_frames/fore: the recording has no frame"),
                                  HasSubstr("did you mean 'alpha/fore'?"))));
}

TEST_F(ArticulatedReplay, TheErrorAboutAFramesPrefixNamesTheSettingThatMendsIt) {
  alpha["frame"] = Value("robots/alpha/base_link");
  EXPECT_THAT(errors(),
              Contains("alpha/frame: found no frame 'robots/alpha/base_link' in the "
                       "recording; in the group alpha, `frame: alpha/base_link` names one "
                       "in full"));
}

TEST_F(ArticulatedReplay, TheObjectsFrameMayBeNamedWhole) {
  alpha["frame"] = Value("bravo/base_link");
  alpha["link_frames"] = Value("unknown/{link}");
  expectAt(linksAt(5)["base_link"], poseAt(0.0, 1.0, 0.0));
}

TEST_F(ArticulatedReplay, ALinkOfTheObjectsFrameStandsThereWhereLinksFollowTf) {
  recordLinks();
  alpha["model"] = Value(armAboveTheGround());
  LinkPoses links = linksAt(15);
  expectAt(links["base_link"], base(15));
  expectAt(links["fore"], base(15) * shoulder(15) * elbow(15));
  expectAt(links["ground"], base(15) * poseAt(0, 0, -0.3));
}

TEST_F(ArticulatedReplay, TheLinkThatTheObjectsFrameNamesStandsThereAlone) {
  alpha["model"] = Value(armAboveTheGround());
  LinkPoses links = linksAt(5);
  expectAt(links["base_link"], base(5));
  expectAt(links["ground"], base(5) * poseAt(0, 0, -0.3));
  expectAt(links["gripper"], base(5) * poseAt(0, 0, 1.12));
  EXPECT_THAT(setUp().diagnostics.messages(base::Severity::kNote),
              Contains("alpha: its link 'base_link' stands at the frame 'alpha/base_link'; the "
                       "model's origin is 0.300 m from it"));
}

TEST_F(ArticulatedReplay, SoDoesOneOfAnSdfModelWhateverThePrefix) {
  alpha["model"] = Value(
      "<sdf version='1.6'><model name='cart'><link name='body'><pose>0 0 0.4 0 0 0</pose>"
      "<visual name='v'><geometry><box><size>0.4 0.4 0.4</size></box></geometry></visual></link>"
      "<link name='base_link'><pose>0.5 0 0.1 0 0 0</pose></link><joint name='j' type='fixed'>"
      "<parent>body</parent><child>base_link</child></joint></model></sdf>");
  alpha["frame"] = Value("bravo/base_link");
  alpha["link_frames"] = Value("unknown/{link}");
  LinkPoses links = linksAt(5);
  expectAt(links["base_link"], poseAt(0.0, 1.0, 0.0));
  expectAt(links["body"], poseAt(-0.5, 1.0, 0.3));
}

TEST_F(ArticulatedReplay, AFrameThatNamesNoLinkCarriesTheModelsOrigin) {
  std::string model = armAboveTheGround();
  for (std::size_t at = model.find("base_link"); at != std::string::npos;
       at = model.find("base_link")) {
    model.replace(at, std::string("base_link").size(), "trunk");
  }
  alpha["model"] = Value(model);
  LinkPoses links = linksAt(5);
  expectAt(links["ground"], base(5));
  expectAt(links["trunk"], base(5) * poseAt(0, 0, 0.3));
}

TEST_F(ArticulatedReplay, ALinkThatFollowsAnotherFrameIsNotTheOneThatItsNameNames) {
  recordLinks("weird_");
  alpha["model"] = Value(armAboveTheGround());
  alpha["link_frames"] = Value(Value::Map{{"base_link", Value("weird_upper")}});
  LinkPoses links = linksAt(15);
  expectAt(links["ground"], base(15));
  expectAt(links["base_link"], base(15) * shoulder(15));
}

/// The angles of shoulder() and elbow() as joint states.
std::string jointBag(const std::filesystem::path& file) {
  test::BagBuilder bag(file);
  for (int i = 0; i <= 20; ++i) {
    bag.bend("/joint_states", milliseconds(1000 + 50 * i),
             {{"shoulder", 0.1 * i}, {"elbow", -0.06 * i}, {"wheel", 0.0}});
  }
  return bag.close();
}

TEST_F(ArticulatedReplay, LinksFollowJointStatesWhereTfHasNoneOfThem) {
  parameters["bag_file"] = Value(Value::List{Value((run.folder() / "tiny.bag").string()),
                                             Value(jointBag(run.folder() / "joints.bag"))});
  LinkPoses links = linksAt(15);
  expectAt(links["upper"], base(15) * shoulder(15));
  expectAt(links["fore"], base(15) * shoulder(15) * elbow(15));
  expectAt(links["gripper"], base(15) * shoulder(15) * elbow(15) * poseAt(0, 0, 0.42));
  EXPECT_THAT(setUp().diagnostics.messages(base::Severity::kWarning),
              Contains(HasSubstr("the joints of 'alpha' follow the topic /joint_states")));
}

TEST_F(ArticulatedReplay, TfGoesBeforeJointStates) {
  recordLinks();
  const std::string joints = jointBag(run.folder() / "joints.bag");
  Value::List bags = *parameters["bag_file"].as<Value::List>();
  bags.emplace_back(joints);
  parameters["bag_file"] = Value(bags);
  EXPECT_THAT(setUp().diagnostics.messages(base::Severity::kWarning),
              testing::Each(testing::Not(HasSubstr("/joint_states"))));
}

TEST_F(ArticulatedReplay, AGapLeavesTheLinkInPlaceAndTheSceneIn) {
  recordLinks("alpha/", 8);
  const run::MotionSetup setup = setUp();
  EXPECT_THAT(setup.timeline.stamps, SizeIs(4));
  ObjectMotion motion(*setup.frames, setup.config.objects, setup.world->links(),
                      setup.driven_links);
  LinkPoses early = linksAt(setup, motion, 5);
  expectAt(early["fore"], base(5) * shoulder(5) * poseAt(0, 0, 0.5));
  expectAt(early["gripper"], base(5) * shoulder(5) * poseAt(0, 0, 0.92));
  EXPECT_THAT(motion.takeGaps(), ElementsAre(AllOf(HasSubstr("'alpha'"), HasSubstr("'alpha/fore'"),
                                                   HasSubstr("link 'fore'"))));
  LinkPoses late = linksAt(setup, motion, 15);
  expectAt(late["fore"], base(15) * shoulder(15) * elbow(15));
  EXPECT_THAT(motion.takeGaps(), SizeIs(1)) << "of another scene";
}

TEST_F(ArticulatedReplay, TheModelBoxFollowsTheLinks) {
  recordLinks();
  const run::MotionSetup setup = setUp();
  ObjectMotion motion(*setup.frames, setup.config.objects, setup.world->links(),
                      setup.driven_links);
  LinkPoses links = linksAt(setup, motion, 15);
  const auto shape = setup.shapes->at(motion.objectPoses(milliseconds(1750)))[0];

  // The elbow is bent by 0.9 rad: the gripper's ball reaches highest, and farthest towards -y.
  const Eigen::Vector3d gripper_O = base(15).inverse() * links["gripper"].translation();
  ASSERT_THAT(shape.bounding_shape_O, SizeIs(8));
  EXPECT_NEAR(shape.bounding_shape_O.back().z(), gripper_O.z() + 0.06, 2e-4);
  EXPECT_NEAR(shape.bounding_shape_O.front().z(), 0.0, 1e-6);
  EXPECT_NEAR(shape.bounding_shape_O.back().x(), 0.2, 1e-6);
  EXPECT_NEAR(shape.bounding_shape_O.front().y(), std::min(-0.2, gripper_O.y() - 0.06), 2e-4);
}

TEST_F(ArticulatedReplay, KeypointsMoveWithTheirLinks) {
  recordLinks();
  alpha["keypoints"] = Value(Value::Map{{"farthest_points", Value(9)}});
  const run::MotionSetup setup = setUp();
  ObjectMotion motion(*setup.frames, setup.config.objects, setup.world->links(),
                      setup.driven_links);
  LinkPoses links = linksAt(setup, motion, 15);
  const auto shape = setup.shapes->at(motion.objectPoses(milliseconds(1750)))[0];
  ASSERT_THAT(shape.keypoints_O, SizeIs(9));
  // The top of the upright arm is one of the farthest points; it has moved with the gripper.
  const Eigen::Vector3d gripper_O = base(15).inverse() * links["gripper"].translation();
  EXPECT_THAT(shape.keypoints_O, Contains(testing::Truly([&](const Eigen::Vector3d& p_O) {
                return (p_O - gripper_O).norm() < 0.0601;
              })));
}

TEST_F(ArticulatedReplay, MasksFollowTheLinks) {
  recordLinks();
  alpha["keypoints"] = Value(Value::List{});
  parameters["alpha"] = Value(alpha);
  run::Reporter reporter;
  run::Generator generator(Value(parameters), reporter, {test::pluginXml()});
  EXPECT_EQ(generator.run().scenes, 4);
  const CameraModel camera(160, 120, {140, 140, 79.5, 59.5}, 0.05, 100.0);
  Eigen::Matrix3d R_GC;
  R_GC << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  const Pose X_GC = makePose({-3.0, 0.2, 0.5}, Eigen::Quaterniond(R_GC));
  for (int scene = 0; scene < 4; ++scene) {
    const int i = 5 * scene;
    const cv::Mat mask = cv::imread(
        (run.folder() / "out/stvnet/alpha/mask/0000000").string() + std::to_string(scene) + ".png",
        cv::IMREAD_GRAYSCALE);
    ASSERT_FALSE(mask.empty());
    const auto isSeen = [&](const Pose& X_GL) {
      const auto pixel = camera.project(X_GC.inverse() * X_GL.translation());
      return mask.at<unsigned char>(cv::Point(static_cast<int>(std::lround(pixel->x())),
                                              static_cast<int>(std::lround(pixel->y())))) == 255;
    };
    const Pose X_GF = base(i) * shoulder(i) * elbow(i);
    EXPECT_TRUE(isSeen(X_GF * poseAt(0, 0, 0.2))) << scene;
    EXPECT_TRUE(isSeen(X_GF * poseAt(0, 0, 0.42))) << scene;
    if (scene == 3) {
      EXPECT_FALSE(isSeen(base(i) * poseAt(0, 0, 1.12))) << "where it was upright";
    }
  }
}

TEST_F(ArticulatedReplay, TheModelsBoxNeedsAModelThatCanBeSeen) {
  alpha["model"] = Value("<robot name='r'><link name='base_link'/></robot>");
  alpha["keypoints"] = Value("farthest_points: 5");
  EXPECT_THAT(errors(),
              testing::UnorderedElementsAre(
                  AllOf(HasSubstr("alpha/bounding_shape: model_box"), HasSubstr("visuals")),
                  AllOf(HasSubstr("alpha/keypoints: farthest_points"), HasSubstr("visuals"))));
}

}  // namespace articulated_replay_test
}  // namespace synthetic_dataset::scene
