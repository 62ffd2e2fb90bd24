#include "programs/gallery/model_gallery.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <set>
#include <sstream>

#include <opencv2/imgproc.hpp>

#include "synthetic_dataset/errors.h"
#include "world/world_loader.h"

namespace synthetic_dataset::programs {
namespace {

namespace fs = std::filesystem;

constexpr int kCaptionHeight = 22;  // [px]
constexpr double kFontScale = 0.4;
constexpr int kFont = cv::FONT_HERSHEY_SIMPLEX;
const cv::Scalar kPaper(250, 250, 250);
const cv::Scalar kInk(40, 40, 40);
const cv::Scalar kErrorInk(30, 30, 190);

int widthOf(const std::string& text) {
  int baseline = 0;
  return cv::getTextSize(text, kFont, kFontScale, 1, &baseline).width;
}

void write(cv::Mat& sheet, const std::string& text, const cv::Point& place, const cv::Scalar& ink) {
  cv::putText(sheet, text, place, kFont, kFontScale, ink, 1, cv::LINE_AA);
}

/// The text, or only its end if it is too wide: names differ there.
std::string fitted(const std::string& text, int width) {
  if (widthOf(text) <= width) return text;
  std::size_t cut = 1;
  while (cut < text.size() && widthOf("..." + text.substr(cut)) > width) ++cut;
  return "..." + text.substr(cut);
}

/// Lines of at most this width, broken anywhere: paths have few spaces.
std::vector<std::string> wrapped(const std::string& text, int width) {
  std::vector<std::string> lines(1);
  for (const char letter : text) {
    if (letter == '\n' || widthOf(lines.back() + letter) > width) lines.emplace_back();
    if (letter != '\n') lines.back() += letter;
  }
  return lines;
}

/// What is missing, in few words: the file's name if the note gives one.
std::string shortened(const std::string& note) {
  const std::size_t end = note.find("': no such file");
  const std::size_t begin = end == std::string::npos ? end : note.rfind('\'', end - 1);
  if (begin == std::string::npos) return note;
  const std::string name = note.substr(begin + 1, end - begin - 1);
  return "lacks " + name.substr(name.find_last_of('/') + 1);
}

std::string remarkOf(const GalleryEntry& entry) {
  if (!entry.error.empty()) return entry.error;
  std::string text = entry.picture.empty() ? "nothing to see\n" : "";
  for (const std::string& note : std::set<std::string>(entry.notes.begin(), entry.notes.end())) {
    if (note.find("(left out)") != std::string::npos) text += shortened(note) + "\n";
  }
  return text;
}

/// Whether a note is about the model or what is in it.
bool isAbout(const std::string& note, const std::string& model) {
  return note.find("model '" + model + "'") != std::string::npos;
}

/// The entry for one model of a world, or for the whole world.
GalleryEntry entryOf(const world::Description& description, const std::string& name,
                     const cv::Size& size) {
  GalleryEntry entry;
  entry.name = name;
  entry.counts = run::countModels(description);
  entry.picture = run::portray(description, size);
  return entry;
}

void drawCell(cv::Mat& sheet, const cv::Rect& cell, const GalleryEntry& entry) {
  constexpr int kMargin = 6;
  constexpr int kLine = 16;
  const cv::Rect place(cell.x, cell.y, cell.width, cell.height - kCaptionHeight);
  if (entry.picture.size() == place.size()) entry.picture.copyTo(sheet(place));
  int y = cell.y + kLine;
  for (const std::string& line : wrapped(remarkOf(entry), cell.width - 2 * kMargin)) {
    if (y > place.br().y - kMargin) break;
    write(sheet, line, {cell.x + kMargin, y},
          entry.picture.empty() && entry.error.empty() ? kInk : kErrorInk);
    y += kLine;
  }
  write(sheet, fitted(entry.name, cell.width - 2 * kMargin),
        {cell.x + kMargin, cell.br().y - kCaptionHeight / 3}, kInk);
}

}  // namespace

std::vector<std::string> modelFolders(const fs::path& folder, const std::vector<fs::path>& models) {
  std::vector<std::string> folders = {folder.string()};
  const auto add = [&](const fs::path& path) {
    const std::string text = path.string();
    if (std::find(folders.begin(), folders.end(), text) == folders.end()) folders.push_back(text);
  };
  for (const fs::path& model : models) {
    // A URDF file lies in its package, or in the package's folder urdf/.
    for (fs::path above = model.parent_path(); above.string().size() > folder.string().size();
         above = above.parent_path()) {
      add(above);
    }
  }
  return folders;
}

GalleryEntry portrayModel(const fs::path& model, const std::string& name,
                          const world::ResourceFinder& finder, const cv::Size& size) {
  GalleryEntry entry;
  entry.name = name;
  try {
    world::LoadOptions options;
    options.on_missing_asset = world::OnMissingAsset::kWarn;
    const world::Description description = world::loadWorld(model.string(), finder, options);
    entry.counts = run::countModels(description);
    entry.notes = description.notes;
    entry.picture = run::portray(description, size);
  } catch (const std::exception& error) {
    entry.error = error.what();
  }
  return entry;
}

std::vector<GalleryEntry> portrayWorld(const fs::path& file, const world::ResourceFinder& finder,
                                       const cv::Size& size) {
  world::LoadOptions options;
  options.on_missing_asset = world::OnMissingAsset::kWarn;
  world::Description whole;
  try {
    whole = world::loadWorld(file.string(), finder, options);
  } catch (const std::exception& error) {
    GalleryEntry entry;
    entry.name = file.filename().string();
    entry.error = error.what();
    return {entry};
  }
  std::vector<GalleryEntry> entries = {entryOf(whole, file.filename().string(), size)};
  std::set<std::string> of_models;
  for (const world::Model& model : whole.models) {
    world::Description alone;
    alone.models.push_back(model);
    entries.push_back(entryOf(alone, model.name, size));
    for (const std::string& note : whole.notes) {
      if (!isAbout(note, model.name)) continue;
      entries.back().notes.push_back(note);
      of_models.insert(note);
    }
  }
  for (const std::string& note : whole.notes) {
    if (of_models.count(note) == 0) entries.front().notes.push_back(note);
  }
  return entries;
}

cv::Mat contactSheet(const std::vector<GalleryEntry>& entries, const cv::Size& cell) {
  const auto count = static_cast<int>(std::max<std::size_t>(entries.size(), 1));
  const int columns = std::min(count, static_cast<int>(std::ceil(std::sqrt(1.2 * count))));
  const int rows = (count + columns - 1) / columns;
  const int height = cell.height + kCaptionHeight;
  cv::Mat sheet(rows * height, columns * cell.width, CV_8UC3, kPaper);
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const int index = static_cast<int>(i);
    const cv::Rect place(index % columns * cell.width, index / columns * height, cell.width,
                         height);
    drawCell(sheet, place, entries[i]);
  }
  return sheet;
}

