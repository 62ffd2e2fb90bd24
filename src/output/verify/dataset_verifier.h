#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "output/writers/writer_loader.h"

namespace synthetic_dataset::output {

/// Receives what is found while a dataset is verified, line by line.
class VerificationListener {
 public:
  virtual ~VerificationListener() = default;

  /// Reports something wrong: where, what was found and what would be right.
  virtual void problem(const std::string& line) = 0;

  /// Reports something that is right but may interest the user.
  virtual void remark(const std::string& line) = 0;

  /// Reports how many of a manifest's scenes have been checked.
  virtual void progress(std::int64_t scene_count, std::int64_t of) = 0;
};

/// How much of a dataset is verified.
enum class VerificationDepth {
  kSizes,   ///< the manifest, and that its files exist and have the right sizes
  kLabels,  ///< the content of the files as well
};

struct VerificationCounts {
  std::int64_t scenes = 0;
  std::int64_t files = 0;
  std::int64_t labels = 0;
  std::int64_t drawn = 0;  ///< scenes that were rendered again
};

class SceneVerifier;
class WrittenDataset;

/// Renders a dataset's scenes again for SceneVerifier::verifyDrawn. Exceptions count as problems.
using DrawAgain = std::function<void(const WrittenDataset& dataset, SceneVerifier& verifier)>;

/// Checks a dataset against its manifest, or those of its shards: the manifest itself, every file,
/// and every value in them, by running the writers again. Only one scene is held in memory at a
/// time. If there are no writers because the workspace is not sourced, a remark says that labels
/// are not checked.
/// @param folder  of the manifest
/// @param draw_again  called for each manifest at the end, if given
[[nodiscard]] VerificationCounts verifyDataset(const std::string& folder, VerificationDepth depth,
                                               VerificationListener& listener,
                                               const DrawAgain& draw_again = {});

/// Verifies a dataset with a given writer loader.
[[nodiscard]] VerificationCounts verifyDataset(const std::string& folder, VerificationDepth depth,
                                               VerificationListener& listener,
                                               WriterLoader& writers,
                                               const DrawAgain& draw_again = {});

}  // namespace synthetic_dataset::output
