#include "world/files/scratch_folder.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::world {
namespace scratch_folder_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

/// With a system's folder for temporary files of its own.
class ScratchFolderTest : public testing::Test {
 protected:
  ScratchFolderTest() {
    if (const char* before = std::getenv("TMPDIR")) before_ = before;
    setTo(system_.path().string());
  }
  ~ScratchFolderTest() override {
    if (before_) {
      setTo(*before_);
    } else {
      unsetenv("TMPDIR");
    }
  }

  static void setTo(const std::string& folder) { setenv("TMPDIR", folder.c_str(), 1); }

  test::TemporaryFolder system_;

 private:
  std::optional<std::string> before_;
};

TEST_F(ScratchFolderTest, GoesWithItsObject) {
  fs::path path;
  {
    const ScratchFolder folder("copies.");
    path = folder.path();
    EXPECT_THAT(path.string(), StartsWith((system_ / "copies.").string()));
    std::ofstream(path / "file") << "text";
    EXPECT_TRUE(fs::exists(path / "file"));
  }
  EXPECT_FALSE(fs::exists(path));
}

TEST_F(ScratchFolderTest, TakesThoseOfDeadProcessesAway) {
  fs::create_directories(system_ / "copies.abcdef" / "inner");
  fs::create_directories(system_ / "other.abcdef");
  const ScratchFolder folder("copies.");
  EXPECT_FALSE(fs::exists(system_ / "copies.abcdef"));
  EXPECT_TRUE(fs::exists(system_ / "other.abcdef")) << "which is somebody else's";
}

TEST_F(ScratchFolderTest, LeavesThoseInUseAlone) {
  const ScratchFolder first("copies.");
  const ScratchFolder second("copies.");
  EXPECT_NE(first.path(), second.path());
  EXPECT_TRUE(fs::exists(first.path()));
}

TEST_F(ScratchFolderTest, FollowsNoLinks) {
  const test::TemporaryFolder elsewhere;
  fs::create_directory_symlink(elsewhere.path(), system_ / "copies.abcdef");
  const ScratchFolder folder("copies.");
  EXPECT_TRUE(fs::exists(elsewhere.path()));
  EXPECT_TRUE(fs::is_symlink(system_ / "copies.abcdef"));
}

TEST_F(ScratchFolderTest, NamesAFolderThatIsNotThere) {
  setTo("/nowhere");
  EXPECT_THAT(test::messagesOf([] { const ScratchFolder folder("copies."); }),
              ElementsAre(HasSubstr("TMPDIR")));
}

}  // namespace scratch_folder_test
}  // namespace synthetic_dataset::world
