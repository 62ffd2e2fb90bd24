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

/// tf (version 1) wrote frames with a leading slash, which tf2 rejects: "/map" is "map".
[[nodiscard]] std::string withoutLeadingSlashes(const std::string& frame);

/// Up to three frames that differ from a name only by separators, case or a prefix.
[[nodiscard]] std::vector<std::string> framesLike(const std::string& name,
                                                  const std::vector<std::string>& frames);

/// "; did you mean 'alpha/base_link'?" for the end of a message, or nothing if no frame is similar:
/// the frames that differ only by separators, case or a prefix ("alpha/" missing or extra), or else
/// the one that a typing mistake may have meant.
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
