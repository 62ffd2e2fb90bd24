#include "output/verify/dataset_comparison.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <streambuf>
#include <system_error>
#include <utility>

#include "output/files/file_name_rules.h"
#include "output/files/pending_file.h"
#include "output/verify/expected_files.h"
#include "output/verify/scene_comparison.h"
#include "output/writers/writer_outputs.h"
#include "plugins/readback/files.h"

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kMostMadeAgain = 1 << 30;  // for files that a library writes [bytes]

/// Compares everything written to it with a file.
class ComparingBuffer : public std::streambuf {
 public:
  explicit ComparingBuffer(const std::string& file) : file_(file, std::ios::binary) {}

  /// Whether exactly the content of the file was written.
  [[nodiscard]] bool isEqual() {
    return is_equal_ && file_.peek() == std::ifstream::traits_type::eof();
  }

 protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override {
    std::array<char, 8192> part{};
    for (std::streamsize at = 0; at < count && is_equal_;) {
      const auto size = std::min(count - at, static_cast<std::streamsize>(part.size()));
      file_.read(part.data(), size);
      is_equal_ = file_.gcount() == size && std::equal(bytes + at, bytes + at + size, part.data());
      at += size;
    }
    return count;
  }

  int_type overflow(int_type c) override {
    const char byte = traits_type::to_char_type(c);
    if (!traits_type::eq_int_type(c, traits_type::eof())) xsputn(&byte, 1);
    return traits_type::not_eof(c);
  }

 private:
  std::ifstream file_;
  bool is_equal_ = true;
};

bool haveSameBytes(const std::string& one, const std::string& other) {
  std::error_code error;
  if (fs::equivalent(one, other, error)) return true;
  ComparingBuffer buffer(one);
  std::ostream stream(&buffer);
  std::ifstream file(other, std::ios::binary);
  if (file.peek() != std::ifstream::traits_type::eof()) stream << file.rdbuf();
  return buffer.isEqual();
}

class ComparingDatasetOutput : public DatasetOutput {
 public:
  ComparingDatasetOutput(const ReadyWriter& writer, std::set<std::string> found)
      : writer_(writer),
        folder_(absolutePath(writer.parameters().outputFolder())),
        paths_(folder_),
        left_(std::move(found)) {}

  void addFile(const std::string& path, const Content& content) override {
    compare(paths_.claim(path), content);
  }

  void addFileAtParameter(const FileParameter& file, const Content& content) override {
    compare(absolutePath(file.path()), content);
  }

  void addFileByName(const std::string& path,
                     const std::function<void(const std::string& file)>& write) override {
    const std::string file = paths_.claim(path);
    if (!take(file)) return;
    std::error_code error;
    if (fs::file_size(file, error) > kMostMadeAgain) {
      result_.not_compared.push_back(file);
      return;
    }
    const ExpectedFiles place(writer_);
    const std::string right = (place.folder() / fs::path(path).filename()).string();
    write(right);
    if (haveSameBytes(file, right)) return;
    result_.files.push_back(file);
    result_.by_name.insert(file);
  }

  void addLink(const std::string& path, const std::string& scene_file) override {
    const std::string file = paths_.claim(path);
    if (!take(file) || haveSameBytes(file, paths_.absolute(scene_file))) return;
    result_.problems.push_back("'" + path + "' is not the same as '" + scene_file + "'");
  }

  [[nodiscard]] std::string readFile(const std::string& scene_file) const override {
    return readWholeFile(paths_.absolute(scene_file));
  }

  [[nodiscard]] DifferingFiles result() {
    constexpr std::size_t kMost = 10;  // of the same kind
    for (const std::string& path : left_) {
      if (result_.problems.size() > kMost) break;
      result_.problems.push_back("found the file '" + pathBelow(folder_, path) +
                                 "', which the writer does not make");
    }
    return std::move(result_);
  }

 private:
  bool take(const std::string& file) {
    if (left_.erase(file) > 0) return true;
    result_.problems.push_back("there is no file '" + pathBelow(folder_, file) +
                               "'; it should be there");
    return false;
  }

  void compare(const std::string& file, const Content& content) {
    if (!take(file)) return;
    ComparingBuffer buffer(file);
    std::ostream stream(&buffer);
    content(stream);
    if (!buffer.isEqual()) result_.files.push_back(file);
  }

  const ReadyWriter& writer_;
  std::string folder_;
  ClaimedPaths paths_;
  std::set<std::string> left_;  ///< files found that the writer has not made yet
  DifferingFiles result_;
};

}  // namespace

DifferingFiles differingDatasetFiles(const ReadyWriter& writer, const SceneRecords& records,
                                     std::set<std::string> found) {
  ComparingDatasetOutput output(writer, std::move(found));
  writer.finalize(records, output);
  return output.result();
}

void compareDatasetFile(const std::string& found, const std::string& right, const std::string& name,
                        formats::Differences& differences) {
  constexpr std::uintmax_t kMost = 256 << 20;  // held in memory [bytes]
  if (fs::file_size(found) + fs::file_size(right) <= kMost) {
    formats::compareContents(formats::readText(found), formats::readText(right), name, differences);
    return;
  }
  std::ifstream found_lines(found);
  std::ifstream right_lines(right);
  std::string one;
  std::string other;
  for (std::int64_t line = 1; std::getline(right_lines, other); ++line) {
    if (!std::getline(found_lines, one)) {
      differences.add(name + ": it ends before line " + std::to_string(line));
      return;
    }
    formats::compareRecords(one, other, name + ", line " + std::to_string(line), differences);
  }
  if (std::getline(found_lines, one)) differences.add(name + ": it has too many lines");
}

}  // namespace synthetic_dataset::output
