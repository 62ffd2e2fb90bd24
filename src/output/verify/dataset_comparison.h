#pragma once

#include <set>
#include <string>
#include <vector>

#include "output/writers/ready_writer.h"
#include "plugins/readback/differences.h"
#include "synthetic_dataset/output.h"

namespace synthetic_dataset::output {

/// Which files of a dataset as a whole are other ones than their writer makes.
struct DifferingFiles {
  std::vector<std::string> files;         ///< absolute, of other bytes
  std::set<std::string> by_name;          ///< of these, those that a library has written
  std::vector<std::string> not_compared;  ///< absolute, too large to be made once more
  std::vector<std::string> problems;      ///< files that lack, or should not be there; wrong links
};

/// Compares them byte by byte while the writer writes them.
/// @param found  absolute paths
[[nodiscard]] DifferingFiles differingDatasetFiles(const ReadyWriter& writer,
                                                   const SceneRecords& records,
                                                   std::set<std::string> found);

/// Compares a file with the right one; large ones line by line, so that neither is held.
/// @param name  for the lines
void compareDatasetFile(const std::string& found, const std::string& right, const std::string& name,
                        formats::Differences& differences);

}  // namespace synthetic_dataset::output
