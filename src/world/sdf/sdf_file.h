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

/// An SDF version: 1 and 6 for "1.6".
using SdfVersion = std::pair<long, long>;

/// The newest version whose elements this program knows.
inline constexpr SdfVersion kNewestSdfVersion{1, 12};

/// Whether a text is a version: "1.6".
[[nodiscard]] bool isSdfVersion(const std::string& text);

/// @param text  null gives 0, 0
[[nodiscard]] SdfVersion parseSdfVersion(const char* text);

/// A parsed SDF or URDF file.
struct SdfFile {
  std::filesystem::path path;  ///< or a name for messages, of a text that is in no file
  std::string text;  ///< only of a URDF file, parts of which are resolved before it is read
  tinyxml2::XMLDocument document;
  SdfVersion version{1, 6};        ///< of the root; 1.6 if it has none
  std::optional<std::string> odd;  ///< what is odd about the root: "line 2: <sdf> has no version"
  bool is_urdf = false;
  bool is_of_gz = false;  ///< it names a plugin of gz-sim

  [[nodiscard]] const tinyxml2::XMLElement& root() const { return *document.RootElement(); }
};

/// Parses a text, repaired if necessary, into the file's document.
/// @throws Error if it is not XML even then
void readXml(const std::string& text, SdfFile& file);

/// Parses each file once.
class SdfFiles {
 public:
  /// @throws Error if it is not a regular file, not XML even when repaired, or neither SDF nor
  ///     URDF: "world.sdf: line 2: cannot be read as XML (...)". For a template that was not
  ///     expanded, the error says so; xacro and Jinja templates are read in expanded form.
  [[nodiscard]] const SdfFile& read(const std::filesystem::path& file);

  /// Parses a text that is in no file.
  /// @param name  for messages
  /// @throws Error as `read`
  [[nodiscard]] const SdfFile& readText(const std::filesystem::path& name, const std::string& text);

 private:
  [[nodiscard]] const SdfFile& keep(const std::string& key, const std::filesystem::path& name,
                                    const std::function<std::string()>& text);

  std::map<std::string, std::variant<std::unique_ptr<SdfFile>, std::string>>
      files_;  ///< or why it cannot be read
};

}  // namespace synthetic_dataset::world
