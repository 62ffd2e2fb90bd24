#pragma once

#include <set>
#include <string>
#include <vector>

#include "output/writers/ready_writer.h"
#include "plugins/readback/differences.h"
#include "synthetic_dataset/output.h"

namespace synthetic_dataset::output {

/// The files of a dataset as a whole that differ from what their writer makes.
struct DifferingFiles {
  std::vector<std::string> files;         ///< absolute paths of files with other bytes
  std::set<std::string> by_name;          ///< those of them that a library has written
  std::vector<std::string> not_compared;  ///< absolute paths of files too large to be made again
  std::vector<std::string> problems;      ///< missing or unexpected files; wrong links
};

/// Compares the files byte by byte while the writer writes them.
/// @param found  absolute paths
[[nodiscard]] DifferingFiles differingDatasetFiles(const ReadyWriter& writer,
                                                   const SceneRecords& records,
                                                   std::set<std::string> found);

/// Compares a file with the right one; large files line by line, so that neither is held in memory.
/// @param name  of the file in the lines reported
void compareDatasetFile(const std::string& found, const std::string& right, const std::string& name,
                        formats::Differences& differences);

}  // namespace synthetic_dataset::output
