#include "world/files/findings.h"

#include <gmock/gmock.h>

namespace synthetic_dataset::world {
namespace findings_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

SourceLocation placeIn(const std::string& model) {
  return SourceLocation("a.world").in("model", model).in("link", "l").in("visual", "v");
}

std::string thing(const std::string& mesh) {
  return "mesh '" + mesh + "': no such file; looked in /models, /more";
}

std::string missing(const std::string& model, const std::string& mesh) {
  return placeIn(model).message(thing(mesh));
}

TEST(Findings, ListAFileOnceThatIsMissingInManyPlaces) {
  Findings findings;
  for (const char* model : {"cone", "cone_0", "cone_1", "cone_1"}) {
    findings.addMissing(placeIn(model), thing("cone.dae"));
  }
  EXPECT_THAT(findings.errors,
              ElementsAre(missing("cone", "cone.dae") +
                          " (wanted 3 times, also in model 'cone_0', model 'cone_1')"));
}

TEST(Findings, SayOnceWhereTheyLooked) {
  Findings findings;
  findings.addMissing(placeIn("cone"), thing("cone.dae"));
  findings.addMissing(placeIn("cone"), thing("base.dae"));
  EXPECT_THAT(findings.errors,
              ElementsAre(HasSubstr("'cone.dae': no such file; looked in /models, /more"),
                          AllOf(HasSubstr("'base.dae': no such file"), Not(HasSubstr("/more")))));
}

TEST(Findings, SayWhatIsLeftOutWhereFilesMayBeMissing) {
  Findings findings;
  findings.on_missing_asset = OnMissingAsset::kWarn;
  findings.addMissing(placeIn("a"), thing("cone.dae"));
  findings.addMissing(placeIn("b"), thing("cone.dae"));
  findings.throwErrors();
  EXPECT_THAT(findings.notes, ElementsAre(missing("a", "cone.dae") +
                                          " (wanted 2 times, also in model 'b') (left out)"));
}

TEST(Findings, CountTheFilesThatAreMissing) {
  Findings findings;
  findings.addError("a.world: something else");
  findings.addMissing(placeIn("a"), thing("cone.dae"));
  findings.addMissing(placeIn("b"), thing("cone.dae"));
  findings.addMissing(placeIn("b"), thing("base.dae"));
  try {
    findings.throwErrors();
    FAIL() << "there are errors";
  } catch (const MissingAssets& assets) {
    EXPECT_EQ(assets.count(), 2U);
    EXPECT_EQ(assets.messages().size(), 3U);
  }
}

TEST(Findings, NoteARemarkOnceThatHoldsInManyPlaces) {
  Findings findings;
  for (const char* model : {"a", "b", "b"}) findings.addNote(placeIn(model), "it is odd");
  EXPECT_THAT(findings.notes,
              ElementsAre(placeIn("a").message("it is odd") + " (2 times, also in model 'b')"));
}

}  // namespace findings_test
}  // namespace synthetic_dataset::world
