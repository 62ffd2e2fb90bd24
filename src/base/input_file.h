#pragma once

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// The one way to files that are read: reading from a pipe or a device may never end.
namespace synthetic_dataset::base {

/// "; did you mean 'x'?" of a file's neighbours, for the end of a message about one that is not
/// there, or nothing.
[[nodiscard]] std::string didYouMeanFile(const std::filesystem::path& file);

/// @throws Error "<file>: no such file ...", "<file>: is a folder; a file is needed", "<file>: is a
///     pipe or a device; a file is needed"
[[nodiscard]] std::ifstream openInput(const std::filesystem::path& file);

/// A file's bytes.
/// @throws Error as openInput does
[[nodiscard]] std::string readInput(const std::filesystem::path& file);
[[nodiscard]] std::vector<std::uint8_t> readInputBytes(const std::filesystem::path& file);

/// Keeps which files its thread opens while it lives, those that cannot be opened too, and those
/// that sandboxed processes open for it. Several may be nested.
class InputWatch {
 public:
  InputWatch();
  ~InputWatch();
  InputWatch(const InputWatch&) = delete;
  InputWatch& operator=(const InputWatch&) = delete;

  [[nodiscard]] const std::set<std::filesystem::path>& files() const { return files_; }

  /// Has all watches of this thread keep a file.
  static void note(const std::filesystem::path& file);

 private:
  std::set<std::filesystem::path> files_;
  InputWatch* outer_;
};

/// Why an existing path is not a file, "is a folder; a file is needed"; empty
/// for a file, and for what is not there.
[[nodiscard]] std::string inputFault(const std::filesystem::path& file);

/// Why a file that should be a text is none, by how it begins: "is compressed; `gunzip` unpacks
/// it"; empty: it may be one.
/// @param start  the first bytes, four at least where there are as many
[[nodiscard]] std::string compressionFault(std::string_view start);

/// The same, and "is UTF-16; ..." and "is no text file".
[[nodiscard]] std::string textFault(std::string_view bytes);

/// Whether a message says that something is a pipe or a device: such a path is never left out, like
/// a file that is missing, since something is wrong with the whole setup. (Messages of sandboxed
/// processes are texts.)
[[nodiscard]] bool isAboutPipe(std::string_view message);

}  // namespace synthetic_dataset::base
