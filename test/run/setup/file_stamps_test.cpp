#include "run/setup/file_stamps.h"

#include <filesystem>

#include <gtest/gtest.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::run {
namespace file_stamps_test {

/// A file that was written some time ago.
std::filesystem::path oldFile(const test::TemporaryFolder& folder, const std::string& text) {
  std::filesystem::path file = folder.write("a", text);
  std::filesystem::last_write_time(
      file, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
  return file;
}

TEST(FileStamps, AreCurrentWhileNothingChanges) {
  const test::TemporaryFolder folder;
  FileStamps stamps;
  stamps.add(oldFile(folder, "one"));
  stamps.add(folder / "missing");
  EXPECT_TRUE(stamps.areCurrent());
}

TEST(FileStamps, SeeAnotherSize) {
  const test::TemporaryFolder folder;
  FileStamps stamps;
  stamps.add(oldFile(folder, "one"));
  oldFile(folder, "three");
  EXPECT_FALSE(stamps.areCurrent());
}

TEST(FileStamps, SeeAnotherTime) {
  const test::TemporaryFolder folder;
  FileStamps stamps;
  stamps.add(oldFile(folder, "one"));
  static_cast<void>(folder.write("a", "two"));
  EXPECT_FALSE(stamps.areCurrent());
}

TEST(FileStamps, SeeWhatComesAndGoes) {
  const test::TemporaryFolder folder;
  FileStamps stamps;
  stamps.add(folder / "a");
  static_cast<void>(folder.write("a", "one"));
  EXPECT_FALSE(stamps.areCurrent());
  FileStamps others;
  others.add(oldFile(folder, "one"));
  std::filesystem::remove(folder / "a");
  EXPECT_FALSE(others.areCurrent());
}

TEST(FileStamps, TakeWhatIsWrittenMeanwhileForChanged) {
  const test::TemporaryFolder folder;
  FileStamps stamps;
  const std::filesystem::path file = folder.write("a", "one");
  std::filesystem::last_write_time(
      file, std::filesystem::file_time_type::clock::now() + std::chrono::seconds(1));
  stamps.add(file);
  EXPECT_FALSE(stamps.areCurrent());
}

}  // namespace file_stamps_test
}  // namespace synthetic_dataset::run
