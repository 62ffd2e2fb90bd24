/// Runs whose objects wear one of several models, in one of several sizes.

#include <filesystem>
#include <fstream>
#include <sstream>

#include <gmock/gmock.h>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "randomize/appearance/object_variety.h"
#include "run/merger.h"
#include "run_fixture.h"
#include "support/writers/plugin_environment.h"
#include "world/files/resource_finder.h"
#include "world/world_loader.h"

namespace synthetic_dataset::run {
namespace worn_models_test {

namespace fs = std::filesystem;
using test::AllAtOnceRun;
using test::StoppingReporter;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::SizeIs;

using Files = std::map<std::string, std::string>;

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

/// An SDF model whose shape stands on its origin.
std::string modelText(const std::string& shape, double height, const std::string& colour) {
  const std::string body = "<pose>0 0 " + std::to_string(0.5 * height) + " 0 0 0</pose><geometry>" +
                           shape + "</geometry>";
  return "<sdf version='1.6'><model name='m'><link name='body'><collision name='c'>" + body +
         "</collision><visual name='v'>" + body + "<material><diffuse>" + colour +
         " 1</diffuse></material></visual></link></model></sdf>";
}

std::string box(double side) {
  const std::string length = std::to_string(side);
  return modelText("<box><size>" + length + " " + length + " " + length + "</size></box>", side,
                   "0.1 0.3 0.9");
}

std::string cylinder(double height) {
  return modelText("<cylinder><radius>" + std::to_string(0.25 * height) + "</radius><length>" +
                       std::to_string(height) + "</length></cylinder>",
                   height, "0.2 0.8 0.2");
}

/// What `bravo` wears in a scene.
struct Worn {
  std::string model;
  double scale = 0.0;
};

std::map<std::int64_t, Worn> wornIn(const std::string& folder) {
  const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement row(manifest, "SELECT scene, name, value FROM draw");
  std::map<std::int64_t, Worn> worn;
  while (row.step()) {
    const Value value = yaml(row.text(2));  // JSON is YAML
    if (row.text(1) == "objects/bravo/model") worn[row.integer(0)].model = value.text();
    if (row.text(1) == "objects/bravo/scale") worn[row.integer(0)].scale = *value.as<double>();
  }
  return worn;
}

// --- Against runs that have the one model, in its size, from its file ---

class WornModelsTest : public test::RunFixture {
 protected:
  WornModelsTest() {
    parameters["simulated_rate"] = Value(8.0);
    parameters["writers"] = yaml(
        "[{name: yolo, type: synthetic_dataset/Yolo}, {name: kitti, type: synthetic_dataset/Kitti},"
        " {name: bounding_shape, type: synthetic_dataset/BoundingShape},"
        " {name: folder, type: synthetic_dataset/ImageFolder}]");
    setBravo("[]", 1.0);
  }

  std::string write(const std::string& name, const std::string& text) const {
    const fs::path path = run.folder() / name;
    std::ofstream(path) << text;
    return path.string();
  }

  /// Gives `bravo` a model, with explicit keypoints and bounding shape in this size.
  void setBravo(const std::string& model, double scale) {
    std::ostringstream text;
    const double h = 0.2 * scale;
    text << "{class: box, id: bravo, model: " << model << ", keypoints: [[" << h << ", 0, " << 2 * h
         << "], [0, 0, " << h << "]], bounding_shape: [[" << -h << ", " << -h << ", 0], [" << h
         << ", " << h << ", " << 2 * h << "]]}";
    parameters["bravo"] = yaml(text.str());
  }

