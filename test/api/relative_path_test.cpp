#include "synthetic_dataset/relative_path.h"

#include <gmock/gmock.h>

namespace synthetic_dataset {
namespace relative_path_test {

using testing::HasSubstr;
using testing::Optional;

TEST(RelativePath, MayBeDeepAndInAnyLanguage) {
  for (const std::string path : {"0.png", "a/b/c.txt",
                                 "K\xC3\xBC"
                                 "che/\xE7\x8C\xAB.png",
                                 "..a", "a..b/...", ".hidden", "with space", "x.tmp"}) {
    EXPECT_EQ(relativePathProblem(path), std::nullopt) << path;
  }
}

TEST(RelativePath, IsNotEmpty) {
  EXPECT_THAT(relativePathProblem(""), Optional(HasSubstr("empty")));
}

TEST(RelativePath, DoesNotLeaveTheFolder) {
  for (const std::string path : {"..", "../a", "a/..", "a/../b", "a/../../b"}) {
    EXPECT_THAT(relativePathProblem(path), Optional(HasSubstr("'..'"))) << path;
  }
}

TEST(RelativePath, IsNotAbsolute) {
  EXPECT_THAT(relativePathProblem("/etc/passwd"), Optional(HasSubstr("relative")));
}

TEST(RelativePath, IsNormalised) {
  for (const std::string path : {"./a", "a/.", "a//b", "a/"}) {
    EXPECT_NE(relativePathProblem(path), std::nullopt) << path;
  }
}

TEST(RelativePath, HasNoControlCharacters) {
  using namespace std::string_literals;
  for (const std::string& path : {"a\0b"s, "a\nb"s, "\x7F"s, "a/\t"s}) {
    EXPECT_THAT(relativePathProblem(path), Optional(HasSubstr("control character")));
  }
}

TEST(RelativePath, HasPartsOfAtMost255Bytes) {
  EXPECT_EQ(relativePathProblem("a/" + std::string(255, 'x')), std::nullopt);
  EXPECT_THAT(relativePathProblem("a/" + std::string(256, 'x')), Optional(HasSubstr("255")));
}

TEST(RelativePath, LeavesTheNamesOfTemporaryFilesAlone) {
  EXPECT_THAT(relativePathProblem("a/.b.png.tmp"), Optional(HasSubstr("being written")));
}

}  // namespace relative_path_test
}  // namespace synthetic_dataset
