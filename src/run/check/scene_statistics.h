#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "label/label_options.h"
#include "run/check/finding.h"
#include "synthetic_dataset/scene.h"

namespace synthetic_dataset::run {

/// Counts oddities of finished scenes, in constant memory.
class SceneStatistics {
 public:
  /// @param labels  the options with which scenes are labelled
  explicit SceneStatistics(const label::LabelOptions& labels)
      : has_thresholds_(labels.hasThresholds()) {}

  void add(const Scene& scene);

  /// Findings about pictures that are dark, bright or of one colour, and about labels of few
  /// pixels.
  [[nodiscard]] std::vector<Finding> findings() const;

 private:
  /// The number of pictures of one kind, and the first of them.
  struct Pictures {
    std::int64_t count = 0;
    std::string first;
  };

  void addPicture(const Scene& scene);
  void addLabels(const Scene& scene);
  [[nodiscard]] bool areMany(std::int64_t count, std::int64_t of) const;
  void findPictures(const Pictures& pictures, const std::string& kind, const std::string& are,
                    const std::string& cure, std::vector<Finding>& findings) const;

  bool has_thresholds_;
  std::int64_t scenes_ = 0;
  Pictures dark_, bright_, plain_;
  std::int64_t labels_ = 0;
  std::int64_t tiny_labels_ = 0;
};

}  // namespace synthetic_dataset::run
