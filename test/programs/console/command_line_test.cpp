#include "programs/console/command_line.h"

#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace command_line_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pair;

TEST(CommandLine, WithoutArgumentsIsANodes) {
  EXPECT_EQ(parseCommandLine({}).config, std::nullopt);
}

TEST(CommandLine, LeavesRemappingsToRos) {
  const CommandLine line = parseCommandLine({"__name:=generate", "_simulated_rate:=5", "a:=b"});
  EXPECT_EQ(line.config, std::nullopt);
  EXPECT_THAT(line.settings, IsEmpty());
}

TEST(CommandLine, TakesSettingsInOrderOverAFile) {
  const CommandLine line =
      parseCommandLine({"shard/index:=1", "--config", "my.yaml", "output_folder:=/a:=b"});
  EXPECT_EQ(line.config, "my.yaml");
  EXPECT_THAT(line.settings, ElementsAre(Pair("shard/index", "1"), Pair("output_folder", "/a:=b")));
}

TEST(CommandLine, TakesTheFileBehindAnEqualsSign) {
  EXPECT_EQ(parseCommandLine({"--config=my.yaml"}).config, "my.yaml");
}

TEST(CommandLine, PassesOverWhatRoslaunchTellsEveryNode) {
  EXPECT_THAT(parseCommandLine({"--config", "my.yaml", "__name:=x", "__log:=y"}).settings,
              IsEmpty());
}

TEST(CommandLine, AsksForHelp) {
  EXPECT_TRUE(parseCommandLine({"--help"}).wants_help);
  EXPECT_TRUE(parseCommandLine({"-h"}).wants_help);
  EXPECT_FALSE(parseCommandLine({}).wants_help);
}

TEST(CommandLine, ChecksARunInsteadOfMakingIt) {
  const CommandLine line = parseCommandLine({"--config", "my.yaml", "--check", "--out", "look"});
  EXPECT_TRUE(line.wants_check);
  EXPECT_EQ(line.out, "look");
  EXPECT_TRUE(parseCommandLine({"--check", "__name:=generate"}).wants_check) << "as a node";
  EXPECT_FALSE(parseCommandLine({"--config", "my.yaml"}).wants_check);
}

TEST(CheckLine, LeavesItsPicturesBesideTheSettings) {
  EXPECT_EQ(picturesFolder(parseCheckLine({"/data/my.yaml"})), "/data");
  EXPECT_EQ(picturesFolder(parseCheckLine({"my.yaml"})), ".");
  EXPECT_EQ(picturesFolder(parseCheckLine({"/data/my.yaml", "--out", "look"})), "look");
}

TEST(CheckLine, NamesTheFileWithoutAnOption) {
  const CommandLine line = parseCheckLine({"--out", "look", "my.yaml", "rate:=5"});
  EXPECT_EQ(line.config, "my.yaml");
  EXPECT_EQ(line.out, "look");
  EXPECT_THAT(line.settings, ElementsAre(Pair("rate", "5")));
  EXPECT_TRUE(parseCheckLine({"--help"}).wants_help);
  EXPECT_THAT(test::messagesOf([] { (void)parseCheckLine({"rate:=5"}); }),
              ElementsAre(HasSubstr("found no settings file")));
}

struct Mistake {
  std::vector<std::string> arguments;
  std::string message;
};

TEST(CommandLine, RefusesWhatItDoesNotKnow) {
  const std::vector<Mistake> mistakes = {
      {{"--confg", "my.yaml"}, "found '--confg'"},
      {{"my.yaml"}, "found 'my.yaml'"},
      {{"--config"}, "--config: no name follows"},
      {{"--config="}, "--config: found an empty name"},
      {{"--config", "a", "--out", "b"}, "--out: found without --check"},
      {{"--config", "a", "--config", "b"}, "--config: found 'b', a second settings file"},
      {{"--config", "a", ":=5"}, "found ':=5'; a name should stand before"},
      {{"--config", "a", "rate:="}, "rate:=: no value follows"},
  };
  for (const Mistake& mistake : mistakes) {
    EXPECT_THAT(test::messagesOf([&] { return parseCommandLine(mistake.arguments); }),
                testing::ElementsAre(HasSubstr(mistake.message)));
  }
}

}  // namespace command_line_test
}  // namespace synthetic_dataset::programs