  /// The files of one scene, without the manifest and other dataset-wide files.
  static Files ofScene(std::int64_t scene, const Files& files) {
    Files result;
    for (const auto& [name, bytes] : files) {
      const std::string stem = fs::path(name).stem().string();
      const std::string number = std::to_string(scene);
      if (stem.size() < 6 || stem.find_first_not_of('0') == std::string::npos) {
        if (scene == 0 && stem.size() >= 6) result[name] = bytes;
        continue;
      }
      if (stem.substr(stem.find_first_not_of('0')) == number) result[name] = bytes;
    }
    return result;
  }
};

/// A model that is never worn pushes nothing, wherever it is in the list: a block that would be all
/// around the falling ball.
TEST_F(WornModelsTest, PropsSettleAboutWhatIsWorn) {
  parameters["physics"] = yaml("{settle: 2.0}");
  const std::string block = write("block.sdf", box(0.7));
  const std::string post = write("post.sdf", box(0.4));
  setBravo(post, 1.0);
  const auto filesWith = [&](const std::string& models, const std::string& weights) {
    parameters["randomize"] =
        yaml("{objects: {alpha: {model: {choice: [" + models + "], weights: [" + weights + "]}}}}");
    Files files = filesAnew();
    files.erase("manifest.sqlite");  // which contains the settings
    return files;
  };
  const Files without = filesWith("'" + post + "'", "1");
  EXPECT_GT(without.size(), 30U);
  EXPECT_TRUE(filesWith("'" + block + "', '" + post + "'", "0, 1") == without);
  EXPECT_FALSE(filesWith("'" + block + "', '" + post + "'", "1, 0") == without);
}

class WornModels : public WornModelsTest, public ::testing::WithParamInterface<const char*> {};

TEST_P(WornModels, AreSeenAndLabelledAsIfTheyWereTheOnlyOnes) {
  const std::string small_box = write("box.sdf", box(0.4));
  const std::string small_cylinder = write("cylinder.sdf", cylinder(0.4));
  parameters["masks"] = Value(Value::Map{{"method", Value(GetParam())}});
  setBravo(small_box, 1.0);
  parameters["randomize"] = yaml("{objects: {bravo: {model: {choice: ['" + small_box + "', '" +
                                 small_cylinder + "']}, scale: {choice: [0.5, 1.5]}}}}");
  const Files varied = filesAnew();
  const auto worn = wornIn(folder);
  ASSERT_THAT(worn, SizeIs(8));
  parameters.erase("randomize");
  std::set<std::string> combinations;
  for (const double scale : {0.5, 1.5}) {
    for (const std::string& model : {small_box, small_cylinder}) {
      const bool is_box = model == small_box;
      setBravo(write("alone.sdf", is_box ? box(0.4 * scale) : cylinder(0.4 * scale)), scale);
      const Files alone = filesAnew();
      for (const auto& [scene, what] : worn) {
        if (what.model != model || what.scale != scale) continue;
        combinations.insert(model + std::to_string(scale));
        const Files expected = ofScene(scene, alone);
        EXPECT_GE(expected.size(), 5U);
        for (const auto& [name, bytes] : expected) {
          EXPECT_TRUE(varied.count(name) == 1 && varied.at(name) == bytes) << name;
        }
      }
    }
  }
  EXPECT_GE(combinations.size(), 3U) << "nearly all are worn in some scene";
}

INSTANTIATE_TEST_SUITE_P(Masks, WornModels, ::testing::Values("exact", "mog2"));

TEST_F(WornModelsTest, NamesWhatCannotBeWorn) {
  parameters["randomize"] = yaml(
      "{objects: {bravo: {model: {choice: [/nowhere/a.sdf, /nowhere/b.sdf]}}, alpah: {scale: 2}}}");
  for (const char* model : {"/nowhere/a.sdf", "/nowhere/b.sdf"}) {
    EXPECT_THAT(errors(), Contains(HasSubstr("randomize/objects/bravo/model: '" +
                                             std::string(model) + "': no such file")));
  }
  parameters["randomize"] = yaml("{objects: {alpah: {scale: 2}}}");
  setBravo(write("box.sdf", box(0.4)), 1.0);
  EXPECT_THAT(errors(), Contains(HasSubstr("randomize/objects/alpah: robot_list has no object")));
}

TEST_F(WornModelsTest, RefusesFormatsWithOneModelOfAnObject) {
  setBravo(write("box.sdf", box(0.4)), 1.0);
  parameters["randomize"] = yaml("{objects: {bravo: {scale: {uniform: [0.5, 2]}}}}");
  parameters["writers"] = yaml(
      "[{name: b, type: synthetic_dataset/Bop}, {name: p, type: synthetic_dataset/PvNet}, "
      "{name: d, type: synthetic_dataset/Dope}]");
  parameters.erase("yolo");
  parameters.erase("bounding_shape");
  const std::string found = "found an object, 'bravo', whose model, size or shape differs";
  EXPECT_THAT(errors(), testing::UnorderedElementsAre(
                            testing::AllOf(HasSubstr(found), HasSubstr("mesh in models/")),
                            testing::AllOf(HasSubstr(found), HasSubstr("model.ply"))));
  // A single fixed size is not a reason.
  parameters["randomize"] = yaml("{objects: {bravo: {scale: 1.5}}}");
  EXPECT_THAT(errors(), testing::IsEmpty());
}

/// Turns the first visual of a model into an SDF model with a mesh file beside it.
std::string meshModel(const std::string& obj_file, const world::Model& model) {
  std::ofstream obj(obj_file);
  obj.precision(9);  // all digits of a float
  const world::Visual& visual = model.links.at(0).visuals.at(0);
  const world::Mesh& mesh = *visual.surfaces.at(0).mesh;
  for (const Eigen::Vector3f& p : mesh.positions) {
    obj << "v " << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
  }
  for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
    obj << "f " << mesh.indices[k] + 1 << ' ' << mesh.indices[k + 1] + 1 << ' '
        << mesh.indices[k + 2] + 1 << '\n';
  }
  const double z = visual.X_LV.translation().z();
  return "<sdf version='1.6'><model name='m'><link name='body'><visual name='v'><pose>0 0 " +
         std::to_string(z) + " 0 0 0</pose><geometry><mesh><uri>" + obj_file +
         "</uri></mesh></geometry></visual></link></model></sdf>";
}

std::map<std::int64_t, int> variantsIn(const std::string& folder) {
  const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement row(manifest,
                            "SELECT scene, value FROM draw WHERE name = 'objects/bravo/variant'");
  std::map<std::int64_t, int> variants;
  while (row.step()) {
    variants[row.integer(0)] = static_cast<int>(*yaml(row.text(1)).as<double>());
  }
  return variants;
}

/// A variant with another shape has the labels of a model that itself has this shape.
TEST_F(WornModelsTest, LabelsOfVariantsAreThoseOfTheirShapes) {
  const std::string own = write("box.sdf", box(0.4));
  parameters["bravo"] = yaml("{class: box, id: bravo, model: '" + own + "'}");
  parameters["randomize"] = yaml("{objects: {bravo: {variety: same_class, variants: 3}}}");
  const Files varied = filesAnew();
  const std::map<std::int64_t, int> variants = variantsIn(folder);
  ASSERT_THAT(variants, SizeIs(8));
  parameters.erase("randomize");
  const world::ResourceFinder finder({}, {}, {});
  const randomize::ObjectVariety variety(world::loadModel(own, "bravo", finder),
                                         randomize::Variety::kSameClass, 0);
  std::set<int> compared;
  for (int number = 0; number < 3; ++number) {
    const std::string alone_file =
        write("alone.sdf",
              meshModel((run.folder() / ("alone" + std::to_string(number) + ".obj")).string(),
                        variety.variant(number).model));
    parameters["bravo"] = yaml("{class: box, id: bravo, model: '" + alone_file + "'}");
    const Files alone = filesAnew();
    for (const auto& [scene, worn] : variants) {
      if (worn != number) continue;
      for (const auto& [name, bytes] : ofScene(scene, alone)) {
        if (fs::path(name).extension() != ".txt") continue;  // pictures differ in paint
        compared.insert(number);
        EXPECT_TRUE(varied.count(name) == 1 && varied.at(name) == bytes) << name;
      }
    }
  }
  EXPECT_GE(compared.size(), 2U) << "nearly all are worn in some scene";
}

TEST_F(WornModelsTest, RefusesOtherShapesWhereAFormatHasOne) {
  setBravo(write("box.sdf", box(0.4)), 1.0);
  parameters["writers"] = yaml("[{name: b, type: synthetic_dataset/Bop}]");
  parameters.erase("yolo");
  parameters.erase("bounding_shape");
  parameters["randomize"] = yaml("{variety: same_class}");
  EXPECT_THAT(errors(), Contains(HasSubstr("whose model, size or shape differs")));
  parameters["randomize"] = yaml("{variety: same_object}");
  EXPECT_THAT(errors(), testing::IsEmpty());
}

// --- Two cameras, many formats, masks by background subtraction, optical flow ---

class WornModelsRun : public ::testing::Test {
 protected:
  WornModelsRun() {
    const std::string other = run.input("cylinder.sdf");
    const std::string own = run.input("box.sdf");
    std::ofstream(other) << cylinder(0.5);
    std::ofstream(own) << box(0.4);
    run.parameters["randomize"] =
        yaml("{objects: {bravo: {model: {choice: ['" + own + "', '" + other +
             "']}, scale: {uniform: [0.5, 1.5]}, sizes: 3, present: 0.8}, alpha: {scale: {choice: "
             "[0.5, 1]}}}}");
    Value::List writers;
    for (const Value& writer : *run.parameters["writers"].as<Value::List>()) {
      const std::string name = writer.as<Value::Map>()->at("name").text();
      if (name == "w_Bop" || name == "w_PvNet") {
        run.parameters.erase(name);
      } else {
        writers.push_back(writer);
      }
    }
    run.parameters["writers"] = Value(writers);
  }

