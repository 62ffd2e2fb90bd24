#include <filesystem>

#include <gmock/gmock.h>

#include "output/verify/verification_fixture.h"

namespace synthetic_dataset::output {
namespace shards_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// Shard 0 of 2 of a run of eight scenes; with so few, a block is a single scene.
class VerifyShard : public VerificationTest {
 protected:
  VerifyShard() : VerificationTest("Coco") {
    write({sceneOfBoth(0), sceneOfBoth(2), sceneOfBoth(4), sceneOfBoth(6)}, {},
          output::Shard{0, 2});
  }

  const std::string manifest_ = "manifest.shard-0-of-2.sqlite";
};

TEST_F(VerifyShard, FindsNothingWrong) {
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_EQ(counts_.scenes, 4);
  EXPECT_THAT(
      remarks_,
      ElementsAre(
          HasSubstr("the labels of 'w' are checked as stored in the manifest, and not counted"),
          HasSubstr("1 of 2 shards are here")));
}

TEST_F(VerifyShard, TellsOfAMissingScene) {
  change(
      "DELETE FROM scene WHERE \"index\" = 4; DELETE FROM scene_object WHERE scene = 4; "
      "DELETE FROM draw WHERE scene = 4; DELETE FROM file WHERE scene = 4; "
      "DELETE FROM record WHERE scene = 4",
      manifest_);
  for (const char* table :
       {"scene_camera", "scene_frame", "scene_picture", "scene_shape", "scene_keypoint"}) {
    change("DELETE FROM " + std::string(table) + " WHERE scene = 4", manifest_);
  }
  std::filesystem::remove(path("images/00000004.png"));
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("scene: missing: 4 (of shard 0/2 of 8)")));
}

TEST_F(VerifyShard, TellsOfAnothersScene) {
  change("UPDATE scene SET \"index\" = 5, instant = 5 WHERE \"index\" = 4", manifest_);
  EXPECT_THAT(problems(), testing::Contains(HasSubstr("scene: found 5; they do not belong to "
                                                      "shard 0/2 of 8 scenes from 0 on")));
}

TEST_F(VerifyShard, TellsOfAShardOfAnotherRun) {
  std::filesystem::copy_file(folder_ / manifest_, folder_ / "manifest.shard-1-of-2.sqlite");
  change(
      "UPDATE run SET value = '1/2' WHERE key = 'shard'; INSERT INTO setting VALUES ('rate', "
      "'2', 0)",
      "manifest.shard-1-of-2.sqlite");
  EXPECT_THAT(problems(), testing::Contains(HasSubstr("it is not a shard of the run of '")));
}

}  // namespace shards_test
}  // namespace synthetic_dataset::output
