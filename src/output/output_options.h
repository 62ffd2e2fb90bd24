#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::output {

/// One entry of the parameter `writers`.
struct WriterOptions {
  std::string name;           ///< also the group of its parameters
  std::string type;           ///< pluginlib's lookup name: "synthetic_dataset/Yolo"
  std::string output_folder;  ///< absolute, ending in `/`
  Parameters parameters;      ///< the group `name`
};

/// What to do with a dataset that is already there.
enum class IfExists {
  kResume,     ///< go on with it, if it was begun with the same settings
  kOverwrite,  ///< remove the files that its manifest lists, and nothing else
  kError,      ///< refuse
};

/// How hard a run waits for the disk.
enum class Sync {
  kOff,    ///< never: a power cut may cost anything
  kScene,  ///< after each scene
  kBatch,  ///< after each so many scenes
};

/// What a run makes of a job: every `count`-th block of instants, beginning with block `index`.
struct Shard {
  std::int64_t index = 0;  ///< 0 .. count - 1
  std::int64_t count = 1;
};

/// Where a dataset's scenes come from.
enum class Source {
  kScenes,  ///< they are made one by one
  kShards,  ///< they are taken in from shards, which may lie in the same folder
};

struct StoreOptions {
  std::string folder;  ///< of the manifest, absolute
  IfExists if_exists = IfExists::kResume;
  Sync sync = Sync::kBatch;
  std::optional<Shard> shard = {};  ///< the part of a run that this one makes
  Source source = Source::kScenes;
  int png_compression = 1;  ///< 0 and 1 fastest .. 9 smallest
  int jpeg_quality = 95;    ///< 1 .. 100
};

}  // namespace synthetic_dataset::output
