#pragma once

#include <string>
#include <vector>

#include "run/reporter.h"
#include "run/run_summary.h"

namespace synthetic_dataset::run {

/// Merges the shards of a run into one dataset, byte for byte the same as that of a single run.
///
/// Scenes are taken over as they are; the files that describe the whole dataset are made anew, so
/// the run's inputs must still be where they were. If the process is killed, the same call
/// continues. Shards in the output folder itself become part of the dataset; those in other folders
/// stay, and share their files' content with it if the file system allows.
/// @param output_folder  where the dataset is to be; may contain shards
/// @param shard_folders  more folders that contain shards
/// @param plugin_xml_files  where to look for writers; if empty, all that installed packages export
/// @return the summary, with messages about missing labels, whether the dataset was already
///     complete, and its manifest
/// @throws ErrorList: shards that are missing, not complete, or of another run; what cannot be
///     written. Then the shards are as they were.
RunSummary mergeShards(const std::string& output_folder,
                       const std::vector<std::string>& shard_folders, Reporter& reporter,
                       const std::vector<std::string>& plugin_xml_files = {});

}  // namespace synthetic_dataset::run
