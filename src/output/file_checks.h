#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "output/written_dataset.h"

/// Checks that a dataset's files are those that its manifests list.
namespace synthetic_dataset::output {

/// How closely to check a file.
enum class FileCheck {
  kSize,     ///< it exists and has the right size
  kContent,  ///< and contains the bytes that were written
};

/// What is wrong with a listed file.
struct FileFinding {
  std::string problem;      ///< empty if there is none
  bool is_readable = true;  ///< a file of this name and size exists
};

/// @param path  absolute
/// @param linked_to  absolute path of the listed file that this is another name of; empty if none
[[nodiscard]] FileFinding checkFile(const std::string& path, const std::string& linked_to,
                                    const ListedFile& file, FileCheck how);

/// Why a run of this dataset could not have written to a listed path; empty if nothing is wrong.
[[nodiscard]] std::string pathProblem(const ListedFile& file, const WrittenDataset& dataset);

/// A few examples out of many files.
struct FewFiles {
  std::vector<std::string> named;  ///< the first few in alphabetical order, absolute paths
  std::int64_t count = 0;          ///< of all the files
};

/// Files in a writer's folder that no manifest lists.
struct StrayFiles {
  FewFiles unlisted;
  FewFiles half_written;  ///< remains of listed files after a run was killed
};

/// @param datasets  all those that share the folder: a whole run, or shards
[[nodiscard]] StrayFiles strayFiles(const std::string& folder,
                                    const std::vector<const WrittenDataset*>& datasets);

}  // namespace synthetic_dataset::output
