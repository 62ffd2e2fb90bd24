#include "programs/setup_assistant/folders/allowed_folders.h"

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "programs/setup_assistant/folders/file_browser.h"
#include "programs/setup_assistant/web/http_message.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

/// A user's folder, beside one that must not be shown.
class UsersFolder : public test::TemporaryFolder {
 public:
  UsersFolder() {
    write("mine/settings.yaml", "a: 1\n");
    write("mine/bags/one.bag", "#ROSBAG V2.0\n");
    write("mine/hall.sdf", "<?xml version='1.0'?><sdf><world name='w'/></sdf>");
    write("mine/cup.sdf", "<sdf><model name='cup'/></sdf>");
    write("mine/lens.yaml", "camera_matrix: {}\n");
    write("mine/.hidden.yaml", "a: 1\n");
    write("secret/key.yaml", "b: 2\n");
    write("mine_too/other.yaml", "c: 3\n");
    fs::create_directory_symlink(path() / "secret", path() / "mine" / "way_out");
    fs::create_symlink(path() / "secret" / "key.yaml", path() / "mine" / "key.yaml");
  }
};

struct TwoFolders {
  [[nodiscard]] std::string mine() const { return fs::canonical(folder / "mine").string(); }

  UsersFolder folder;
  AllowedFolders allowed{folder / "mine" / "settings.yaml", {}};
};

int statusOf(const AllowedFolders& allowed, const fs::path& path) {
  try {
    (void)allowed.resolve(path);
  } catch (const HttpError& error) {
    return error.status();
  }
  return 200;
}

std::string textOfListing(const Value& listing, const std::string& part) {
  std::string text;
  for (const Value& each : *listing.as<Value::Map>()->at(part).as<Value::List>()) {
    const auto& entry = *each.as<Value::Map>();
    text += entry.at("name").text() + (part == "files" ? ":" + entry.at("kind").text() : "") + " ";
  }
  return text;
}

TEST(AllowedFolders, HoldTheSettingsOwnFolder) {
  const TwoFolders two;
  EXPECT_EQ(200, statusOf(two.allowed, two.mine()));
  EXPECT_EQ(200, statusOf(two.allowed, two.mine() + "/bags/one.bag"));
  EXPECT_EQ(200, statusOf(two.allowed, "bags/one.bag"));
}

TEST(AllowedFolders, AreNotLeftByDotsOrLinks) {
  const TwoFolders two;
  EXPECT_EQ(403, statusOf(two.allowed, two.mine() + "/../secret/key.yaml"));
  EXPECT_EQ(403, statusOf(two.allowed, "../secret"));
  EXPECT_EQ(403, statusOf(two.allowed, two.mine() + "/way_out/key.yaml"));
  EXPECT_EQ(403, statusOf(two.allowed, two.mine() + "/key.yaml"));
  EXPECT_EQ(403, statusOf(two.allowed, two.mine() + "/bags/../../secret"));
  EXPECT_EQ(403, statusOf(two.allowed, two.folder / "mine_too"));  // begins like the other
  EXPECT_EQ(403, statusOf(two.allowed, "/etc/passwd"));
}

TEST(AllowedFolders, DoNotSayWhatThereIsElsewhere) {
  const TwoFolders two;
  EXPECT_EQ(statusOf(two.allowed, "/no/such/file"), statusOf(two.allowed, "/etc/passwd"));
}

TEST(AllowedFolders, AreMoreWhereTheUserNamesThem) {
  const TwoFolders two;
  const AllowedFolders allowed(two.folder / "mine" / "settings.yaml",
                               {(two.folder / "secret").string()});
  EXPECT_EQ(200, statusOf(allowed, two.mine() + "/way_out/key.yaml"));
  EXPECT_EQ(two.mine(), allowed.home().string());
}

TEST(FileBrowser, ListsFilesByWhatTheyAreFor) {
  const TwoFolders two;
  const Value all = listFolder(two.allowed, two.mine(), {});
  EXPECT_EQ("cup.sdf:model hall.sdf:world lens.yaml:calibration settings.yaml:yaml ",
            textOfListing(all, "files"));
  EXPECT_EQ("bags ", textOfListing(all, "folders"));
  EXPECT_EQ("hall.sdf:world ",
            textOfListing(listFolder(two.allowed, two.mine(), {"world"}), "files"));
}

TEST(FileBrowser, AFolderOfRos2IsABagAndAFolder) {
  const TwoFolders two;
  two.folder.write("mine/walk/metadata.yaml", "rosbag2_bagfile_information: {}\n");
  two.folder.write("mine/walk/walk_0.mcap", "\x89MCAP0\r\n");
  const Value bags = listFolder(two.allowed, two.mine(), {"bag"});
  EXPECT_EQ("walk:bag ", textOfListing(bags, "files"));
  EXPECT_EQ("bags walk ", textOfListing(bags, "folders"));
  EXPECT_EQ("walk_0.mcap:bag ",
            textOfListing(listFolder(two.allowed, two.mine() + "/walk", {"bag"}), "files"));
}

TEST(FileBrowser, KnowsTheFolderAboveAsFarAsItIsAllowed) {
  const TwoFolders two;
  EXPECT_TRUE(listFolder(two.allowed, two.mine(), {}).as<Value::Map>()->at("parent").isNull());
  EXPECT_EQ(Value(two.mine()),
            listFolder(two.allowed, two.mine() + "/bags", {}).as<Value::Map>()->at("parent"));
  EXPECT_EQ(0U, textOfListing(listFolder(two.allowed, "", {}), "folders").find(two.mine()));
}

}  // namespace
}  // namespace synthetic_dataset::programs
