#include "output/manifest/run_description.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::output {
namespace run_description_test {

using testing::ElementsAre;
using testing::IsEmpty;

RunDescription someRun() {
  RunDescription run;
  run.settings["camera/far"] = {"100.0", false};
  run.settings["seed"] = {"0", true};
  run.software["opencv"] = "4.6.0";
  run.inputs["/data/a.bag"] = {12, std::string(64, 'a')};
  run.scene_count = 3;
  return run;
}

TEST(RunDescription, OfTheSameRunDiffersInNothing) {
  EXPECT_THAT(differences(someRun(), someRun(), "then", "now"), IsEmpty());
}

TEST(RunDescription, NamesWhatDiffers) {
  RunDescription other = someRun();
  other.settings["camera/far"].value = "50.0";
  other.settings["camera/near"] = {"0.1", false};
  other.software["opencv"] = "4.7.0";
  other.inputs["/data/a.bag"] = {13, std::string(64, 'b')};
  EXPECT_THAT(differences(someRun(), other, "then", "now"),
              ElementsAre("camera/far: then 100.0, now 50.0", "camera/near: then none, now 0.1",
                          "the file /data/a.bag: then 12 bytes (SHA-256 aaaaaaaaaaaa), now 13 "
                          "bytes (SHA-256 bbbbbbbbbbbb)",
                          "software opencv: then 4.6.0, now 4.7.0"));
}

TEST(RunDescription, TellsOfAnotherNumberOfScenesWhereNothingElseDoes) {
  RunDescription other = someRun();
  other.scene_count = 4;
  EXPECT_THAT(differences(someRun(), other, "then", "now"),
              ElementsAre("the number of scenes: then 3, now 4"));
}

TEST(CreditInfos, AreTheSameWhereverTheFilesLie) {
  const auto of = [](const std::string& folder) {
    return creditInfos({{folder + "/m/b.png", {"Ada", folder + "/m/model.config", "MIT", folder}},
                        {folder + "/m/a.dae", {"Ada", "", "MIT", ""}},
                        {folder + "/w/w.world", {"", "", "LICENSE", folder + "/LICENSE"}}});
  };
  const auto infos = of("/here");
  ASSERT_EQ(infos.size(), 2U);
  EXPECT_EQ(infos[0].license, "LICENSE");
  EXPECT_EQ(infos[1].author, "Ada");
  EXPECT_THAT(infos[1].files, ElementsAre("m/a.dae", "m/b.png"));
  EXPECT_EQ(of("/there")[1].files, infos[1].files);
}

TEST(RunDescription, DigestFollowsTheGivenSettingsAndInputs) {
  RunDescription other = someRun();
  other.settings["seed"].value = "1";  // a default, which the software's version implies
  EXPECT_EQ(settingsDigest(other), settingsDigest(someRun()));
  other.inputs["/data/a.bag"].digest = std::string(64, 'b');
  EXPECT_NE(settingsDigest(other), settingsDigest(someRun()));
}

}  // namespace run_description_test
}  // namespace synthetic_dataset::output
