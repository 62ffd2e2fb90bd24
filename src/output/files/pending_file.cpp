#include "output/files/pending_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <streambuf>
#include <system_error>
#include <utility>

#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/fingerprint.h"

namespace synthetic_dataset::output {
namespace {

constexpr std::size_t kLongestPendingName = 255;  // NAME_MAX [bytes]

[[noreturn]] void failToWrite(const std::string& path, const std::string& reason) {
  throw Error("cannot write '" + path + "': " + reason);
}

[[noreturn]] void failToWrite(const std::string& path, int error_number) {
  failToWrite(path, std::generic_category().message(error_number));
}

void makeParentFolder(const std::string& path) {
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    failToWrite(path, "cannot make the folder '" + folder.string() + "': " + error.message());
  }
}

/// A new file, open for writing; remembers the first error.
class OpenFile {
 public:
  explicit OpenFile(const std::string& path)
      : descriptor_(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666)),
        error_(descriptor_ < 0 ? errno : 0) {}
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;
  ~OpenFile() { close(); }

  void write(const char* bytes, std::size_t count) {
    while (error_ == 0 && count > 0) {
      const ssize_t written = ::write(descriptor_, bytes, count);
      if (written < 0) {
        if (errno != EINTR) error_ = errno;
        continue;
      }
      bytes += written;
      count -= static_cast<std::size_t>(written);
    }
  }

  /// Reports errors too: some file systems notice a full disk only on closing.
  void close() {
    if (descriptor_ < 0) return;
    if (::close(descriptor_) != 0 && error_ == 0 && errno != EINTR) error_ = errno;
    descriptor_ = -1;
  }

  /// Whether this path refers to this very file.
  [[nodiscard]] bool isAt(const std::string& path) const {
    struct stat own {};
    struct stat there {};
    return ::fstat(descriptor_, &own) == 0 && ::lstat(path.c_str(), &there) == 0 &&
           own.st_dev == there.st_dev && own.st_ino == there.st_ino;
  }

  [[nodiscard]] std::int64_t size() const {
    struct stat own {};
    return ::fstat(descriptor_, &own) == 0 ? own.st_size : -1;
  }

  /// `errno` of the first failure, 0 if there was none.
  [[nodiscard]] int error() const { return error_; }

 private:
  int descriptor_;
  int error_;
};

/// Lets a std::ostream write to an OpenFile, whose errors can be reported.
class OpenFileBuffer : public std::streambuf {
 public:
  explicit OpenFileBuffer(OpenFile& file) : file_(file) {
    setp(buffer_.data(), buffer_.data() + buffer_.size());
  }

  [[nodiscard]] std::int64_t size() const { return size_; }

 protected:
  int_type overflow(int_type character) override {
    if (sync() != 0) return traits_type::eof();
    if (!traits_type::eq_int_type(character, traits_type::eof())) {
      sputc(traits_type::to_char_type(character));
    }
    return traits_type::not_eof(character);
  }

  int sync() override {
    const std::ptrdiff_t count = pptr() - pbase();
    file_.write(pbase(), static_cast<std::size_t>(count));
    size_ += count;
    setp(buffer_.data(), buffer_.data() + buffer_.size());
    return file_.error() == 0 ? 0 : -1;
  }

 private:
  OpenFile& file_;
  std::int64_t size_ = 0;
  std::array<char, 1 << 16> buffer_;
};

}  // namespace

std::string readWholeFile(const std::string& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) throw Error("cannot read '" + path + "': " + error.message());
  std::string bytes(static_cast<std::size_t>(size), '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  if (!stream) throw Error("cannot read '" + path + "'");
  return bytes;
}

std::string temporaryPath(const std::string& path) {
  const std::size_t name_begin = path.rfind('/') + 1;  // 0 if there is none
  const std::string name = path.substr(name_begin);
  std::string end = ".tmp";
  if (1 + name.size() + end.size() > kLongestPendingName) {
    end = "." + Fingerprint(name).text() + end;
  }
  return path.substr(0, name_begin) + "." + name.substr(0, kLongestPendingName - 1 - end.size()) +
         end;
}

PendingFile::PendingFile(std::string path)
    : path_(std::move(path)), temporary_path_(temporaryPath(path_)) {
  makeParentFolder(path_);
  ::unlink(temporary_path_.c_str());  // left by a killed run; it may be a link to a finished file
}

PendingFile PendingFile::withBytes(const std::string& path, std::string_view bytes) {
  return withContent(path, [bytes](std::ostream& stream) {
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

PendingFile PendingFile::withContent(const std::string& path,
                                     const DatasetOutput::Content& content) {
  PendingFile pending(path);
  OpenFile file(pending.temporary_path_);
  if (file.error() != 0) failToWrite(path, file.error());
  OpenFileBuffer buffer(file);
  std::ostream stream(&buffer);
  content(stream);
  stream.flush();
  file.close();
  if (file.error() != 0) failToWrite(path, file.error());
  if (!stream) failToWrite(path, "its content could not be formatted");
  pending.size_ = buffer.size();
  return pending;
}

PendingFile PendingFile::writtenBy(const std::string& path,
                                   const std::function<void(const std::string& file)>& write) {
  PendingFile pending(path);
  // The name is ours now, with no other file or link under it; whoever opens it must get this file.
  OpenFile own(pending.temporary_path_);
  const char unwritten = '\0';  // gone once `write` opens the file for writing
  own.write(&unwritten, 1);
  if (own.error() != 0) failToWrite(path, own.error());
  write(pending.temporary_path_);
  if (!own.isAt(pending.temporary_path_)) {
    failToWrite(path, "somebody else has removed or replaced it while it was written");
  }
  pending.size_ = own.size();
  if (pending.size_ == 1 && readWholeFile(pending.temporary_path_).front() == unwritten) {
    failToWrite(path, ENOENT);
  }
  return pending;
}

PendingFile PendingFile::linkedToFile(const std::string& original, const std::string& path) {
  {
    PendingFile pending(path);
    if (::link(original.c_str(), pending.temporary_path_.c_str()) == 0) {
      std::error_code error;
      pending.size_ = static_cast<std::int64_t>(std::filesystem::file_size(original, error));
      return pending;
    }
  }
  return withBytes(path, readWholeFile(original));
}

PendingFile PendingFile::linkedTo(const PendingFile& other, const std::string& path,
                                  std::string_view bytes) {
  {
    PendingFile pending(path);
    if (::link(other.temporary_path_.c_str(), pending.temporary_path_.c_str()) == 0) {
      pending.size_ = other.size_;
      return pending;
    }
  }
  return withBytes(path, bytes);
}

PendingFile::PendingFile(PendingFile&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_path_(std::move(other.temporary_path_)),
      size_(other.size_),
      state_(std::exchange(other.state_, State::kKept)) {}

PendingFile::~PendingFile() {
  if (state_ == State::kTemporary) ::unlink(temporary_path_.c_str());
  if (state_ == State::kPublished) ::unlink(path_.c_str());
}

void PendingFile::publish() {
  if (::rename(temporary_path_.c_str(), path_.c_str()) != 0) failToWrite(path_, errno);
  state_ = State::kPublished;
}

void PendingFile::keep() { state_ = State::kKept; }

}  // namespace synthetic_dataset::output
