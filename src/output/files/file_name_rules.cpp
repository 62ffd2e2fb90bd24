#include "output/files/file_name_rules.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <system_error>

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

/// Resolves symbolic links as far as the path exists; empty on failure.
std::string withoutLinks(const std::string& path) {
  std::error_code error;
  const fs::path found = fs::weakly_canonical(path, error);
  return error ? std::string() : found.string();
}

}  // namespace

std::string absolutePath(const std::string& path) {
  return std::filesystem::absolute(path).lexically_normal().string();
}

bool liesWithin(std::string_view path, std::string_view folder) {
  if (!folder.empty() && folder.back() == '/') folder.remove_suffix(1);
  return path.substr(0, folder.size()) == folder &&
         (path.size() == folder.size() || path[folder.size()] == '/');
}

std::vector<std::string> filesOutside(const std::vector<std::string>& files,
                                      const std::vector<std::string>& folders) {
  std::vector<std::string> real_folders;
  for (const std::string& folder : folders) real_folders.push_back(withoutLinks(folder));
  std::map<std::string, bool> is_inside;  // by folder
  std::vector<std::string> outside;
  for (const std::string& file : files) {
    const std::string folder = fs::path(file).parent_path().string();
    const auto [known, is_new] = is_inside.try_emplace(folder, false);
    if (is_new) {
      const std::string real = withoutLinks(folder);
      for (std::size_t i = 0; i < folders.size(); ++i) {
        known->second = known->second || (liesWithin(folder, folders[i]) && !real.empty() &&
                                          liesWithin(real, real_folders[i]));
      }
    }
    if (!known->second) outside.push_back(file);
  }
  return outside;
}

std::string firstNames(const std::vector<std::string>& names) {
  constexpr std::size_t kNamed = 3;
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) {
    list += (i == 0 ? "'" : ", '") + names[i] + "'";
  }
  return names.size() > kNamed ? list + " and more" : list;
}

}  // namespace synthetic_dataset::output
