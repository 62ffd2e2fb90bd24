#include "output/store_fixture.h"

#include <algorithm>
#include <filesystem>

#include <sqlite3.h>

#include "support/error_messages.h"

namespace synthetic_dataset::output {

std::vector<StoreWriter> StoreFixture::writers() const {
  return {{"a", "test/A", path("a/"), {path("list.txt")}}, {"b", "test/B", path("b/"), {}}};
}

StoreOptions StoreFixture::options() const {
  StoreOptions options;
  options.folder = folder_.path().string();
  options.sync = Sync::kOff;  // tests do not wait for the disk
  return options;
}

std::unique_ptr<DatasetStore> StoreFixture::makeStore(IfExists if_exists) {
  StoreOptions chosen = options();
  chosen.if_exists = if_exists;
  return makeStore(chosen);
}

std::unique_ptr<DatasetStore> StoreFixture::makeStore(const StoreOptions& options) {
  return std::make_unique<DatasetStore>(options, writers());
}

OutputFile StoreFixture::text(const std::string& name, const std::string& content) const {
  return {name.front() == 'a' ? 0u : 1u, path(name), {}, content};
}

OutputFile StoreFixture::image(const std::string& name, const cv::Mat& pixels) const {
  return {name.front() == 'a' ? 0u : 1u, path(name), pixels, ""};
}

std::vector<std::string> StoreFixture::tree() const {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_.path())) {
    std::string name = entry.path().lexically_relative(folder_.path()).string();
    if (name.find("manifest.sqlite") == std::string::npos) names.push_back(std::move(name));
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::vector<std::string> StoreFixture::query(const std::string& sql) const {
  sqlite3* database = nullptr;
  EXPECT_EQ(sqlite3_open(path("manifest.sqlite").c_str(), &database), SQLITE_OK);
  std::vector<std::string> rows;
  const auto addRow = [](void* all, int count, char** values, char** /*names*/) {
    std::string row;
    for (int i = 0; i < count; ++i) {
      row += (i == 0 ? "" : "|") + std::string(values[i] != nullptr ? values[i] : "NULL");
    }
    static_cast<std::vector<std::string>*>(all)->push_back(row);
    return 0;
  };
  EXPECT_EQ(sqlite3_exec(database, sql.c_str(), addRow, &rows, nullptr), SQLITE_OK);
  sqlite3_close(database);
  return rows;
}

std::vector<std::string> errorsOf(const StoreOptions& options,
                                  const std::vector<StoreWriter>& writers) {
  return test::messagesOf([&] { const DatasetStore store(options, writers); });
}

}  // namespace synthetic_dataset::output
