#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <tinyxml2.h>

namespace synthetic_dataset::world {

/// SDF's version: 1 and 6 of "1.6".
using SdfVersion = std::pair<long, long>;

/// The newest version whose elements this program knows.
inline constexpr SdfVersion kNewestSdfVersion{1, 12};

/// Whether a text is a version: "1.6".
[[nodiscard]] bool isSdfVersion(const std::string& text);

/// @param text  may be null: 0, 0
[[nodiscard]] SdfVersion parseSdfVersion(const char* text);

/// A parsed file of SDF or URDF.
struct SdfFile {
  std::filesystem::path path;  ///< or a name for messages, of what is in no file
  std::string text;  ///< of a URDF file alone, of which parts are resolved before it is read
  tinyxml2::XMLDocument document;
  SdfVersion version{1, 6};        ///< of the root; none is taken for 1.6
  std::optional<std::string> odd;  ///< what is odd about the root: "line 2: <sdf> has no version"
  bool is_urdf = false;
  bool is_of_gz = false;  ///< it names a plugin of gz-sim's

  [[nodiscard]] const tinyxml2::XMLElement& root() const { return *document.RootElement(); }
};

/// Parses a text, repaired where need be, into the file's document.
/// @throws Error if it is no XML even then
void readXml(const std::string& text, SdfFile& file);

/// Parses each file once.
class SdfFiles {
 public:
  /// @throws Error if it is not a regular file, not XML even when repaired, or neither SDF nor
  /// URDF:
  ///     "world.sdf: line 2: cannot be read as XML (...)"
  ///     A template that is left as it is says so; one of xacro's or Jinja's is read as what is
  ///     made of it.
  [[nodiscard]] const SdfFile& read(const std::filesystem::path& file);

  /// Parses a text that is in no file.
  /// @param name  for messages
  /// @throws Error as `read`
  [[nodiscard]] const SdfFile& readText(const std::filesystem::path& name, const std::string& text);

 private:
  [[nodiscard]] const SdfFile& keep(const std::string& key, const std::filesystem::path& name,
                                    const std::function<std::string()>& text);

  std::map<std::string, std::variant<std::unique_ptr<SdfFile>, std::string>>
      files_;  ///< or why not
};

}  // namespace synthetic_dataset::world
