#include "programs/setup_assistant/service/result_service.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <system_error>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "base/input_file.h"
#include "output/manifest/manifest_schema.h"
#include "output/verify/dataset_verifier.h"
#include "output/written_dataset.h"
#include "plugins/readback/format.h"
#include "programs/drawing/label_sheets.h"
#include "programs/setup_assistant/live/picture_cache.h"
#include "programs/setup_assistant/run/child_program.h"
#include "programs/setup_assistant/service/label_filter.h"
#include "programs/setup_assistant/service/request_body.h"
#include "programs/setup_assistant/service/run_service.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::programs {
namespace {

constexpr std::int64_t kScenesOfAPage = 24;
constexpr const char* kPictureAddress = "api/result/image/";

Value countsValue(const std::map<std::string, std::int64_t>& counts) {
  Value::Map map;
  for (const auto& [name, count] : counts) map[name] = count;
  return map;
}

Value chosenValue(const ChosenScenes& chosen) {
  return Value::Map{{"scene_count", static_cast<std::int64_t>(chosen.scenes.size())},
                    {"splits", countsValue(chosen.splits)},
                    {"classes", countsValue(chosen.classes)},
                    {"sizes", countsValue(chosen.sizes)},
                    {"occlusions", countsValue(chosen.occlusions)}};
}

Value sceneValue(const output::WrittenDataset& dataset, std::int64_t index) {
  const output::WrittenSceneRow row = dataset.scene(index);
  const std::string picture =
      kPictureAddress + std::to_string(index) + ".jpg?stamp=" + std::to_string(row.stamp.count());
  return Value::Map{{"index", Value(index)},       {"name", Value(row.name)},
                    {"camera", Value(row.camera)}, {"split", Value(row.split)},
                    {"image", Value(picture)},     {"overlay", Value(picture + "&labels=1")}};
}

/// The writer whose labels are shown: if possible, one whose files can be read before the dataset
/// is complete.
std::optional<std::string> writerToShow(const output::WrittenDataset& dataset) {
  std::optional<std::string> second;
  for (const output::WrittenWriter& writer : dataset.writers()) {
    const formats::Format* format = formats::formatOf(writer.type);
    if (format == nullptr || !dataset.hasPictures(writer)) continue;
    if (!format->needs_dataset_files) return writer.name;
    if (!second) second = writer.name;
  }
  return second;
}

/// The time at which a dataset's report was made, for its address; null if there is no report.
Value reportTime(const std::string& folder) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(output::reportFile(folder), error);
  if (error) return {};
  return static_cast<std::int64_t>(time.time_since_epoch().count());
}

/// Collects what verify finds.
struct FoundProblems : output::VerificationListener {
  void problem(const std::string& line) override { add(problems, line); }
  void remark(const std::string& line) override { add(remarks, line); }
  void progress(std::int64_t /*scene_count*/, std::int64_t /*of*/) override {}

  static void add(Value::List& list, const std::string& line) {
    constexpr std::size_t kMost = 200;
    if (list.size() < kMost) list.emplace_back(line);
  }

  Value::List problems;
  Value::List remarks;
};

cv::Mat noWiderThan(const cv::Mat& picture, std::int64_t width) {
  if (width <= 0 || picture.cols <= width) return picture;
  const auto columns = static_cast<int>(width);
  const int rows = std::max(1, picture.rows * columns / picture.cols);
  cv::Mat small;
  cv::resize(picture, small, {columns, rows}, 0.0, 0.0, cv::INTER_AREA);
  return small;
}

}  // namespace

std::string ResultService::folder() {
  const EffectiveSettings effective = document_.effective();
  if (!effective.settings) throw ErrorList(effective.errors);
  std::string folder = outputFolderOf(*effective.settings);
  if (!folder.empty() && std::filesystem::exists(output::manifestFile(folder))) return folder;
  throw HttpError(404, "there is no dataset in output_folder ('" + folder + "') yet");
}

