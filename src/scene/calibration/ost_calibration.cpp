#include <map>
#include <sstream>
#include <utility>

#include "base/diagnostics.h"
#include "base/yaml_scalar.h"
#include "scene/calibration/calibration_format.h"
#include "scene/calibration/calibration_names.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::scene {
namespace {

/// A line without its comment (`#` or `;`) and surrounding spaces.
std::string contentOf(const std::string& line) {
  const std::string text = line.substr(0, line.find_first_of("#;"));
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return "";
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

/// `[image]` or `[externals]` on the first line with content.
bool recognisesOst(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const std::string content = contentOf(line);
    if (!content.empty()) return content == "[image]" || content == "[externals]";
  }
  return false;
}

/// The numbers of a line; nothing if it contains anything else.
std::optional<Value::List> numbersOf(const std::string& line) {
  Value::List numbers;
  std::istringstream words(line);
  for (std::string word; words >> word;) {
    const auto number = base::decimalNumber(word);
    if (!number) return std::nullopt;
    numbers.emplace_back(*number);
  }
  return numbers;
}

/// The numbers that follow each name, up to the next name, over any number of lines.
using Section = std::map<std::string, Value::List>;

/// Reads the format like camera_calibration_parsers (parse_ini.cpp): sections, in which names stand
/// above their numbers.
class OstReader {
 public:
  void readLine(const std::string& line, int number) {
    const std::string content = contentOf(line);
    if (content.empty()) return;
    if (content.front() == '[' && content.back() == ']') {
      begin(content.substr(1, content.size() - 2));
      return;
    }
    const auto numbers = numbersOf(content);
    if (!numbers) {
      name_ = content;
      return;
    }
    if (name_.empty()) {
      throw Error("line " + std::to_string(number) + ": found numbers without a name above them");
    }
    Value::List& all = (*now_)[name_];
    all.insert(all.end(), numbers->begin(), numbers->end());
  }

  [[nodiscard]] std::vector<ListedCamera> cameras() const {
    std::vector<ListedCamera> result;
    for (const auto& [name, section] : cameras_) {
      ListedCamera camera{cameras_.size() == 1 ? "" : name, {}};
      add(image_, "width", "image_width", camera.info);
      add(image_, "height", "image_height", camera.info);
      add(section, "camera matrix", "camera_matrix", camera.info);
      add(section, "distortion", "distortion_coefficients", camera.info);
      add(section, "rectification", "rectification_matrix", camera.info);
      add(section, "projection", "projection_matrix", camera.info);
      result.push_back(std::move(camera));
    }
    if (result.empty()) throw Error("found no camera; a section should have a camera matrix");
    return result;
  }

 private:
  /// A stereo pair's file contains the sections of one camera after those of the other.
  void begin(const std::string& section) {
    name_.clear();
    const bool is_of_all = section == "image" || section == "externals";
    if (is_of_all) {
      now_ = section == "image" ? &image_ : &other_;
      now_->clear();
    } else {
      cameras_.push_back({section, {}});
      now_ = &cameras_.back().second;
    }
  }

  static void add(const Section& section, const std::string& name, const std::string& usual,
                  Value::Map& info) {
    const auto found = section.find(name);
    if (found == section.end()) return;
    const bool is_side = usual.rfind("image_", 0) == 0;
    info[usual] = is_side && found->second.size() == 1
                      ? pixelCount(*found->second.front().as<double>())
                      : Value(found->second);
  }

  std::string name_;  ///< of the numbers that come next
  Section image_;
  Section other_;
  Section* now_ = &other_;
  std::vector<std::pair<std::string, Section>> cameras_;
};

std::vector<ListedCamera> readOstCalibration(const std::string& text, const std::string& file) {
  return base::namingPlace(file, [&] {
    OstReader reader;
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) reader.readLine(line, ++number);
    return reader.cameras();
  });
}

}  // namespace

const CalibrationFormat kOstFormat = {recognisesOst, readOstCalibration};

}  // namespace synthetic_dataset::scene
