#include "output/files/pending_file.h"

#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <stdexcept>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace pending_file_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

/// The message of the error that making a file throws.
std::string failureOf(const std::string& path, const std::string& content) {
  try {
    PendingFile::withBytes(path, content);
  } catch (const Error& error) {
    return error.what();
  }
  return "no error";
}

class PendingFileTest : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] bool folderIsEmpty() const { return fs::is_empty(folder_.path()); }

  test::TemporaryFolder folder_;
};

TEST_F(PendingFileTest, AppearsOnlyWhenPublished) {
  PendingFile file = PendingFile::withBytes(path("a"), "content");
  EXPECT_FALSE(fs::exists(path("a")));
  EXPECT_TRUE(fs::exists(path(".a.tmp")));
  file.publish();
  EXPECT_EQ(test::readFile(path("a")), "content");
  EXPECT_FALSE(fs::exists(path(".a.tmp")));
  file.keep();
}

TEST_F(PendingFileTest, GoesUnlessItIsKept) {
  { const PendingFile file = PendingFile::withBytes(path("unpublished"), "x"); }
  { PendingFile::withBytes(path("published"), "x").publish(); }
  EXPECT_TRUE(folderIsEmpty());
}

TEST_F(PendingFileTest, StaysWhenItIsKept) {
  {
    PendingFile file = PendingFile::withBytes(path("a"), "x");
    file.publish();
    file.keep();
  }
  EXPECT_TRUE(fs::exists(path("a")));
}

TEST_F(PendingFileTest, MakesItsFolder) {
  PendingFile::withBytes(path("deep/er/a"), "x").publish();
  EXPECT_TRUE(fs::is_directory(path("deep/er")));
}

TEST_F(PendingFileTest, SharesContentThroughALink) {
  PendingFile first = PendingFile::withBytes(path("a"), "x");
  PendingFile second = PendingFile::linkedTo(first, path("b/c"), "x");
  first.publish();
  second.publish();
  EXPECT_TRUE(fs::equivalent(path("a"), path("b/c")));
}

TEST_F(PendingFileTest, IsCopiedWhereALinkIsImpossible) {
  // A published file no longer has a temporary name that could be linked.
  PendingFile first = PendingFile::withBytes(path("a"), "x");
  first.publish();
  PendingFile second = PendingFile::linkedTo(first, path("b"), "x");
  second.publish();
  EXPECT_EQ(test::readFile(path("b")), "x");
  EXPECT_FALSE(fs::equivalent(path("a"), path("b")));
}

TEST_F(PendingFileTest, HoldsAStreamLongerThanItsBuffer) {
  std::string expected;
  PendingFile file = PendingFile::withContent(path("a"), [&](std::ostream& stream) {
    for (int line = 0; line < 40000; ++line) {
      stream << "line " << line << '\n';
      expected += "line " + std::to_string(line) + "\n";
    }
  });
  file.publish();
  EXPECT_EQ(test::readFile(path("a")), expected);
  EXPECT_EQ(file.size(), static_cast<std::int64_t>(expected.size()));
}

TEST_F(PendingFileTest, LetsErrorsOfTheContentThrough) {
  EXPECT_THROW(
      PendingFile::withContent(path("a"), [](std::ostream&) { throw std::range_error("mine"); }),
      std::range_error);
  EXPECT_TRUE(folderIsEmpty());
}

TEST_F(PendingFileTest, IsWrittenByALibraryUnderItsTemporaryName) {
  PendingFile file = PendingFile::writtenBy(
      path("deep/a"), [](const std::string& name) { std::ofstream(name) << "of a library"; });
  EXPECT_FALSE(fs::exists(path("deep/a")));
  EXPECT_EQ(file.size(), 12);
  file.publish();
  file.keep();
  EXPECT_EQ(test::readFile(path("deep/a")), "of a library");
  EXPECT_FALSE(fs::exists(path("deep/.a.tmp")));
}

TEST_F(PendingFileTest, GivesALibraryAFileOfItsOwn) {
  folder_.write("original", "of a killed run");
  fs::create_hard_link(path("original"), path(".a.tmp"));
  PendingFile::writtenBy(path("a"), [](const std::string& name) { std::ofstream(name) << "x"; });
  EXPECT_EQ(test::readFile(path("original")), "of a killed run");
}

/// Someone else with write access to the folder puts a link where a library is about to write.
TEST_F(PendingFileTest, TakesNothingThatSomebodyElseHasPutInItsPlace) {
  folder_.write("strangers", "of a stranger");
  const auto write = [&](const std::string& name) {
    fs::remove(name);
    fs::create_symlink(path("strangers"), name);
  };
  EXPECT_THROW(PendingFile::writtenBy(path("a"), write), Error);
  EXPECT_EQ(test::readFile(path("strangers")), "of a stranger");
  EXPECT_FALSE(fs::exists(path("a")));
}

