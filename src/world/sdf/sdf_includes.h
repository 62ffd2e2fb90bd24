#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "world/sdf/model_source.h"
#include "world/sdf/sdf_reading.h"

namespace synthetic_dataset::world {

/// Follows `<include>`s: finds the files and adds their contents to the tree of models.
class SdfIncludes {
 public:
  explicit SdfIncludes(SdfReading& reading) : reading_(reading) {}

  /// A `<model>` with the models that it contains or includes.
  /// @param outer  the location of the enclosing element
  [[nodiscard]] ModelSource modelOf(const Element& model, const SourceLocation& outer);

  /// The model that an `<include>` refers to. One that is missing, not SDF, or includes itself is
  /// reported and becomes a Kind::kNothing, whose name and pose are still known, as other poses may
  /// be relative to it.
  [[nodiscard]] ModelSource followed(const Element& include, const SourceLocation& outer);

 private:
  [[nodiscard]] ModelSource included(const std::string& uri, const Element& include);
  [[nodiscard]] ModelSource contentOf(const SdfFile& file, const SourceLocation& location);
  [[nodiscard]] const SdfFile& fileOf(const std::string& uri, const Element& include);
  void applyOverrides(const Element& include, const SourceLocation& location,
                      ModelSource& source) const;

  SdfReading& reading_;
  std::vector<std::filesystem::path> chain_;  ///< the files that are being followed
  std::size_t count_ = 0;                     ///< of all includes followed so far
};

}  // namespace synthetic_dataset::world
