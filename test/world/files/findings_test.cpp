#include "world/files/findings.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::world {
namespace findings_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string missing(const std::string& model, const std::string& mesh) {
  return "a.world: model '" + model + "': link 'l': visual 'v': mesh '" + mesh +
         "': no such file; looked in /models, /more";
}

TEST(Findings, ListAFileOnceThatIsMissingInManyPlaces) {
  Findings findings;
  for (const char* model : {"cone", "cone_0", "cone_1", "cone_1"}) {
    findings.addMissing(missing(model, "cone.dae"));
  }
  EXPECT_THAT(findings.errors,
              ElementsAre(missing("cone", "cone.dae") +
                          " (wanted 3 times, also in model 'cone_0', model 'cone_1')"));
}

TEST(Findings, SayOnceWhereTheyLooked) {
  Findings findings;
  findings.addMissing(missing("cone", "cone.dae"));
  findings.addMissing(missing("cone", "base.dae"));
  EXPECT_THAT(findings.errors,
              ElementsAre(HasSubstr("'cone.dae': no such file; looked in /models, /more"),
                          AllOf(HasSubstr("'base.dae': no such file"), Not(HasSubstr("/more")))));
}

TEST(Findings, SayWhatIsLeftOutWhereFilesMayBeMissing) {
  Findings findings;
  findings.on_missing_asset = OnMissingAsset::kWarn;
  findings.addMissing(missing("a", "cone.dae"));
  findings.addMissing(missing("b", "cone.dae"));
  findings.throwErrors();
  EXPECT_THAT(findings.notes, ElementsAre(missing("a", "cone.dae") +
                                          " (wanted 2 times, also in model 'b') (left out)"));
}

TEST(Findings, CountTheFilesThatAreMissing) {
  Findings findings;
  findings.addError("a.world: something else");
  findings.addMissing(missing("a", "cone.dae"));
  findings.addMissing(missing("b", "cone.dae"));
  findings.addMissing(missing("b", "base.dae"));
  try {
    findings.throwErrors();
    FAIL() << "there are errors";
  } catch (const MissingAssets& assets) {
    EXPECT_EQ(assets.count(), 2U);
    EXPECT_EQ(assets.messages().size(), 3U);
  }
}

}  // namespace findings_test
}  // namespace synthetic_dataset::world
