/// The tool `draw_labels`: draws a written dataset's labels on its images, for people to look at,
/// using only the dataset's files.

#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <opencv2/imgcodecs.hpp>

#include "base/json_text.h"
#include "base/printable_text.h"
#include "programs/drawing/label_sheets.h"
#include "programs/drawing/sweep_facts.h"
#include "programs/drawing/video_file.h"
#include "synthetic_dataset/errors.h"
#include "synthetic_dataset/label_text.h"

namespace {

using namespace synthetic_dataset;
namespace fs = std::filesystem;

constexpr const char* kUsage =
    R"(usage: draw_labels DATASET PICTURE [SCENE [WRITER]]
       draw_labels --all DATASET FOLDER [WRITER]
       draw_labels --clouds DATASET FOLDER [SCENE...]
       draw_labels --video FILE.mp4 [--rate HZ] DATASET [WRITER]

Draws the labels that the files of a dataset contain on its images, and lidar clouds from
above and as range images.

  DATASET   the folder of the run's manifest
  PICTURE   the picture to make, .png or .jpg
  SCENE     the scene's index, from 0; without it, the middle scene
  WRITER    the name of the writer to draw; without it, a panel for each
  --all     a picture of each scene, in FOLDER, which is new or empty
  --clouds  a picture of each sweep of these scenes, or of all, in FOLDER, which is new or empty;
            prints a line of JSON for each, with its numbers
  --video   a video of all scenes, made by ffmpeg
  --rate    pictures per second of the video, 10 by default
  --help    prints this

  draw_labels --video run.mp4 datasets/example coco

Exit codes: 0 done, 1 something cannot be read or written, 2 wrong usage.
)";

struct Arguments {
  bool all = false;
  bool clouds = false;
  bool wants_help = false;
  std::optional<std::string> video;
  double rate = 10.0;  // [Hz]
  std::vector<std::string> names;
};

/// Returns nothing for invalid arguments.
std::optional<Arguments> parse(const std::vector<std::string>& given) {
  Arguments arguments;
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool has_next = i + 1 < given.size();
    if (given[i] == "--all") {
      arguments.all = true;
    } else if (given[i] == "--clouds") {
      arguments.clouds = true;
    } else if (given[i] == "--help" || given[i] == "-h") {
      arguments.wants_help = true;
    } else if (given[i] == "--video" && has_next) {
      arguments.video = given[++i];
    } else if (given[i] == "--rate" && has_next) {
      char* end = nullptr;
      arguments.rate = std::strtod(given[++i].c_str(), &end);
      if (*end != '\0') arguments.rate = 0.0;
    } else if (given[i].rfind("--", 0) == 0) {
      return std::nullopt;
    } else {
      arguments.names.push_back(given[i]);
    }
  }
  const std::size_t count = arguments.names.size();
  const bool fits = arguments.video    ? count >= 1 && count <= 2
                    : arguments.all    ? count >= 2 && count <= 3
                    : arguments.clouds ? count >= 2
                                       : count >= 2 && count <= 4;
  const int kinds = static_cast<int>(arguments.all) + static_cast<int>(arguments.clouds) +
                    static_cast<int>(arguments.video.has_value());
  if (arguments.wants_help || (fits && kinds <= 1)) return arguments;
  return std::nullopt;
}

std::int64_t sceneIndex(const std::string& text) {
  std::int64_t index = 0;
  const char* end = text.data() + text.size();
  const auto [stopped, fault] = std::from_chars(text.data(), end, index);
  if (fault != std::errc() || stopped != end) {
    throw Error("SCENE: found '" + text + "'; it should be a scene's index, a whole number");
  }
  return index;
}

void requireNoneOfTheDataset(const output::WrittenDataset& dataset, const std::string& argument,
                             const std::string& file) {
  if (!dataset.holds(file)) return;
  throw Error(argument + ": '" + file + "' is a file of the dataset; choose another name");
}

void writePicture(const std::string& file, const cv::Mat& picture) {
  bool is_written = false;
  try {
    is_written = cv::imwrite(file, picture);
  } catch (const cv::Exception&) {  // an extension that OpenCV does not know
  }
  if (!is_written) {
    throw Error("PICTURE: '" + file +
                "' cannot be written; it should end in .png or .jpg, in an "
                "existing folder");
  }
}

programs::LabelSheets sheetsOf(const std::vector<std::string>& names, std::size_t writer) {
  return {names[0], names.size() > writer ? std::optional(names[writer]) : std::nullopt,
          [](const std::string& message) {
            std::cerr << "draw_labels: " << base::printable(message) << '\n';
          }};
}

void drawOne(const std::vector<std::string>& names) {
  programs::LabelSheets sheets = sheetsOf(names, 3);
  requireNoneOfTheDataset(sheets.dataset(), "PICTURE", names[1]);
  const std::int64_t scene =
      names.size() > 2 ? sceneIndex(names[2]) : sheets.dataset().middleScene();
  const std::optional<cv::Mat> sheet = sheets.sheet(scene);
  if (!sheet) {
    throw Error("'" + names[0] + "': no writer made anything of scene " + std::to_string(scene) +
                " that this tool can draw (of the dataset's writers: " + sheets.writerNames() +
                ")");
  }
  writePicture(names[1], *sheet);
}

