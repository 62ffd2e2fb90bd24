/// Whole datasets with and without what a run keeps from picture to picture.

#include <filesystem>

#include <gtest/gtest.h>

#include "all_at_once_run.h"

namespace synthetic_dataset::run {
namespace reuse_test {

using test::AllAtOnceRun;

struct Case {
  const char* name;
  const char* method;  ///< of masks
  Value::Map effects;  ///< of the cameras
  const char* light = "simple";
};

class Reuse : public testing::TestWithParam<Case> {
 protected:
  Reuse() {
    run_.parameters["masks"] = Value(Value::Map{{"method", Value(GetParam().method)}});
    Value::Map cameras = *run_.parameters.at("cameras").as<Value::Map>();
    for (auto& [name, camera] : cameras) {
      (*camera.as<Value::Map>())["effects"] = Value(GetParam().effects);
    }
    run_.parameters["cameras"] = Value(cameras);
  }

  std::map<std::string, std::string> filesWith(bool reuse) {
    std::filesystem::remove_all(run_.folder());
    run_.parameters["rendering"] =
        Value(Value::Map{{"reuse", Value(reuse)}, {"light", Value(GetParam().light)}});
    (void)run_.run();
    return AllAtOnceRun::files(run_.folder());
  }

  AllAtOnceRun run_;
};

TEST_P(Reuse, ChangesNoByte) {
  const auto expected = filesWith(false);
  EXPECT_GT(expected.size(), 150U);
  const auto found = filesWith(true);
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [path, bytes] : expected) EXPECT_TRUE(found.at(path) == bytes) << path;
}

INSTANTIATE_TEST_SUITE_P(Datasets, Reuse,
                         testing::Values(Case{"Exact", "exact", {}}, Case{"Mog2", "mog2", {}},
                                         Case{"FullLight", "mog2", {}, "full"},
                                         Case{"RollingShutter",
                                              "exact",
                                              {{"readout_time", Value(0.05)},
                                               {"readout_bands", Value(6)}}}),
                         [](const auto& each) { return std::string(each.param.name); });

}  // namespace reuse_test
}  // namespace synthetic_dataset::run
