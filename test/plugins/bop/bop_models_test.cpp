#include <cmath>

#include <gmock/gmock.h>

#include "plugins/bop/bop_fixture.h"

namespace synthetic_dataset {
namespace bop_models_test {

using nlohmann::json;
using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Pointwise;

class BopModels : public Bop {};

TEST_F(BopModels, DescribesModelsInMillimetresAboutTheirCentres) {
  load({});
  runAll({});
  const json info = jsonOf("models/models_info.json").at("1");
  EXPECT_NEAR(info.at("diameter").get<double>(), 1000.0 * std::sqrt(4.0 + 1.0 + 0.36), 1e-9);
  EXPECT_EQ(info.at("min_x"), -1000.0);
  EXPECT_EQ(info.at("min_z"), -300.0);
  EXPECT_EQ(info.at("size_x"), 2000.0);
  EXPECT_EQ(info.at("size_z"), 600.0);
  EXPECT_EQ(jsonOf("models_eval/models_info.json").at("1"), info);
  EXPECT_EQ(jsonOf("dataset_info.json").at("objects").at(0).at("model_origin"),
            json({0.0, 0.0, 300.0}));
}

TEST_F(BopModels, TakesSymmetriesFromTheObjectsFrameToTheModels) {
  // Half a turn about the vertical line through (0.1, 0), and any turn about the object's own z.
  const Value::List half_turn = {-1, 0, 0, 0.2, 0, -1, 0, 0.0, 0, 0, 1, 0, 0, 0, 0, 1};
  models_[0] = cuboidModel({{0.0, 0.0, 0.0}, {0.2, 0.4, 0.6}});
  load({{"symmetries",
         Value::Map{{"rover", Value::Map{{"discrete", half_turn},
                                         {"continuous", Value::List{Value::Map{
                                                            {"axis", Value::List{0, 0, 2}}}}}}}}}});
  EXPECT_THAT(parameters_.errors(), IsEmpty());
  runAll({});
  const json info = jsonOf("models/models_info.json").at("1");
  // The model's origin is (0.1, 0.2, 0.3): from there the line is 0.2 m back in y.
  EXPECT_THAT(info.at("symmetries_discrete").at(0).get<std::vector<double>>(),
              Pointwise(DoubleNear(1e-9), {-1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, -400.0, 0.0, 0.0,
                                           1.0, 0.0, 0.0, 0.0, 0.0, 1.0}));
  const json& continuous = info.at("symmetries_continuous").at(0);
  EXPECT_EQ(continuous.at("axis"), json({0.0, 0.0, 1.0}));
  EXPECT_THAT(continuous.at("offset").get<std::vector<double>>(),
              Pointwise(DoubleNear(1e-9), {-100.0, -200.0, -300.0}));
}

TEST_F(BopModels, RefusesWhatIsNoSymmetry) {
  load({{"symmetries",
         Value::Map{{"rover", Value::Map{{"discrete", Value::List{Value(Value::List{1, 2, 3})}},
                                         {"continuous", Value::Map{{"axes", 1}}}}},
                    {"rovr", Value::Map{}}}}});
  EXPECT_THAT(
      parameters_.errors(),
      ElementsAre(HasSubstr("w/symmetries/rovr: no object has this name; did you mean 'rover'?"),
                  HasSubstr("w/symmetries/rover/discrete: found [1, 2, 3]; it should be a rigid"),
                  HasSubstr("w/symmetries/rover/continuous: found {axes: 1}; it should be {axis")));
}

TEST_F(BopModels, LetsObjectsShareAModel) {
  load({{"obj_ids", Value::Map{{"rover", 7}, {"lift", 7}}}});
  runAll({scene(0, roverAndLift())});
  const json poses = jsonOf("train/000000/scene_gt.json").at("0");
  EXPECT_EQ(poses.at(0).at("obj_id"), 7);
  EXPECT_EQ(poses.at(1).at("obj_id"), 7);
  EXPECT_TRUE(exists("models/obj_000007.ply"));
  EXPECT_EQ(jsonOf("models/models_info.json").size(), 1U);
}

TEST_F(BopModels, HasNoModelOfAnObjectWithoutSurface) {
  models_[1] = {};
  load({});
  runAll({});
  EXPECT_FALSE(exists("models/obj_000002.ply"));
  EXPECT_FALSE(jsonOf("models/models_info.json").contains("2"));
}

}  // namespace bop_models_test
}  // namespace synthetic_dataset