TEST_F(PendingFileTest, LeavesNothingOfALibraryThatFails) {
  const auto fail = [](const std::string& name) {
    std::ofstream(name) << "half";
    throw std::range_error("mine");
  };
  EXPECT_THROW(PendingFile::writtenBy(path("a"), fail), std::range_error);
  EXPECT_TRUE(folderIsEmpty());
}

TEST_F(PendingFileTest, TellsOfALibraryThatMakesNoFile) {
  std::string failure;
  try {
    PendingFile::writtenBy(path("a"), [](const std::string& /*name*/) {});
  } catch (const Error& error) {
    failure = error.what();
  }
  EXPECT_THAT(failure,
              AllOf(HasSubstr("cannot write '" + path("a") + "'"), HasSubstr("No such file")));
}

TEST_F(PendingFileTest, LinksAFileThatIsThere) {
  folder_.write("original", "content");
  {
    PendingFile file = PendingFile::linkedToFile(path("original"), path("b/c"));
    EXPECT_EQ(file.size(), 7);
    file.publish();
    EXPECT_TRUE(fs::equivalent(path("original"), path("b/c")));
  }
  EXPECT_FALSE(fs::exists(path("b/c")));
  EXPECT_EQ(test::readFile(path("original")), "content");
}

TEST_F(PendingFileTest, CopiesAFileToAnotherFileSystem) {
  if (!fs::is_directory("/dev/shm")) GTEST_SKIP() << "there is no other file system here";
  const fs::path original = fs::path("/dev/shm") / folder_.path().filename();
  { std::ofstream(original) << "content"; }
  struct stat one {};
  struct stat other {};
  stat(original.c_str(), &one);
  stat(folder_.path().c_str(), &other);
  PendingFile file = PendingFile::linkedToFile(original.string(), path("a"));
  file.publish();
  fs::remove(original);
  if (one.st_dev == other.st_dev) GTEST_SKIP() << "/dev/shm is the same file system";
  EXPECT_EQ(test::readFile(path("a")), "content");
}

TEST_F(PendingFileTest, LinksNoFileThatIsNotThere) {
  EXPECT_THROW(PendingFile::linkedToFile(path("none"), path("a")), Error);
  EXPECT_TRUE(folderIsEmpty());
}

TEST_F(PendingFileTest, NamesPathAndReasonWhenItsFolderCannotBeMade) {
  folder_.write("wall", "");
  EXPECT_THAT(
      failureOf(path("wall/a"), "x"),
      AllOf(HasSubstr("cannot write '" + path("wall/a") + "'"), HasSubstr("Not a directory")));
}

TEST_F(PendingFileTest, NamesPathAndReasonWhenTheDiskIsFull) {
  // The limit of a file's size stands in for a full disk: write(2) fails half way through.
  rlimit old_limit{};
  getrlimit(RLIMIT_FSIZE, &old_limit);
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit limit = old_limit;
  limit.rlim_cur = 1000;
  setrlimit(RLIMIT_FSIZE, &limit);
  const std::string failure = failureOf(path("a"), std::string(5000, 'x'));
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  EXPECT_THAT(failure,
              AllOf(HasSubstr("cannot write '" + path("a") + "'"), HasSubstr("too large")));
  EXPECT_TRUE(folderIsEmpty());
}

TEST(ReadWholeFile, AnswersEveryByte) {
  const test::TemporaryFolder folder;
  std::string all;
  for (int i = 0; i < 100000; ++i) all += static_cast<char>(i);
  EXPECT_EQ(readWholeFile(folder.write("a", all).string()), all);
  EXPECT_EQ(readWholeFile(folder.write("empty", "").string()), "");
}

TEST(ReadWholeFile, NamesAFileThatCannotBeRead) {
  const test::TemporaryFolder folder;
  for (const std::string& path : {(folder / "none").string(), folder.path().string()}) {
    try {
      (void)readWholeFile(path);
      ADD_FAILURE() << path;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("cannot read '" + path + "'"));
    }
  }
}

TEST(TemporaryPath, IsHiddenAndInTheSameFolder) {
  EXPECT_EQ(temporaryPath("/a/b.png"), "/a/.b.png.tmp");
}

TEST(TemporaryPath, FitsAFileSystemHoweverLongTheName) {
  const std::string one = temporaryPath("/a/" + std::string(254, 'x') + "1");
  const std::string two = temporaryPath("/a/" + std::string(254, 'x') + "2");
  EXPECT_EQ(one.size(), 3u + 255u);
  EXPECT_NE(one, two);
}

}  // namespace pending_file_test
}  // namespace synthetic_dataset::output
