#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "synthetic_dataset/output.h"

namespace synthetic_dataset::output {

/// A file that appears whole or not at all.
///
/// Its content is written under a temporary name in the same folder; publish() gives it its name.
/// Unless it is kept, it is removed at the end of this object's life, published or not.
class PendingFile {
 public:
  /// All of these make the file's folder, and replace a temporary file that a killed run left.
  /// @throws Error naming the path and why it cannot be written
  static PendingFile withBytes(const std::string& path, std::string_view bytes);

  /// @throws whatever `content` throws, too
  static PendingFile withContent(const std::string& path, const DatasetOutput::Content& content);

  /// What `write` makes of the file whose name it is given.
  /// @throws whatever `write` throws, too
  static PendingFile writtenBy(const std::string& path,
                               const std::function<void(const std::string& file)>& write);

  /// The same content as a file that is there: by a hard link, or by a copy.
  static PendingFile linkedToFile(const std::string& original, const std::string& path);

  /// The same content as another file that is not published yet: by a hard link, or by a copy where
  /// the file system has none.
  /// @param bytes  the other file's content
  static PendingFile linkedTo(const PendingFile& other, const std::string& path,
                              std::string_view bytes);

  PendingFile(PendingFile&& other) noexcept;
  PendingFile& operator=(PendingFile&&) = delete;
  ~PendingFile();

  /// Gives the file its name, in the place of a file that has it already.
  void publish();

  /// The file is to stay.
  void keep();

  /// [bytes]
  [[nodiscard]] std::int64_t size() const { return size_; }

  /// The name that it has until it is published.
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

/// The name that a file has until it is complete: hidden, in the same folder, and never longer than
/// a file system allows.
[[nodiscard]] std::string temporaryPath(const std::string& path);

}  // namespace synthetic_dataset::output
