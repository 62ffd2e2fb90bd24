#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// All input files are opened through these functions: reading from a pipe or a device may never
/// end.
namespace synthetic_dataset::base {

/// "; did you mean 'x'?" for the end of a message about a missing file, where x is a file beside
/// it, or "".
[[nodiscard]] std::string didYouMeanFile(const std::filesystem::path& file);

/// @throws Error "<file>: no such file ...", "<file>: is a folder; a file is needed", "<file>: is a
///     pipe or a device; a file is needed"
[[nodiscard]] std::ifstream openInput(const std::filesystem::path& file);

/// A file's bytes.
/// @throws Error as openInput does
[[nodiscard]] std::string readInput(const std::filesystem::path& file);
[[nodiscard]] std::vector<std::uint8_t> readInputBytes(const std::filesystem::path& file);

/// Records which files its thread opens during its lifetime, including those that cannot be opened
/// and those that sandboxed processes open for it. Several may be nested.
class InputWatch {
 public:
  InputWatch();
  ~InputWatch();
  InputWatch(const InputWatch&) = delete;
  InputWatch& operator=(const InputWatch&) = delete;

  [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }

  /// Makes all watches of this thread record a file.
  static void note(const std::filesystem::path& file);

 private:
  std::set<std::filesystem::path> files_;
  InputWatch* outer_;
};

/// Why an existing path is not a file, such as "is a folder; a file is needed"; empty for a file
/// and for a path that does not exist.
[[nodiscard]] std::string inputFault(const std::filesystem::path& file);

/// Why a file that should be a text is not one, judged by its first bytes: "is compressed; `gunzip`
/// unpacks it"; empty if it may be one.
/// @param start  the first bytes, at least four if the file has that many
[[nodiscard]] std::string compressionFault(std::string_view start);

/// compressionFault(), and also "is UTF-16; ..." and "is not a text file".
[[nodiscard]] std::string textFault(std::string_view bytes);

/// Whether a message says that something is a pipe or a device: such a path is never skipped as a
/// missing file is, since something is wrong with the whole setup. (Sandboxed processes report
/// errors only as text.)
[[nodiscard]] bool isAboutPipe(std::string_view message);

}  // namespace synthetic_dataset::base
