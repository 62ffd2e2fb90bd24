#include "programs/setup_assistant/document/settings_document.h"

#include <filesystem>
#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "base/json_text.h"
#include "programs/setup_assistant/web/http_message.h"
#include "support/error_messages.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::programs {
namespace {

const std::string kText =
    "# My settings.\nsimulated_rate: 5.0  # per second\ncamera:\n  far: 50\nyolo/class: text\n";

/// A settings file in a folder of its own.
struct OpenDocument {
  explicit OpenDocument(const std::string& text = kText)
      : file(folder.write("settings.yaml", text)), document(file.string()) {}

  void set(const base::YamlPath& path, const Value& value, const std::string& step = "") {
    document.change(document.revision(), {{path, value}}, step);
  }

  [[nodiscard]] std::string onDisk() const { return test::readFile(file); }

  test::TemporaryFolder folder;
  std::filesystem::path file;
  SettingsDocument document;
};

int statusOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const HttpError& error) {
    return error.status();
  }
  return 200;
}

TEST(SettingsDocument, HasEveryChangeOnTheDiskAtOnce) {
  OpenDocument open;
  open.set({"camera", "far"}, 60);
  EXPECT_EQ(
      "# My settings.\nsimulated_rate: 5.0  # per second\ncamera:\n  far: 60\nyolo/class: text\n",
      open.onDisk());
  EXPECT_EQ(open.onDisk(), open.document.text());
}

TEST(SettingsDocument, FindsSettingsThatAreWrittenWithSlashes) {
  OpenDocument open;
  open.set({"yolo", "class"}, "number");
  EXPECT_NE(std::string::npos, open.onDisk().find("yolo/class: number\n"));
  const Value* value = base::valueAt(open.document.settings(), {"yolo", "class"});
  ASSERT_NE(nullptr, value);
  EXPECT_EQ(Value("number"), *value);
}

TEST(SettingsDocument, RemovesTheRemarkThatASettingIsToBeChosen) {
  OpenDocument open("robot_list: []  # TODO: which?\nglobal_frame: map  # TODO: which?\n");
  open.set({"robot_list"}, Value::List{"husky"});
  EXPECT_EQ("robot_list: [husky]\nglobal_frame: map  # TODO: which?\n", open.onDisk());
  open.document.undo();
  EXPECT_NE(std::string::npos, open.onDisk().find("robot_list: []  # TODO: which?"));
}

TEST(SettingsDocument, SaysAnglesAsTheyAreWritten) {
  OpenDocument open("camera: {pose: {rpy: [0, deg(20), 0.5]}}\nangle: !degrees 90\n");
  const Value* rpy = base::valueAt(open.document.settings(), {"camera", "pose", "rpy"});
  ASSERT_NE(nullptr, rpy);
  EXPECT_EQ("[0, \"deg(20)\", 0.5]", base::jsonText(*rpy));
  const Value* angle = base::valueAt(open.document.settings(), {"angle"});
  ASSERT_NE(nullptr, angle);
  EXPECT_NEAR(1.5708, *angle->as<double>(), 1e-4);
}

TEST(SettingsDocument, UndoesAndRedoesWithTheDisk) {
  OpenDocument open;
  open.set({"camera", "far"}, 60);
  open.set({"camera", "far"}, 70);
  open.document.undo();
  EXPECT_NE(std::string::npos, open.onDisk().find("far: 60"));
  open.document.undo();
  EXPECT_EQ(kText, open.onDisk());
  EXPECT_FALSE(open.document.canUndo());
  open.document.redo();
  open.document.redo();
  EXPECT_NE(std::string::npos, open.onDisk().find("far: 70"));
  EXPECT_FALSE(open.document.canRedo());
}

TEST(SettingsDocument, UndoesADragAsOneStep) {
  OpenDocument open;
  open.set({"camera", "far"}, 51, "drag1");
  open.set({"camera", "far"}, 52, "drag1");
  open.set({"camera", "far"}, 53, "drag2");
  open.document.undo();
  EXPECT_NE(std::string::npos, open.onDisk().find("far: 52"));
  open.document.undo();
  EXPECT_EQ(kText, open.onDisk());
}

