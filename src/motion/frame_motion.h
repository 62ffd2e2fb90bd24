#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "motion/bag_motion.h"
#include "synthetic_dataset/pose.h"

namespace synthetic_dataset::motion {

/// X_GF of what is not there: so deep that nothing meets it.
[[nodiscard]] const Pose& nowhere();

/// Where frames are at a time: some are placed anew for each scene, all others are where the
/// recording has them, if there is one. A copy keeps what is placed as it is, for who asks later.
class FrameMotion {
 public:
  /// @param global_frame  in which frames are placed
  /// @param recording  none: nothing but what is placed is known
  FrameMotion(std::string global_frame, std::shared_ptr<const BagMotion> recording);

  /// None where there is none.
  [[nodiscard]] const BagMotion* recording() const { return recording_.get(); }

  [[nodiscard]] const std::string& globalFrame() const { return global_frame_; }

  /// Puts a frame somewhere, from now on and whatever the recording has of it.
  void place(const std::string& frame, const Pose& X_GF);

  [[nodiscard]] bool isPlaced(const std::string& frame) const;
  [[nodiscard]] bool knowsFrame(const std::string& frame) const;

  /// "; did you mean 'alpha/base_link'?" about a frame that is not known, or nothing.
  [[nodiscard]] std::string suggestFrame(const std::string& frame) const;

  /// X_GF: of a placed frame at any time, of others as BagMotion has it.
  /// @throws Error where it is not known then
  [[nodiscard]] Pose pose(const std::string& frame, Stamp time) const;

  /// Whether pose() has an answer.
  [[nodiscard]] bool hasPose(const std::string& frame, Stamp time) const;

 private:
  [[nodiscard]] bool isGlobal(const std::string& frame) const;

  std::string global_frame_;
  std::shared_ptr<const BagMotion> recording_;
  std::map<std::string, Pose> placed_;  ///< X_GF
};

}  // namespace synthetic_dataset::motion
