#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "synthetic_dataset/output.h"

namespace synthetic_dataset::output {

/// A file that appears whole or not at all.
///
/// Its content is written under a temporary name in the same folder; publish() gives it its final
/// name. The destructor removes the file, published or not, unless it is kept.
class PendingFile {
 public:
  /// All of these create the file's folder, and replace a temporary file left by a killed run.
  /// @throws Error naming the path and why it cannot be written
  static PendingFile withBytes(const std::string& path, std::string_view bytes);

  /// @throws whatever `content` throws, too
  static PendingFile withContent(const std::string& path, const DatasetOutput::Content& content);

  /// A file that `write` fills, given its temporary name.
  /// @throws whatever `write` throws, too
  static PendingFile writtenBy(const std::string& path,
                               const std::function<void(const std::string& file)>& write);

  /// A file with the same content as an existing one: by a hard link, or by a copy.
  static PendingFile linkedToFile(const std::string& original, const std::string& path);

  /// A file with the same content as another one that is not published yet: by a hard link, or by a
  /// copy if the file system has no hard links.
  /// @param bytes  content of the other file
  static PendingFile linkedTo(const PendingFile& other, const std::string& path,
                              std::string_view bytes);

  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;
  ~PendingFile();

  /// Gives the file its final name, replacing a file that already has it.
  void publish();

  /// Keeps the file when this object is destroyed.
  void keep();

  /// [bytes]
  [[nodiscard]] std::int64_t size() const { return size_; }

  /// The name of the file until it is published.
  [[nodiscard]] const std::string& temporaryName() const { return temporary_path_; }

 private:
  enum class State { kTemporary, kPublished, kKept };

  explicit PendingFile(std::string path);

  std::string path_;
  std::string temporary_path_;
  std::int64_t size_ = 0;
  State state_ = State::kTemporary;
};

/// @throws Error naming the path and why it cannot be read
[[nodiscard]] std::string readWholeFile(const std::string& path);

/// The name of a file until it is complete: hidden, in the same folder, and never longer than a
/// file system allows.
[[nodiscard]] std::string temporaryPath(const std::string& path);

}  // namespace synthetic_dataset::output
