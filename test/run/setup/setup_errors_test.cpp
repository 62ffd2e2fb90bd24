#include "run/setup/setup_errors.h"

#include <gmock/gmock.h>

#include "base/yaml_value.h"

namespace synthetic_dataset::run {
namespace motion_errors_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

// --- mergedErrors ---

TEST(MergedErrors, AreTheMessagesAsTheyAreWithoutAList) {
  EXPECT_THAT(mergedErrors({{"", {"world: missing", "camera: missing"}}}),
              ElementsAre("world: missing", "camera: missing"));
}

TEST(MergedErrors, TellWhatIsWrongWithAllOnce) {
  EXPECT_THAT(mergedErrors({{"motions/0", {"a: wrong", "b: wrong"}},
                            {"motions/1", {"b: wrong", "a: wrong"}}}),
              ElementsAre("a: wrong", "b: wrong"));
}

TEST(MergedErrors, TellWhichMotionTheOthersAreOf) {
  EXPECT_THAT(mergedErrors({{"motions/0", {"a: wrong"}},
                            {"motions/1", {"b: wrong", "a: wrong"}},
                            {"motions/2", {"a: wrong", "c: wrong"}}}),
              ElementsAre("a: wrong", "motions/1: b: wrong", "motions/2: c: wrong"));
}

TEST(MergedErrors, TellOfEachMotionWhatSomeHaveInCommon) {
  EXPECT_THAT(
      mergedErrors({{"motions/0", {"a: wrong"}}, {"motions/1", {"a: wrong"}}, {"motions/2", {}}}),
      ElementsAre("motions/0: a: wrong", "motions/1: a: wrong"));
}

TEST(MergedErrors, AreNoneWhereNothingIsWrong) {
  EXPECT_THAT(mergedErrors({{"motions/0", {}}, {"motions/1", {}}}), IsEmpty());
}

// --- unusedSettings and unknownParameters ---

/// Two motions of a run; `read` are the parameters that each of them reads.
class UnknownOfMotions : public ::testing::Test {
 protected:
  void add(const std::string& settings, const std::string& own,
           const std::vector<std::string>& read) {
    config::MotionEntry entry;
    entry.group = "motions/" + std::to_string(entries.size());
    entry.own = *base::parseYaml(own, "test").as<Value::Map>();
    roots.emplace_back(base::parseYaml(settings, "test"));
    for (const std::string& name : read) {
      const std::size_t slash = name.find('/');
      if (slash == std::string::npos) {
        (void)roots.back().maybe<Value>(name);
      } else {
        (void)roots.back().group(name.substr(0, slash)).maybe<Value>(name.substr(slash + 1));
      }
    }
    entries.push_back(std::move(entry));
  }

  std::vector<config::MotionEntry> entries;
  std::vector<Parameters> roots;
};

TEST_F(UnknownOfMotions, IsWhatNoMotionReads) {
  add("{step: 1, colour: 2, nonsense: 3}", "{}", {"step"});
  add("{step: 1, colour: 2, nonsense: 3}", "{}", {"colour"});
  EXPECT_THAT(unusedSettings(entries, roots), ElementsAre("nonsense"));
  EXPECT_THAT(unknownParameters(entries, roots), ElementsAre("nonsense: unknown parameter"));
}

TEST_F(UnknownOfMotions, IsWhatTheMotionThatHasItDoesNotRead) {
  add("{step: 1}", "{}", {"step"});
  add("{step: 1, nonsense: 2, group: {far: 1, height: 2}}", "{nonsense: 2, group: {height: 2}}",
      {"step", "group/far"});
  EXPECT_THAT(unknownParameters(entries, roots),
              ElementsAre("motions/1: group/height: unknown parameter",
                          "motions/1: nonsense: unknown parameter"));
  EXPECT_THAT(unusedSettings(entries, roots), IsEmpty()) << "they are not the run's";
}

TEST_F(UnknownOfMotions, OfTheRunIsToldOnceAndFirst) {
  add("{step: 1, nonsense: 2}", "{}", {"step"});
  add("{step: 1, nonsense: 2, drivel: 3}", "{drivel: 3}", {"step"});
  EXPECT_THAT(unknownParameters(entries, roots),
              ElementsAre("nonsense: unknown parameter", "motions/1: drivel: unknown parameter"));
}

TEST_F(UnknownOfMotions, OfTheRunsGroupIsNotThatOfAMotionWithOtherSettingsInIt) {
  add("{group: {far: 1, nonsense: 2}}", "{}", {"group/far"});
  add("{group: {far: 3, nonsense: 2}}", "{group: {far: 3}}", {"group/far"});
  EXPECT_THAT(unknownParameters(entries, roots), ElementsAre("group/nonsense: unknown parameter"));
}

TEST_F(UnknownOfMotions, IsNotASettingThatOneMotionReadsAndAnotherReplaces) {
  // The first motion has a sample instead of the run's pose.
  add("{camera: {sample: 1}}", "{camera: {sample: 1}}", {"camera/sample"});
  add("{camera: {pose: 1}}", "{}", {"camera/pose"});
  EXPECT_THAT(unknownParameters(entries, roots), IsEmpty());
}

TEST_F(UnknownOfMotions, SuggestsWhatWasMeant) {
  add("{far: 1}", "{}", {"far"});
  add("{far: 1, faar: 2}", "{faar: 2}", {"far"});
  EXPECT_THAT(unknownParameters(entries, roots),
              ElementsAre("motions/1: faar: unknown parameter; did you mean 'far'?"));
}

// --- explainPreset ---

TEST(ExplainPreset, SaysSoOfWhatTheUserDidNotWrite) {
  const Value given = base::parseYaml("{camera: {near: -1}, randomize: {ambient: 9}}", "given");
  const Value spelled = base::parseYaml(
      "{camera: {near: -1, sample: {roll: 1}}, randomize: {ambient: 9, variety: none},"
      " motions: [{randomize: {room: {size: 3}}}, {placement: {}}]}",
      "spelled");
  const std::vector<std::string> own = {"camera/near: found -1", "randomize/ambient: found 9",
                                        "camera/info_file: missing", "no such file"};
  EXPECT_EQ(explainPreset(own, given, spelled), own);
  const std::string from = " comes from `randomize: {preset: transfer}`";
  EXPECT_THAT(explainPreset({"camera/sample/roll: found 1", "motions/1: no place: none is free",
                             "randomize/room/size: found 3"},
                            given, spelled),
              ElementsAre("camera/sample/roll: found 1; `camera/sample/roll`" + from,
                          "motions/1: no place: none is free; `motions/1`" + from,
                          "randomize/room/size: found 3; `randomize/room/size`" + from));
  EXPECT_EQ(explainPreset({"motions/7: wrong"}, given, spelled).front(), "motions/7: wrong");
}

}  // namespace motion_errors_test
}  // namespace synthetic_dataset::run
