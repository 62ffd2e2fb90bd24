/// Whole datasets with and without what a run keeps from picture to picture.

#include <filesystem>

#include <gtest/gtest.h>

#include "all_at_once_run.h"

namespace synthetic_dataset {
namespace {

using test::AllAtOnceRun;

class Reuse : public testing::TestWithParam<const char*> {
 protected:
  /// The files, without the manifest, which tells of the settings.
  std::map<std::string, std::string> filesWith(bool reuse) {
    std::filesystem::remove_all(run_.folder());
    run_.parameters["masks"] = Value(Value::Map{{"method", Value(GetParam())}});
    run_.parameters["rendering"] = Value(Value::Map{{"reuse", Value(reuse)}});
    (void)run_.run();
    auto files = AllAtOnceRun::files(run_.folder());
    EXPECT_EQ(files.erase("manifest.sqlite"), 1U);
    return files;
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

INSTANTIATE_TEST_SUITE_P(OfMasks, Reuse, testing::Values("exact", "mog2"));

}  // namespace
}  // namespace synthetic_dataset
