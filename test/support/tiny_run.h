#pragma once

#include <memory>
#include <string>

#include "support/temporary_folder.h"
#include "synthetic_dataset/value.h"

namespace synthetic_dataset::test {

/// A whole run in a folder of its own: a bag of one second in which `alpha` drives past and `bravo`
/// stands, a world with a floor and their models, a small camera.
class TinyRun {
 public:
  /// @param folder  where its files go
  explicit TinyRun(
      std::shared_ptr<const TemporaryFolder> folder = std::make_shared<TemporaryFolder>());

  [[nodiscard]] const TemporaryFolder& folder() const { return *folder_; }

  /// Valid parameters; the dataset goes to folder() / "out".
  [[nodiscard]] Value::Map parameters() const;

  /// An object's parameters: a box of 0.4 m with two keypoints.
  [[nodiscard]] static Value::Map object(const std::string& id);

 private:
  std::shared_ptr<const TemporaryFolder> folder_;
};

}  // namespace synthetic_dataset::test
