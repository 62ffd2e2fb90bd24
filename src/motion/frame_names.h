#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

namespace synthetic_dataset::motion {

/// A frame: its index in FrameNames. Names are looked up once, at set-up.
enum class FrameId : std::int32_t {};
constexpr FrameId kNoFrame{-1};

/// tf (version 1) wrote frames with a leading slash, tf2 refuses it: "/map" is "map".
[[nodiscard]] std::string withoutLeadingSlashes(const std::string& frame);

/// The frames that differ from a name by separators, case or a prefix only, up to three.
[[nodiscard]] std::vector<std::string> framesLike(const std::string& name,
                                                  const std::vector<std::string>& frames);

/// "; did you mean 'alpha/base_link'?" for the end of a message, or nothing when no frame is alike:
/// the frames that differ by separators, case or a prefix only ("alpha/" too few or many), else the
/// one that a typing mistake may have meant.
[[nodiscard]] std::string didYouMeanFrame(const std::string& name,
                                          const std::vector<std::string>& frames);

/// The names of frames. Leading slashes do not count.
class FrameNames {
 public:
  [[nodiscard]] FrameId findOrAdd(const std::string& name);
  [[nodiscard]] std::optional<FrameId> find(const std::string& name) const;
  [[nodiscard]] const std::string& of(FrameId frame) const;

  /// All names in the order in which they were added.
  [[nodiscard]] const std::vector<std::string>& all() const { return names_; }

 private:
  std::unordered_map<std::string, FrameId> ids_;
  std::vector<std::string> names_;
};

}  // namespace synthetic_dataset::motion
