#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <string>

#include "programs/setup_assistant/folders/allowed_folders.h"
#include "programs/setup_assistant/service/document_service.h"
#include "programs/setup_assistant/web/http_message.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::programs {

/// The dataset that the settings have made so far, from its files alone.
class ResultService {
 public:
  /// @param document, allowed  have to outlive this
  ResultService(DocumentService& document, const AllowedFolders& allowed)
      : document_(document), allowed_(allowed) {}

  /// Some of its scenes, of those that a LabelFilter takes, and what they and all of them hold.
  /// @throws HttpError 404 when there is no dataset yet
  [[nodiscard]] Value page(const HttpRequest& request);

  /// A scene's image; with `labels=1` with those that a format's files have (`writer=NAME`, else
  /// the first that can be drawn), and no wider than `width` [px].
  /// @param name  "12.jpg"
  [[nodiscard]] HttpResponse picture(const std::string& name, const HttpRequest& request);

  /// What `verify` says.
  [[nodiscard]] Value verify();

  /// Makes the page of `report` in the dataset's folder, which takes seconds.
  /// @throws HttpError 403 where the page may not write
  [[nodiscard]] Value makeReport();

  /// That page, as it was made last. @throws HttpError 404 when it was not
  [[nodiscard]] HttpResponse report();

 private:
  [[nodiscard]] std::string folder();

  DocumentService& document_;
  const AllowedFolders& allowed_;
  std::mutex reporting_;  ///< two would write one file
  std::mutex drawing_;    ///< two pictures at a time would take the cores from the run
};

}  // namespace synthetic_dataset::programs
