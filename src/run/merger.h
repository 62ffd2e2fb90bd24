#pragma once

#include <string>
#include <vector>

#include "run/reporter.h"
#include "run/run_summary.h"

namespace synthetic_dataset::run {

/// Makes one dataset of the shards of a run, byte for byte that of a single run.
///
/// Scenes are taken over as they are; the files of the dataset as a whole are made anew, so the
/// run's inputs have to be where they were. Killed, the same call goes on. Shards in the output
/// folder itself become part of the dataset; those in other folders stay, and share their files'
/// content with it where the file system allows.
/// @param output_folder  where the dataset is to be; may hold shards
/// @param shard_folders  more folders that hold shards
/// @param plugin_xml_files  where to look for writers; empty: all that installed packages export
/// @return with what the user should know of labels that are missing, whether the dataset was
/// complete
///     before, and its manifest
/// @throws ErrorList: shards that are missing, not complete, or of another run; what cannot be
///     written. Then the shards are as they were.
RunSummary mergeShards(const std::string& output_folder,
                       const std::vector<std::string>& shard_folders, Reporter& reporter,
                       const std::vector<std::string>& plugin_xml_files = {});

}  // namespace synthetic_dataset::run
