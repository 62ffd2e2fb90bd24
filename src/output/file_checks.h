#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "output/written_dataset.h"

/// Whether a dataset's files are those that its manifests list.
namespace synthetic_dataset::output {

/// How closely a file is looked at.
enum class FileCheck {
  kSize,     ///< it is there and has its size
  kContent,  ///< and the bytes that were written
};

/// What is wrong with a listed file.
struct FileFinding {
  std::string problem;      ///< empty: nothing
  bool is_readable = true;  ///< a file of this name and size is there
};

/// @param path  absolute
/// @param linked_to  absolute path of the listed file that it is another name of; empty: of none
[[nodiscard]] FileFinding checkFile(const std::string& path, const std::string& linked_to,
                                    const ListedFile& file, FileCheck how);

/// Why a listed path is none that a run of this dataset could have written; empty: nothing is wrong
/// with it.
[[nodiscard]] std::string pathProblem(const ListedFile& file, const WrittenDataset& dataset);

/// Some files of many.
struct FewFiles {
  std::vector<std::string> named;  ///< the first few in alphabetical order, absolute
  std::int64_t count = 0;          ///< of all
};

/// Files in a writer's folder that no manifest lists.
struct StrayFiles {
  FewFiles unlisted;
  FewFiles half_written;  ///< what a killed run left of listed files
};

/// @param datasets  all that share the folder: a whole run, or shards
[[nodiscard]] StrayFiles strayFiles(const std::string& folder,
                                    const std::vector<const WrittenDataset*>& datasets);

}  // namespace synthetic_dataset::output
