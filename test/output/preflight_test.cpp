#include "output/preflight.h"

#include <filesystem>

#include <gmock/gmock.h>

#include "output/store_fixture.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace preflight_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class PreflightTest : public StoreFixture {
 protected:
  [[nodiscard]] std::vector<std::string> errors(const std::vector<StoreWriter>& writers) const {
    StoreOptions options;
    options.folder = path("dataset");
    return errorsOf(options, writers);
  }
};

TEST_F(PreflightTest, MakesMissingFoldersOfWritersAndUserFiles) {
  EXPECT_THAT(errors({{"a", "t", path("new/a/"), {path("lists/of/a/list.txt")}}}), IsEmpty());
  EXPECT_TRUE(fs::is_directory(path("new/a")));
  EXPECT_TRUE(fs::is_directory(path("lists/of/a")));
}

TEST_F(PreflightTest, TellsAllProblemsAtOnceAndMakesNothing) {
  folder_.write("wall", "");
  EXPECT_THAT(errors({{"a", "t", path("wall/a/"), {}},
                      {"b", "t", path("new/b/"), {path("wall/list.txt")}},
                      {"c", "t", "/proc/nothing/c/", {}}}),
              ElementsAre(AllOf(HasSubstr("writer 'a': cannot make the folder"),
                                HasSubstr("wall/a"), HasSubstr("Not a directory")),
                          AllOf(HasSubstr("writer 'b'"), HasSubstr(path("wall"))),
                          AllOf(HasSubstr("writer 'c'"), HasSubstr("/proc/nothing/c"))));
  EXPECT_THAT(tree(), ElementsAre("wall"));
}

TEST_F(PreflightTest, FindsAFolderInWhichNoFileCanBeMade) {
  EXPECT_THAT(errors({{"a", "t", "/proc/", {}}}),
              testing::Contains(AllOf(HasSubstr("writer 'a': files cannot be made in the folder"),
                                      HasSubstr("/proc"))));
}

TEST_F(PreflightTest, RefusesOneFolderForTwoWriters) {
  EXPECT_THAT(errors({{"a", "t", path("x/"), {}}, {"b", "t", path("y/../x/"), {}}}),
              ElementsAre(HasSubstr("writer 'a' and writer 'b' have the same output_folder")));
}

TEST_F(PreflightTest, SeesThroughSymbolicLinks) {
  fs::create_directories(path("x"));
  fs::create_directory_symlink(path("x"), path("alias"));
  EXPECT_THAT(errors({{"a", "t", path("x/"), {}}, {"b", "t", path("alias/"), {}}}),
              ElementsAre(HasSubstr("have the same output_folder")));
}

TEST_F(PreflightTest, RefusesAFolderInsideAnothers) {
  EXPECT_THAT(errors({{"a", "t", path("x/"), {}}, {"b", "t", path("x/y/"), {}}}),
              ElementsAre(AllOf(HasSubstr("writer 'b': the output_folder '" + path("x/y/") + "'"),
                                HasSubstr("of writer 'a'"))));
}

TEST_F(PreflightTest, AllowsFoldersWithACommonBeginningOfTheirNames) {
  EXPECT_THAT(errors({{"a", "t", path("x/"), {}}, {"b", "t", path("xy/"), {}}}), IsEmpty());
}

TEST_F(PreflightTest, AllowsTheManifestInTheOnlyWritersFolder) {
  EXPECT_THAT(errors({{"a", "t", path("dataset/"), {}}}), IsEmpty());
}

TEST_F(PreflightTest, RefusesOneUserFileForTwoWriters) {
  EXPECT_THAT(
      errors({{"a", "t", path("x/"), {path("list")}}, {"b", "t", path("y/"), {path("list")}}}),
      ElementsAre(AllOf(HasSubstr("writer 'a' and writer 'b'"), HasSubstr(path("list")))));
}

TEST_F(PreflightTest, RefusesTheManifestAsAUserFile) {
  EXPECT_THAT(errors({{"a", "t", path("x/"), {path("dataset/manifest.sqlite")}}}),
              ElementsAre(HasSubstr("place of the dataset's manifest")));
}

}  // namespace preflight_test
}  // namespace synthetic_dataset::output
