#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <typeindex>
#include <utility>

namespace synthetic_dataset::formats {

/// Keeps the content of files that describe many scenes, so that readers read each once rather than
/// for every scene. The files must not change during its lifetime.
class KeptFiles {
 public:
  /// A file's content: `Content(file)`, made at the first call and kept for later ones.
  template <class Content>
  [[nodiscard]] std::shared_ptr<const Content> get(const std::filesystem::path& file) {
    constexpr std::size_t kMost = 64;  // BOP uses three per camera at a time
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
