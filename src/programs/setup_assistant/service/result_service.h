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

/// The dataset that runs with the settings have made so far, read from its files only.
class ResultService {
 public:
  /// @param document, allowed  have to outlive this
  ResultService(DocumentService& document, const AllowedFolders& allowed)
      : document_(document), allowed_(allowed) {}

  /// A page of the scenes that a LabelFilter accepts, and counts of what all these and the whole
  /// dataset contain.
  /// @throws HttpError 404 when there is no dataset yet
  [[nodiscard]] Value page(const HttpRequest& request);

  /// A scene's image, no wider than `width` [px]; with `labels=1`, with the labels in the files of
  /// a format (`writer=NAME`, else the first that can be drawn).
  /// @param name  "12.jpg"
  [[nodiscard]] HttpResponse picture(const std::string& name, const HttpRequest& request);

  /// Checks the dataset as the tool `verify` does.
  [[nodiscard]] Value verify();

  /// Makes the page of `report` in the dataset's folder, which takes seconds.
  /// @throws HttpError 403 if the page may not write there
  [[nodiscard]] Value makeReport();

  /// The page of `report` as it was last made. @throws HttpError 404 if there is none
  [[nodiscard]] HttpResponse report();

 private:
  [[nodiscard]] std::string folder();

  DocumentService& document_;
  const AllowedFolders& allowed_;
  std::mutex reporting_;  ///< held while a report is made: two would write the same file
  std::mutex drawing_;    ///< two pictures at a time would take the cores from the run
};

}  // namespace synthetic_dataset::programs
