#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "output/writers/writer_loader.h"

namespace synthetic_dataset::output {

/// Hears what is found while a dataset is verified, line by line.
class VerificationListener {
 public:
  virtual ~VerificationListener() = default;

  /// Something is not as it should be: where, what was found and what would be right.
  virtual void problem(const std::string& line) = 0;

  /// Something that the user may want to know, and that is right.
  virtual void remark(const std::string& line) = 0;

  /// So many of a manifest's scenes have been looked at.
  virtual void progress(std::int64_t scene_count, std::int64_t of) = 0;
};

/// How much of a dataset is verified.
enum class VerificationDepth {
  kSizes,   ///< the manifest; that its files are there and have their sizes
  kLabels,  ///< all that the files hold, too
};

struct VerificationCounts {
  std::int64_t scenes = 0;
  std::int64_t files = 0;
  std::int64_t labels = 0;
  std::int64_t drawn = 0;  ///< scenes that were drawn again
};

class SceneVerifier;
class WrittenDataset;

/// Draws a dataset's scenes again for SceneVerifier::verifyDrawn. What it throws is a problem.
using DrawAgain = std::function<void(const WrittenDataset& dataset, SceneVerifier& verifier)>;

/// Checks a dataset against its manifest, or those of its shards: the manifest itself, every file,
/// and every value in them, by running the writers again. Only one scene is held at a time. Where
/// there are no writers, as the workspace is not sourced, a remark says that labels are not
/// checked.
/// @param folder  of the manifest
/// @param draw_again  called for each manifest at the end, where it is given
[[nodiscard]] VerificationCounts verifyDataset(const std::string& folder, VerificationDepth depth,
                                               VerificationListener& listener,
                                               const DrawAgain& draw_again = {});

/// The same with writers that are at hand.
[[nodiscard]] VerificationCounts verifyDataset(const std::string& folder, VerificationDepth depth,
                                               VerificationListener& listener,
                                               WriterLoader& writers,
                                               const DrawAgain& draw_again = {});

}  // namespace synthetic_dataset::output
