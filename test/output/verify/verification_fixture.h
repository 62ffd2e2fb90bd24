#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "output/dataset_store.h"
#include "output/verify/dataset_verifier.h"
#include "plugins/plugin_harness.h"

namespace synthetic_dataset::output {

/// A dataset of one writer, with a manifest as a run writes it, and the findings of `verify`.
///
/// The objects are `a` of class `cup` and `b` of class `jug`, seen at (100, 100) and (300, 120) in
/// pictures of 640 x 480.
class VerificationTest : public PluginTest {
 protected:
  /// @param has_lidar  whether the run has a lidar, "top"
  explicit VerificationTest(const std::string& format, bool has_lidar = false);

  /// A scene in which both objects are seen.
  [[nodiscard]] Scene sceneOfBoth(std::int64_t index) const;

  /// Writes scenes and, unless it is to stay unfinished, completes the dataset.
  void write(const std::vector<Scene>& scenes, const Value::Map& parameters = {},
             const std::optional<output::Shard>& shard = std::nullopt);
  void writeUnfinished(const std::vector<Scene>& scenes);

  /// The problems that `verify` finds.
  [[nodiscard]] std::vector<std::string> problems(
      VerificationDepth depth = VerificationDepth::kLabels);

  /// Changes the manifest without our own code for it.
  void change(const std::string& sql, const std::string& manifest = "manifest.sqlite") const;

  /// Writes a file anew as if the run had written it, and updates its row in the manifest.
  /// @param path  below the writer's folder
  void replace(const std::string& path, const std::string& content) const;
  void edit(const std::string& path, const std::function<std::string(std::string)>& edit) const;

  /// Replaces the first `what` in a file in the same way.
  void edit(const std::string& path, const std::string& what, const std::string& instead) const;

  [[nodiscard]] std::string path(const std::string& name) const { return folder() + name; }
  [[nodiscard]] std::string read(const std::string& name) const;

  std::vector<std::string> remarks_;     ///< of the last problems()
  VerificationCounts counts_;            ///< of the last problems()
  std::vector<base::Warning> warnings_;  ///< of each scene that is written

 private:
  /// Adds a motion with all scenes if the test has named none, as every run has one.
  void nameMotion(std::size_t scenes);
  [[nodiscard]] output::RunDescription description(const Value::Map& parameters,
                                                   std::size_t scenes) const;
  [[nodiscard]] base::SceneFacts factsOf(const Scene& scene) const;
  void commit(output::DatasetStore& store, const std::vector<Scene>& scenes) const;
};

}  // namespace synthetic_dataset::output