Value ResultService::page(const HttpRequest& request) {
  const std::string of = folder();
  const output::WrittenDataset dataset(of);
  const ChosenScenes chosen = chosenScenes(dataset, LabelFilter(request));
  const std::vector<std::int64_t>& scenes = chosen.scenes;
  const auto count = static_cast<std::int64_t>(scenes.size());
  const std::int64_t pages = (count + kScenesOfAPage - 1) / kScenesOfAPage;
  const std::int64_t page =
      std::min(pages, std::max<std::int64_t>(0, wholeParameter(request, "page", 0)));
  const std::int64_t begin = std::min(count, page * kScenesOfAPage);
  Value::List shown;
  for (std::int64_t i = begin; i < std::min(count, begin + kScenesOfAPage); ++i) {
    shown.push_back(sceneValue(dataset, scenes[static_cast<std::size_t>(i)]));
  }
  Value::List writers;
  for (const output::WrittenWriter& each : dataset.writers()) writers.emplace_back(each.name);
  const output::WrittenCounts counts = dataset.counts();
  return Value::Map{{"folder", Value(of)},
                    {"page", Value(page)},
                    {"pages", Value(pages)},
                    {"scene_count", Value(counts.scenes)},
                    {"bytes", Value(counts.bytes)},
                    {"classes", countsValue(counts.labels)},
                    {"splits", countsValue(counts.splits)},
                    {"chosen", chosenValue(chosen)},
                    {"report", Value(reportTime(of))},
                    {"writers", Value(writers)},
                    {"scenes", Value(shown)}};
}

HttpResponse ResultService::picture(const std::string& name, const HttpRequest& request) {
  HttpRequest number;
  number.query["scene"] = name.substr(0, name.find('.'));
  const std::int64_t scene = wholeParameter(number, "scene", 0);
  const std::string of = folder();
  const bool has_labels = request.parameter("labels").value_or("") == "1";
  const auto ignore = [](const std::string&) {};
  const std::lock_guard<std::mutex> lock(drawing_);
  std::optional<std::string> writer = request.parameter("writer");
  if (has_labels && !writer) writer = writerToShow(output::WrittenDataset(of));
  LabelSheets sheets(of, has_labels ? writer : std::nullopt, ignore);
  const auto picture = has_labels ? sheets.labelledImage(scene) : sheets.image(scene);
  if (!picture) throw HttpError(404, "no writer made a picture of scene " + std::to_string(scene));
  HttpResponse response;
  response.type = "image/jpeg";
  response.body =
      encodedPicture(noWiderThan(*picture, wholeParameter(request, "width", 0)), ".jpg");
  return response;
}

Value ResultService::verify() {
  FoundProblems found;
  const output::VerificationCounts counts =
      output::verifyDataset(folder(), output::VerificationDepth::kLabels, found);
  return Value::Map{
      {"ok", Value(found.problems.empty())},
      {"problems", Value(found.problems)},
      {"remarks", Value(found.remarks)},
      {"summary", Value(std::to_string(counts.scenes) + " scenes, " + std::to_string(counts.files) +
                        " files, " + std::to_string(counts.labels) + " labels checked, " +
                        std::to_string(found.problems.size()) + " problems")}};
}

Value ResultService::makeReport() {
  const std::string of = folder();
  if (!isBelow(std::filesystem::weakly_canonical(of), allowed_.home())) {
    throw HttpError(403, "output_folder: found '" + of + "', but this page writes only below '" +
                             allowed_.home().string() + "'; `rosrun synthetic_dataset report " +
                             of + "` makes the report by hand");
  }
  const std::lock_guard<std::mutex> lock(reporting_);
  ChildProgram program({programBesideThis("report"), of});
  std::string last_line;
  program.read([&](const std::string& line) { last_line = line; });
  if (program.wait() != 0) throw Error("the report cannot be made: " + last_line);
  return Value::Map{{"report", reportTime(of)}};
}

HttpResponse ResultService::report() {
  HttpResponse response;
  response.type = "text/html; charset=utf-8";
  try {
    response.body = base::readInput(output::reportFile(folder()));
  } catch (const Error&) {
    throw HttpError(404, "there is no report of this dataset yet");
  }
  // The report needs no other files, and what it shows comes from users' files.
  response.headers["Content-Security-Policy"] =
      "sandbox; default-src 'none'; img-src data:; style-src 'unsafe-inline'; frame-ancestors "
      "'none'";
  return response;
}

}  // namespace synthetic_dataset::programs
