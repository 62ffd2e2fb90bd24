#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "motion/tf/bag_file.h"
#include "motion/tf/recorded_transform.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// Called for each transform of each message, in the order of record times over all bags.
using TransformVisitor = std::function<void(RecordedTransform transform)>;

/// Bags that count as one recording.
class BagReader {
 public:
  /// @throws ErrorList with what is wrong with each of the files: missing, not a bag, truncated,
  ///     ...
  explicit BagReader(const std::vector<std::string>& bag_files);

  /// The record times of the first and the last message, of any topic.
  [[nodiscard]] RecordedTimes times() const;

  /// The topics of all bags, each pair of name and type once.
  [[nodiscard]] std::vector<BagTopic> topics() const;

  /// What the user should know about the bags.
  [[nodiscard]] std::vector<std::string> notes() const;

  [[nodiscard]] const std::vector<std::unique_ptr<BagFile>>& bags() const { return bags_; }

  /// Reads the messages of some topics.
  /// @throws ErrorList naming the bags that are damaged
  void read(const TopicReaders& readers, const TransformVisitor& visit);

 private:
  std::vector<std::unique_ptr<BagFile>> bags_;
};

/// Reads the bags' TF (findTfTopics()).
/// @throws ErrorList as BagReader and findTfTopics do; or, if none of the bags contains TF, saying
///     what each bag has instead
RecordedTimes readTransforms(const std::vector<std::string>& bag_files,
                             const TransformVisitor& visit);

}  // namespace synthetic_dataset::motion