TEST(SettingsDocument, MakesAllChangesOfARequestOrNone) {
  OpenDocument open;
  const auto change = [&] {
    open.document.change(open.document.revision(),
                         {{{"camera", "far"}, Value(60)}, {{"list", 5U}, Value(1)}}, "");
  };
  EXPECT_EQ(1U, test::messagesOf(change).size());
  EXPECT_EQ(kText, open.onDisk());
  EXPECT_FALSE(open.document.canUndo());
}

TEST(SettingsDocument, RefusesAChangeOfAnOlderRevision) {
  OpenDocument open;
  const std::int64_t old = open.document.revision();
  open.set({"camera", "far"}, 60);
  EXPECT_EQ(409, statusOf([&] { open.document.change(old, {{{"seed"}, Value(1)}}, ""); }));
}

TEST(SettingsDocument, KeepsTextThatIsNoYamlFromTheDisk) {
  OpenDocument open;
  open.document.type(open.document.revision(), "camera: [1,\n", "");
  EXPECT_EQ(kText, open.onDisk());
  ASSERT_TRUE(open.document.fault());
  EXPECT_LT(0, open.document.fault()->line);
  EXPECT_EQ(409, statusOf([&] { open.set({"seed"}, 1); }));
  open.document.type(open.document.revision(), "camera: [1]\n", "");
  EXPECT_FALSE(open.document.fault());
  EXPECT_EQ("camera: [1]\n", open.onDisk());
}

TEST(SettingsDocument, NeverWritesOverWhatSomebodyElseWrote) {
  OpenDocument open;
  const auto time = std::filesystem::last_write_time(open.file);
  open.folder.write("settings.yaml", "seed: 7\n");
  std::filesystem::last_write_time(open.file, time);  // as if a clock were wrong
  EXPECT_EQ(409, statusOf([&] { open.set({"camera", "far"}, 60); }));
  EXPECT_EQ(409, statusOf([&] { open.document.undo(); }));
  EXPECT_EQ("seed: 7\n", open.onDisk());
  EXPECT_EQ("seed: 7\n", open.document.outside().value_or(""));
  EXPECT_EQ(kText, open.document.text());
}

TEST(SettingsDocument, TakesSomebodyElsesTextAsAStep) {
  OpenDocument open;
  open.folder.write("settings.yaml", "seed: 7\n");
  EXPECT_TRUE(open.document.look());
  open.document.acceptExternal();
  EXPECT_FALSE(open.document.outside());
  EXPECT_EQ("seed: 7\n", open.document.text());
  open.document.undo();
  EXPECT_EQ(kText, open.onDisk());
}

TEST(SettingsDocument, WritesItsOwnTextOverSomebodyElsesWhenAsked) {
  OpenDocument open;
  open.folder.write("settings.yaml", "seed: 7\n");
  open.document.look();
  open.document.overwriteExternal();
  EXPECT_FALSE(open.document.outside());
  EXPECT_EQ(kText, open.onDisk());
  open.set({"camera", "far"}, 60);
  EXPECT_EQ(open.document.text(), open.onDisk());
}

TEST(SettingsDocument, AsksNothingWhenTheFileComesBack) {
  OpenDocument open;
  std::filesystem::remove(open.file);
  EXPECT_TRUE(open.document.look());
  EXPECT_TRUE(open.document.outside());
  open.folder.write("settings.yaml", kText);
  EXPECT_TRUE(open.document.look());
  EXPECT_FALSE(open.document.outside());
}

TEST(SettingsDocument, KeepsLinksAndPermissions) {
  namespace fs = std::filesystem;
  test::TemporaryFolder folder;
  const fs::path target = folder.write("real/target.yaml", "a: 1\n");
  fs::permissions(target, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(target, folder / "link.yaml");
  SettingsDocument document((folder / "link.yaml").string());
  document.change(document.revision(), {{{"a"}, Value(2)}}, "");
  EXPECT_TRUE(fs::is_symlink(folder / "link.yaml"));
  EXPECT_EQ("a: 2\n", test::readFile(target));
  EXPECT_EQ(fs::perms::owner_read | fs::perms::owner_write, fs::status(target).permissions());
}

}  // namespace
}  // namespace synthetic_dataset::programs
