#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "base/image/image_encoder.h"
#include "output/store_types.h"
#include "output/writers/ready_writer.h"
#include "plugins/readback/differences.h"

namespace synthetic_dataset::output {

/// What exists of one writer's output for a scene.
struct FoundScene {
  std::string folder;                       ///< folder of the writer, absolute, ending in `/`
  std::set<std::string> files;              ///< absolute
  std::set<std::string> checked;            ///< those already known to be right or wrong
  std::vector<SceneFiles::Record> records;  ///< in the manifest
  std::vector<std::string> warnings;        ///< in the manifest
};

/// What a writer makes of a scene. If some pictures are unknown, `other` is what it makes of the
/// same scene with different pictures: where the two differ, the output depends on unknown pictures
/// and cannot be verified.
struct RewrittenScene {
  ReadyWriter::SceneResult result;
  std::optional<ReadyWriter::SceneResult> other = {};
  /// Quality of the JPEG files; set for a scene that was rendered again, with all pictures known.
  std::optional<base::ImageQuality> drawn_quality = {};
};

/// How a scene's files and the manifest's records differ from what they should be.
struct SceneDifferences {
  formats::Differences values;
  formats::Differences pictures;
  /// A file that cannot be verified because it depends on unknown pictures; empty if there is none.
  std::string unknown;
};

/// Compares the files one by one, and what the manifest stores.
[[nodiscard]] SceneDifferences compareScene(const FoundScene& found, const RewrittenScene& right);

/// A file's path as shown in messages: relative to the writer's folder if it is inside.
[[nodiscard]] std::string pathBelow(const std::string& folder, const std::string& path);

}  // namespace synthetic_dataset::output
