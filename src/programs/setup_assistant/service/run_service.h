#pragma once

#include <filesystem>
#include <functional>
#include <mutex>
#include <string>

#include "programs/setup_assistant/folders/allowed_folders.h"
#include "programs/setup_assistant/run/run_control.h"
#include "programs/setup_assistant/service/document_service.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The run of the settings: one that this server has started, or somebody else.
class RunService {
 public:
  /// @param document, allowed  have to outlive this
  /// @param on_change  receives the state when it has changed
  /// @param on_end  called when a run has ended, or begun elsewhere
  RunService(DocumentService& document, const AllowedFolders& allowed,
             std::function<void(const Value& state)> on_change, std::function<void()> on_end);

  /// @param body  `scenes`, how many scenes or a list of them: only these are made, the others can
  ///     be made later; `replace`, the output folder: what an earlier run made there is removed
  ///     first
  /// @throws HttpError if the settings on the disk are not those of the page, the run would write
  ///     where the page may not, or the folder is not the one to be replaced
  [[nodiscard]] Value start(const Value& body);
  [[nodiscard]] Value stop();
  [[nodiscard]] Value state();

  /// Checks whether somebody else's run has begun or ended.
  void look();

 private:
  [[nodiscard]] Value::Map settings();
  void requireOwnFolders(const Value::Map& settings) const;

  DocumentService& document_;
  const AllowedFolders& allowed_;
  std::function<void(const Value& state)> on_change_;
  std::function<void()> on_end_;
  std::mutex mutex_;
  bool was_elsewhere_ = false;
  RunControl run_;  ///< declared last: it uses the other members
};

/// The folder into which settings write the dataset; empty if they name none.
[[nodiscard]] std::string outputFolderOf(const Value& settings);

}  // namespace synthetic_dataset::programs
