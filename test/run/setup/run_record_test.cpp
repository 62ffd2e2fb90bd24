#include "run/setup/run_record.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::run {
namespace run_record_test {

using testing::ElementsAre;
using testing::Key;

TEST(UsedSettings, LeaveOutWhereFilesGoAndWhatNobodyReads) {
  const Value parameters(Value::Map{
      {"bag_file", Value("a.bag")},
      {"output_folder", Value("/data")},
      {"if_exists", Value("resume")},
      {"sync", Value("off")},
      {"processes", Value(4)},
      {"shard", Value(Value::Map{{"index", Value(0)}, {"count", Value(2)}})},
      {"yolo", Value(Value::Map{{"output_folder", Value("/there")}, {"box", Value("loose")}})},
      {"old_writer", Value(Value::Map{{"setting", Value(1)}})}});
  config::Config config;
  config.writers.push_back({"yolo", "synthetic_dataset/Yolo", "/there/", Parameters(Value())});
  const auto settings = usedSettings(parameters, config, {"old_writer"},
                                     {{"image/jpeg_quality", Value(95)}, {"sync", Value("batch")}});
  EXPECT_THAT(settings, ElementsAre(Key("bag_file"), Key("image/jpeg_quality"), Key("yolo/box")));
  EXPECT_EQ(settings.at("bag_file").value, "\"a.bag\"");
  EXPECT_FALSE(settings.at("yolo/box").is_default);
  EXPECT_TRUE(settings.at("image/jpeg_quality").is_default);
}

TEST(DescribedCredits, AreThoseThatFilesName) {
  const test::TemporaryFolder folder;
  (void)folder.write("m/model.config", "<model><author><name>Ada</name></author></model>");
  const std::string mesh = folder.write("m/a.stl", "").string();
  const std::string bag = folder.write("b/a.bag", "").string();
  const auto credits = describeCredits({mesh, bag});
  EXPECT_THAT(credits, ElementsAre(Key(mesh)));
  EXPECT_EQ(credits.at(mesh).author, "Ada");
  EXPECT_EQ(credits.at(mesh).author_in, (folder / "m/model.config").string());
  EXPECT_EQ(credits.at(mesh).license, "");
}

TEST(SoftwareVersions, NameWhatShapesTheBytes) {
  for (const auto& [name, version] : softwareVersions()) EXPECT_NE(version, "") << name;
  EXPECT_EQ(softwareVersions().count("bullet"), 1U);
}

}  // namespace run_record_test
}  // namespace synthetic_dataset::run
