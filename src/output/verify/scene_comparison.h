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

/// What there is of a scene of one writer.
struct FoundScene {
  std::string folder;                       ///< the writer's, absolute, ending in `/`
  std::set<std::string> files;              ///< absolute
  std::set<std::string> checked;            ///< of these, what is known to be right, or wrong
  std::vector<SceneFiles::Record> records;  ///< in the manifest
  std::vector<std::string> warnings;        ///< in the manifest
};

/// What a writer makes of a scene. Where pictures are not known, `other` is what it makes of the
/// same scene with others: what differs between the two depends on them, and nobody knows what is
/// right.
struct RewrittenScene {
  ReadyWriter::SceneResult result;
  std::optional<ReadyWriter::SceneResult> other = {};
  /// Of a scene that was drawn again, whose pictures are all known: of its JPEG files.
  std::optional<base::ImageQuality> drawn_quality = {};
};

/// In what a scene's files and the manifest differ from what they should have.
struct SceneDifferences {
  formats::Differences values;
  formats::Differences pictures;
  /// A file that nobody can know, as it depends on pictures that are not known; empty: none.
  std::string unknown;
};

/// Compares them file by file, and what the manifest keeps.
[[nodiscard]] SceneDifferences compareScene(const FoundScene& found, const RewrittenScene& right);

/// A file's path as lines name it: below the writer's folder where it is there.
[[nodiscard]] std::string pathBelow(const std::string& folder, const std::string& path);

}  // namespace synthetic_dataset::output
