#include "output/verify/expected_files.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <ostream>
#include <string_view>
#include <system_error>

#include "output/files/file_name_rules.h"
#include "output/files/pending_file.h"
#include "output/scene_contents.h"
#include "output/writers/writer_outputs.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

namespace fs = std::filesystem;

fs::path newFolder() {
  std::string name = (fs::temp_directory_path() / "synthetic_dataset_XXXXXX").string();
  if (mkdtemp(name.data()) == nullptr) {
    throw Error("no folder can be made in '" + fs::temp_directory_path().string() + "'");
  }
  return name;
}

void writeFile(const fs::path& file, const DatasetOutput::Content& content) {
  fs::create_directories(file.parent_path());
  std::ofstream stream(file, std::ios::binary);
  content(stream);
  if (!stream.flush()) throw Error("'" + file.string() + "' cannot be written");
}

/// Writes the files of a dataset as a whole into a folder.
class WritingDatasetOutput : public DatasetOutput {
 public:
  WritingDatasetOutput(const ReadyWriter& writer, const ExpectedFiles& place)
      : paths_(absolutePath(writer.parameters().outputFolder())), place_(place) {}

  void addFile(const std::string& path, const Content& content) override {
    writeFile(place_.placeOf(paths_.claim(path)), content);
  }

  void addFileAtParameter(const FileParameter& file, const Content& content) override {
    writeFile(place_.placeOf(absolutePath(file.path())), content);
  }

  void addFileByName(const std::string& path,
                     const std::function<void(const std::string& file)>& write) override {
    const fs::path file = place_.placeOf(paths_.claim(path));
    fs::create_directories(file.parent_path());
    write(file.string());
  }

  void addLink(const std::string& path, const std::string& scene_file) override {
    const fs::path file = place_.placeOf(paths_.claim(path));
    fs::create_directories(file.parent_path());
    fs::create_symlink(sourceOf(scene_file), file);
  }

  [[nodiscard]] std::string readFile(const std::string& scene_file) const override {
    return readWholeFile(sourceOf(scene_file));
  }

 private:
  /// The right file if there is one, otherwise the writer's own.
  [[nodiscard]] std::string sourceOf(const std::string& scene_file) const {
    const std::string path = paths_.absolute(scene_file);
    const fs::path right = place_.placeOf(path);
    return fs::exists(right) ? right.string() : path;
  }

  ClaimedPaths paths_;
  const ExpectedFiles& place_;
};

}  // namespace

ExpectedFiles::ExpectedFiles(const ReadyWriter& writer) : writer_(writer), folder_(newFolder()) {
  fs::create_directory(folder());
}

ExpectedFiles::~ExpectedFiles() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

fs::path ExpectedFiles::placeOf(const std::string& path) const {
  const std::string& of_writer = absolutePath(writer_.parameters().outputFolder());
  if (liesWithin(path, of_writer)) return folder() / path.substr(of_writer.size());
  return folder_ / "elsewhere" / fs::path(path).relative_path();
}

void ExpectedFiles::addScene(const SceneFiles& scene) const {
  for (const SceneContent& content : encodeScene(scene.files, {})) {
    const std::string_view bytes = content.bytes();
    for (const std::size_t file : content.files) {
      writeFile(placeOf(scene.files[file].path), [&](std::ostream& stream) {
        stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      });
    }
  }
}

void ExpectedFiles::addRight(const std::string& path) const {
  const fs::path place = placeOf(path);
  fs::create_directories(place.parent_path());
  std::error_code is_there;
  fs::create_symlink(path, place, is_there);
}

void ExpectedFiles::addDataset(const SceneRecords& records) const {
  WritingDatasetOutput output(writer_, *this);
  writer_.finalize(records, output);
}

std::vector<fs::path> ExpectedFiles::filesOf(const SceneFiles& scene) const {
  std::vector<fs::path> files;
  for (const OutputFile& each : scene.files) files.push_back(placeOf(each.path));
  std::sort(files.begin(), files.end());
  return files;
}

void RecordsOfScene::forEach(
    const std::string& channel,
    const std::function<void(std::int64_t scene_index, const std::string& record)>& visit) const {
  for (const SceneFiles::Record& each : records_) {
    if (each.channel == channel) visit(scene_, each.text);
  }
}

}  // namespace synthetic_dataset::output
