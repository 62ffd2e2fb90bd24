#include "motion/recorded.h"

#include <gtest/gtest.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

BagMotion recorded(const std::function<void(test::BagBuilder&)>& write,
                   const std::string& global_frame) {
  const test::TemporaryFolder folder;
  test::BagBuilder bag(folder / "recorded.bag");
  write(bag);
  return BagMotion({bag.close()}, global_frame);
}

Pose poseOf(const FrameSource& source, const std::string& frame, Stamp time) {
  return source.knownPose(source.find(frame).value_or(kNoFrame), time);
}

bool isKnown(const FrameSource& source, const std::string& frame, Stamp time) {
  return source.pose(source.find(frame).value_or(kNoFrame), time).has_value();
}

TimelineOptions everyMilliseconds(std::int64_t period_ms) {
  TimelineOptions options;
  options.period = test::milliseconds(period_ms);
  return options;
}

void moveAlongX(test::BagBuilder& bag, const std::string& parent, const std::string& child,
                std::int64_t first_ms, std::int64_t last_ms, std::int64_t step_ms) {
  for (std::int64_t ms = first_ms; ms <= last_ms; ms += step_ms) {
    bag.move(parent, child, test::milliseconds(ms),
             test::poseAt(static_cast<double>(ms) / 1000.0, 0.0, 0.0));
  }
}

std::vector<std::string> warningsOf(const FrameSource& source,
                                    const std::vector<std::string>& frames) {
  std::vector<FrameId> ids;
  for (const std::string& frame : frames) ids.push_back(*source.find(frame));
  base::Diagnostics diagnostics;
  source.report(ids, diagnostics);
  return diagnostics.messages(base::Severity::kWarning);
}

std::string messageOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no error was thrown";
  return "";
}

}  // namespace synthetic_dataset::motion
