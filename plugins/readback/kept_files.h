#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <typeindex>
#include <utility>

namespace synthetic_dataset::formats {

/// What readers keep from scene to scene of files that describe many, so that each is read once and
/// not for every scene. The files must not change as long as it lives.
class KeptFiles {
 public:
  /// A file's content: `Content(file)` of the first call, or of one long ago.
  template <class Content>
  [[nodiscard]] std::shared_ptr<const Content> get(const std::filesystem::path& file) {
    constexpr std::size_t kMost = 64;  // BOP uses three for each camera at a time
    const Key key(typeid(Content), file);
    if (const auto found = contents_.find(key); found != contents_.end()) {
      return std::static_pointer_cast<const Content>(found->second);
    }
    auto content = std::make_shared<const Content>(file);
    if (contents_.size() >= kMost) contents_.clear();
    contents_[key] = content;
    return content;
  }

 private:
  using Key = std::pair<std::type_index, std::filesystem::path>;

  std::map<Key, std::shared_ptr<const void>> contents_;
};

}  // namespace synthetic_dataset::formats
