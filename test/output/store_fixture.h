#pragma once

#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "output/dataset_store.h"
#include "support/temporary_folder.h"

namespace synthetic_dataset::output {

/// A folder with a store of two writers, `a` and `b`, of which `a` has the user file `list.txt`.
class StoreFixture : public testing::Test {
 protected:
  [[nodiscard]] std::vector<StoreWriter> writers() const;
  std::unique_ptr<DatasetStore> makeStore(IfExists if_exists = IfExists::kResume);
  std::unique_ptr<DatasetStore> makeStore(const StoreOptions& options);
  [[nodiscard]] StoreOptions options() const;

  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }
  [[nodiscard]] OutputFile text(const std::string& name, const std::string& content) const;
  [[nodiscard]] OutputFile image(const std::string& name, const cv::Mat& pixels) const;

  /// Every file and folder below the folder but the manifest, relative to it, sorted.
  [[nodiscard]] std::vector<std::string> tree() const;

  /// A query's rows, columns joined with `|`, NULL as "NULL"; read without our own code for files.
  [[nodiscard]] std::vector<std::string> query(const std::string& sql) const;

  test::TemporaryFolder folder_;
};

/// The messages of the ErrorList that making the store throws; empty if it throws none.
[[nodiscard]] std::vector<std::string> errorsOf(const StoreOptions& options,
                                                const std::vector<StoreWriter>& writers);

}  // namespace synthetic_dataset::output
