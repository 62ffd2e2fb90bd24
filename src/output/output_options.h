#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "synthetic_dataset/parameters.h"

namespace synthetic_dataset::output {

/// One entry of the parameter `writers`.
struct WriterOptions {
  std::string name;           ///< also the name of its parameter group
  std::string type;           ///< pluginlib's lookup name: "synthetic_dataset/Yolo"
  std::string output_folder;  ///< absolute, ending in `/`
  Parameters parameters;      ///< the parameter group `name`
};

/// What to do with a dataset that already exists.
enum class IfExists {
  kResume,     ///< resume it, if it was begun with the same settings
  kOverwrite,  ///< remove the files that its manifest lists, and nothing else
  kError,      ///< refuse
};

/// When a run waits for the disk.
enum class Sync {
  kOff,    ///< never: a power cut may lose anything
  kScene,  ///< after each scene
  kBatch,  ///< after every batch of scenes
};

/// The part of a job that a run makes: every `count`-th block of instants, from block `index` on.
struct Shard {
  std::int64_t index = 0;  ///< 0 .. count - 1
  std::int64_t count = 1;
};

/// Where a dataset's scenes come from.
enum class Source {
  kScenes,  ///< they are made one by one
  kShards,  ///< they are taken from shards, which may be in the same folder
};

struct StoreOptions {
  std::string folder;  ///< of the manifest, absolute
  IfExists if_exists = IfExists::kResume;
  Sync sync = Sync::kBatch;
  std::optional<Shard> shard = {};  ///< the part of the job that this run makes, if not all of it
  Source source = Source::kScenes;
  int png_compression = 1;  ///< 0 and 1 fastest .. 9 smallest
  int jpeg_quality = 95;    ///< 1 .. 100
};

}  // namespace synthetic_dataset::output
