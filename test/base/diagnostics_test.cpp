#include "base/diagnostics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace synthetic_dataset::base {
namespace diagnostics_test {

using ::testing::ElementsAre;

TEST(Diagnostics, SeparatesErrorsWarningsAndNotesAndNamesTheirPlaces) {
  Diagnostics found;
  found.note("crate/safety_radius", "0.4 m");
  found.error("camera/far", "found -1");
  found.warning("", "no sun");
  found.error("world.sdf:12", "no mesh");
  EXPECT_THAT(found.messages(Severity::kError),
              ElementsAre("camera/far: found -1", "world.sdf:12: no mesh"));
  EXPECT_THAT(found.messages(Severity::kWarning), ElementsAre("no sun"));
  EXPECT_THAT(found.messages(Severity::kNote), ElementsAre("crate/safety_radius: 0.4 m"));
}

TEST(Diagnostics, TakesManyDifferentMessages) {
  Diagnostics found;
  for (int i = 0; i < 100000; ++i) found.warning("setting " + std::to_string(i), "is odd");
  found.warning("setting 7", "is odd", 2);
  found.error("setting 7", "is odd");
  ASSERT_EQ(found.all().size(), 100001U);
  EXPECT_EQ(found.all()[7].count, 3);
  EXPECT_EQ(found.all().back().count, 1);
}

TEST(Diagnostics, KeepsWhatStepsThrowAndGoesOn) {
  Diagnostics found;
  EXPECT_EQ(found.attempt([] { return 3; }), 3);
  EXPECT_TRUE(found.attempt([] {}));
  EXPECT_FALSE(found.attempt([]() -> int { throw Error("one"); }));
  EXPECT_FALSE(found.attempt([] { throw ErrorList({"two", "three"}); }));
  EXPECT_THAT(found.messages(Severity::kError), ElementsAre("one", "two", "three"));
}

TEST(Diagnostics, PassesOnWhatIsNoErrorOfTheUsers) {
  Diagnostics found;
  EXPECT_THROW((void)found.attempt([] { throw std::logic_error("a fault of the program"); }),
               std::logic_error);
}

TEST(Diagnostics, ListsOnceAndCountsWhatIsFoundAgain) {
  Diagnostics found;
  found.warning("crate", "has no texture");
  Diagnostics more;
  more.warning("lamp", "casts no shadow");
  more.add(Severity::kWarning, {"crate: has no texture"});
  more.warning("crate", "has no texture", 3);
  more.note("crate", "has no texture");  // listed separately, as it is not a warning
  found.merge(more);
  EXPECT_THAT(found.messages(Severity::kWarning),
              ElementsAre("crate: has no texture", "lamp: casts no shadow"));
  EXPECT_EQ(found.all().front().count, 5);
  EXPECT_EQ(found.all().size(), 3u);
}

TEST(Diagnostics, ThrowsAllErrorsAtOnceAndNothingElse) {
  Diagnostics found;
  found.warning("", "no sun");
  EXPECT_FALSE(found.hasErrors());
  EXPECT_NO_THROW(found.throwIfAny());
  found.error("a", "wrong");
  found.error("b", "wrong");
  try {
    found.throwIfAny();
    FAIL() << "nothing was thrown";
  } catch (const ErrorList& errors) {
    EXPECT_THAT(errors.messages(), ElementsAre("a: wrong", "b: wrong"));
  }
}

TEST(NamingPlace, PutsThePlaceBeforeEachError) {
  EXPECT_EQ(namingPlace("model", [] { return 3; }), 3);
  Diagnostics found;
  found.attempt([] { namingPlace("model", [] { throw Error("not there"); }); });
  found.attempt([] { namingPlace("model", [] { throw ErrorList({"one", "two"}); }); });
  EXPECT_THAT(found.messages(Severity::kError),
              ElementsAre("model: not there", "model: one", "model: two"));
}

}  // namespace diagnostics_test
}  // namespace synthetic_dataset::base