std::string galleryTable(const std::vector<GalleryEntry>& entries) {
  std::size_t longest = 5;
  for (const GalleryEntry& entry : entries) longest = std::max(longest, entry.name.size());
  const auto width = static_cast<int>(longest);
  std::ostringstream table;
  table << std::left << std::setw(width) << "model" << std::right;
  for (const char* column : {"links", "visuals", "surfaces", "triangles", "textures", "remarks"}) {
    table << std::setw(11) << column;
  }
  table << '\n';
  for (const GalleryEntry& entry : entries) {
    table << std::left << std::setw(width) << entry.name << std::right;
    if (!entry.error.empty()) {
      std::string line = entry.error;
      std::replace(line.begin(), line.end(), '\n', ' ');
      table << "  cannot be loaded: " << line << '\n';
      continue;
    }
    const run::ModelCounts& counts = entry.counts;
    for (const std::size_t number : {counts.links, counts.visuals, counts.surfaces,
                                     counts.triangles, counts.textures, entry.notes.size()}) {
      table << std::setw(11) << number;
    }
    table << '\n';
  }
  for (const GalleryEntry& entry : entries) {
    const std::set<std::string> notes(entry.notes.begin(), entry.notes.end());
    for (const std::string& note : notes) table << entry.name << ": " << note << '\n';
  }
  return table.str();
}

}  // namespace synthetic_dataset::programs
