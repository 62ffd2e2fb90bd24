#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace synthetic_dataset::run {

/// Who made a file and what may be done with it, as far as files say so. Whoever publishes pictures
/// of a model has to name its authors.
struct Credit {
  std::string author;               ///< several are separated by "; "
  std::filesystem::path author_in;  ///< the file that names them
  std::string license;              ///< as written: a name, a copyright notice, a file's name
  std::filesystem::path license_in;
};

/// Finds credits: in the file itself (COLLADA's contributors and their copyright, glTF's
/// asset.copyright), else in the model's model.config, else in the ROS package's package.xml, else
/// by a file called LICENSE or similar: in the file's folder or one of the five above it, the
/// nearest first.
class CreditFinder {
 public:
  /// @param file  absolute; one that cannot be read yields no credit
  [[nodiscard]] Credit creditOf(const std::filesystem::path& file);

 private:
  const Credit& creditOfFolder(const std::filesystem::path& folder);

  std::map<std::filesystem::path, Credit> folders_;
};

}  // namespace synthetic_dataset::run