/// Draws all scenes. @return how many
/// @param use  receives each sheet with its scene's name
template <class Use>
std::int64_t drawEach(programs::LabelSheets& sheets, const Use& use) {
  const std::vector<std::int64_t> scenes = sheets.dataset().scenes();
  std::int64_t drawn = 0;
  for (const std::int64_t scene : scenes) {
    const std::optional<cv::Mat> sheet = sheets.regularSheet(scene);
    if (!sheet) continue;
    use(sheets.dataset().scene(scene).name, *sheet);
    ++drawn;
  }
  std::cout << drawn << " of " << scenes.size() << " scenes drawn";
  if (drawn < static_cast<std::int64_t>(scenes.size())) {
    std::cout << "; of the others, no writer made a picture";
  }
  std::cout << '\n';
  return drawn;
}

/// Makes the folder FOLDER, which has to be empty and outside of all writers' folders.
void makeFolder(const fs::path& folder, const programs::LabelSheets& sheets) {
  if (sheets.dataset().isInAWriter(folder)) {
    throw Error("FOLDER: '" + folder.string() +
                "' lies in the folder of a writer of the dataset; choose another");
  }
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder)) {
    throw Error("FOLDER: '" + folder.string() + "' cannot be made" +
                (error ? ": " + error.message() : ""));
  }
  if (!fs::is_empty(folder)) {
    throw Error("FOLDER: '" + folder.string() +
                "' is not empty; choose another, or remove what is there");
  }
}

/// A scene's name as a file name: with several cameras, the scene's name contains a folder.
std::string fileNameOf(std::string scene) {
  for (char& c : scene) c = c == '/' ? '_' : c;
  return scene;
}

void drawAll(const std::vector<std::string>& names) {
  programs::LabelSheets sheets = sheetsOf(names, 2);
  const fs::path folder = names[1];
  makeFolder(folder, sheets);
  drawEach(sheets, [&](const std::string& name, const cv::Mat& sheet) {
    writePicture((folder / (fileNameOf(name) + ".png")).string(), sheet);
  });
}

void drawClouds(const std::vector<std::string>& names) {
  programs::LabelSheets sheets = sheetsOf(names, names.size());
  const fs::path folder = names[1];
  makeFolder(folder, sheets);
  std::vector<std::int64_t> scenes;
  for (std::size_t i = 2; i < names.size(); ++i) scenes.push_back(sceneIndex(names[i]));
  if (scenes.empty()) scenes = sheets.dataset().scenes();
  std::int64_t drawn = 0;
  for (const std::int64_t scene : scenes) {
    const std::string name = fileNameOf(sheets.dataset().scene(scene).name);
    for (const programs::LabelSheets::Sweep& sweep : sheets.sweeps(scene)) {
      const std::string file = name + "_" + safeFileName(sweep.cloud.lidar) + ".png";
      writePicture((folder / file).string(), sheets.drawn(sweep));
      Value::Map facts = programs::sweepFacts(sweep.cloud);
      facts["scene"] = scene;
      facts["writer"] = sweep.writer;
      facts["picture"] = file;
      std::cout << base::strictJsonText(Value(facts)) << '\n';
      ++drawn;
    }
  }
  if (drawn == 0) throw Error("'" + names[0] + "': these scenes have no lidar clouds");
}

void drawVideo(const Arguments& arguments) {
  if (!(arguments.rate > 0.0)) throw Error("--rate: it should be a number above 0 [Hz]");
  if (fs::path(*arguments.video).extension() != ".mp4") {
    throw Error("--video: found '" + *arguments.video + "'; it should end in .mp4");
  }
  programs::LabelSheets sheets = sheetsOf(arguments.names, 1);
  requireNoneOfTheDataset(sheets.dataset(), "--video", *arguments.video);
  programs::VideoFile video(*arguments.video, arguments.rate);
  drawEach(sheets, [&](const std::string&, const cv::Mat& sheet) { video.add(sheet); });
  video.finish();
}

}  // namespace

int main(int argc, char** argv) {
  const std::optional<Arguments> arguments = parse({argv + 1, argv + argc});
  if (!arguments) {
    std::cerr << kUsage;
    return 2;
  }
  if (arguments->wants_help) {
    std::cout << kUsage;
    return 0;
  }
  try {
    if (arguments->video) {
      drawVideo(*arguments);
    } else if (arguments->clouds) {
      drawClouds(arguments->names);
    } else if (arguments->all) {
      drawAll(arguments->names);
    } else {
      drawOne(arguments->names);
    }
    return 0;
  } catch (const std::exception& error) {
    std::cerr << "draw_labels: " << base::printable(error.what()) << '\n';
    return 1;
  }
}
