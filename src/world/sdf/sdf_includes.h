#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "world/sdf/model_source.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Follows `<include>`s: finds the files and puts what they hold into the tree of models.
class SdfIncludes {
 public:
  explicit SdfIncludes(SdfReading& reading) : reading_(reading) {}

  /// A `<model>` with the models in it and those that it includes.
  /// @param outer  the location of what holds it
  [[nodiscard]] ModelSource modelOf(const Element& model, const SourceLocation& outer);

  /// What an `<include>` means. What is missing, no SDF, or includes itself is reported, and found
  /// to be Kind::kNothing: its name and pose are known still, as others may be relative to it.
  [[nodiscard]] ModelSource followed(const Element& include, const SourceLocation& outer);

 private:
  [[nodiscard]] ModelSource included(const std::string& uri, const Element& include);
  [[nodiscard]] ModelSource contentOf(const SdfFile& file, const SourceLocation& location);
  [[nodiscard]] const SdfFile& fileOf(const std::string& uri, const Element& include);
  void applyOverrides(const Element& include, const SourceLocation& location,
                      ModelSource& source) const;

  SdfReading& reading_;
  std::vector<std::filesystem::path> chain_;  ///< of the files that are being followed
  std::size_t count_ = 0;                     ///< of all includes that were followed
};

}  // namespace synthetic_dataset::world