  void place() {
    run.parameters.erase("bag_file");
    run.parameters["motion"] = Value("placement");
    run.parameters["scenes"] = Value(6);
    run.parameters["placement"] =
        yaml("{mode: drop, volume: {min: [-1, -1, 0.5], max: [1, 1, 1]}}");
  }

  AllAtOnceRun run;
};

TEST_F(WornModelsRun, GivesTheSameBytesResumedInShardsAndWhereNothingIsKept) {
  const Files expected = run.unbroken();
  StoppingReporter stopping(5);
  (void)run.run(stopping, run.folder());
  (void)run.run();
  run.expectFiles(expected);
  fs::remove_all(run.folder());
  for (const int index : {1, 0}) (void)run.runShard(index, 2, run.folder());
  Reporter silent;
  mergeShards(run.folder(), {}, silent, {test::pluginXml()});
  run.expectFiles(expected);
  fs::remove_all(run.folder());
  run.parameters["rendering"] = yaml("{reuse: false}");
  (void)run.run();
  run.expectFiles(expected);
}

TEST_F(WornModelsRun, MakesOneSceneOfThoseThatAreDroppedByItself) {
  place();
  const Files expected = run.unbroken();
  run.parameters["only_scenes"] = yaml("[4]");
  (void)run.run();
  for (const auto& [name, bytes] : AllAtOnceRun::files(run.folder())) {
    if (name == "manifest.sqlite") continue;
    EXPECT_TRUE(expected.count(name) == 1 && expected.at(name) == bytes) << name;
  }
}

}  // namespace worn_models_test
}  // namespace synthetic_dataset::run
