#include <algorithm>
#include <map>
#include <variant>

#include <opencv2/core.hpp>
#include <opencv2/core/persistence.hpp>

#include "base/json_text.h"
#include "base/nesting.h"
#include "base/sandbox/sandboxed_process.h"
#include "scene/calibration/calibration_format.h"
#include "scene/calibration/calibration_names.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::scene {
namespace {

/// Names used in OpenCV's samples and in other files written with FileStorage.
const std::map<std::string, std::string>& openCvNames() {
  static const std::map<std::string, std::string> names = [] {
    std::map<std::string, std::string> all = rosNames();
    all.erase("r");  // in a stereo pair, one camera's pose relative to the other
    all.erase("p");
    for (const char* name :
         {"m", "cameramat", "intrinsicmatrix", "intrinsic", "intrinsics", "mtx"}) {
      all[name] = "camera_matrix";
    }
    for (const char* name : {"distcoeffs", "distcoeff", "distortioncoeffs", "distortion", "dist"}) {
      all[name] = "distortion_coefficients";
    }
    return all;
  }();
  return names;
}

Value valueOf(const cv::FileNode& node, int depth = 0) {
  if (depth > base::kDeepestNesting) throw Error(base::kNestedTooDeep);
  if (node.isInt()) return Value(static_cast<int>(node));
  if (node.isReal()) return Value(static_cast<double>(node));
  if (node.isString()) return Value(static_cast<std::string>(node));
  if (node.isSeq()) {
    Value::List list;
    for (const cv::FileNode& entry : node) list.push_back(valueOf(entry, depth + 1));
    return list;
  }
  Value::Map map;
  if (node.isMap()) {
    for (const cv::FileNode& entry : node) map[entry.name()] = valueOf(entry, depth + 1);
  }
  return map;
}

/// A single number, or the only entry of a matrix.
std::optional<double> numberOf(const Value& value) {
  const Value flat = flatMatrix(value);
  const auto* list = flat.as<Value::List>();
  const Value& number = list != nullptr && list->size() == 1 ? list->front() : flat;
  if (const auto* real = number.as<double>()) return *real;
  if (const auto* whole = number.as<std::int64_t>()) return static_cast<double>(*whole);
  return std::nullopt;
}

std::vector<double> numbersIn(const Value::Map& info, const std::string& name) {
  std::vector<double> numbers;
  const auto found = info.find(name);
  const auto* list = found == info.end() ? nullptr : found->second.as<Value::List>();
  if (list == nullptr) return numbers;
  for (const Value& entry : *list) numbers.push_back(numberOf(entry).value_or(0.0));
  return numbers;
}

const Value* findPlain(const Value::Map& map, const std::string& plain) {
  const auto found = std::find_if(map.begin(), map.end(), [&](const Value::Map::value_type& each) {
    return plainName(each.first) == plain;
  });
  return found == map.end() ? nullptr : &found->second;
}

/// A calibration of cv::omnidir has xi besides K and D, and uses K's skew.
void addMirror(const Value::Map& storage, Value::Map& info) {
  const Value* xi = findPlain(storage, "xi");
  const auto number = xi == nullptr ? std::nullopt : numberOf(*xi);
  if (!number) return;
  std::vector<double> lens = {*number};
  const std::vector<double> bending = numbersIn(info, "distortion_coefficients");
  lens.insert(lens.end(), bending.begin(), bending.end());
  lens.resize(5);
  std::vector<double> K = numbersIn(info, "camera_matrix");
  if (K.size() == 9 && K[0] != 0.0) {
    lens.push_back(K[1] / K[0]);
    K[1] = 0.0;
    info["camera_matrix"] = Value(Value::List(K.begin(), K.end()));
  }
  info["distortion_model"] = "omnidirectional";
  info["distortion_coefficients"] = Value(Value::List(lens.begin(), lens.end()));
}

void addSize(const Value::Map& storage, Value::Map& info) {
  for (const char* name : {"imagesize", "size", "resolution"}) {
    const Value* size = findPlain(storage, name);
    const auto* list = size == nullptr ? nullptr : size->as<Value::List>();
    if (list == nullptr || list->size() != 2) continue;
    info.emplace("image_width", list->front());
    info.emplace("image_height", list->back());
  }
}

Value::Map cameraInfoOf(const Value::Map& storage) {
  Value::Map info = withUsualNames(storage, openCvNames());
  addSize(storage, info);
  // A camera that is called a pinhole may still have a lens with distortion.
  const Value* model = findPlain(storage, "cameramodel");
  const auto* name = model == nullptr ? nullptr : model->as<std::string>();
  if (name != nullptr && plainName(*name) != "pinhole") info.emplace("distortion_model", *name);
  const Value* fisheye = findPlain(storage, "fisheyemodel");
  if (fisheye != nullptr && numberOf(*fisheye).value_or(0.0) != 0.0) {
    info.emplace("distortion_model", "fisheye");
  }
  addMirror(storage, info);
  return info;
}

/// The entries of one of several cameras (M1 and D1, cameraMatrix_left, ...), together with the
/// shared ones.
Value::Map entriesOf(const Value::Map& storage, const std::string& ending) {
  static const std::map<std::string, std::string> stereo = {{"r", "rectification_matrix"},
                                                            {"p", "projection_matrix"}};
  Value::Map own = storage;
  for (const auto& [name, value] : storage) {
    const std::string plain = plainName(name);
    if (plain.size() <= ending.size()) continue;
    const std::size_t begin = plain.size() - ending.size();
    if (plain.compare(begin, ending.size(), ending) != 0) continue;
    const std::string stem = plain.substr(0, begin);
    const auto of_pair = stereo.find(stem);
    own.emplace(of_pair == stereo.end() ? stem : of_pair->second, value);
  }
  return own;
}

bool hasCameraMatrix(const Value::Map& storage) {
  return std::any_of(storage.begin(), storage.end(), [](const Value::Map::value_type& each) {
    const auto usual = openCvNames().find(plainName(each.first));
    return usual != openCvNames().end() && usual->second == "camera_matrix";
  });
}

std::vector<ListedCamera> camerasOf(const Value::Map& storage) {
  if (hasCameraMatrix(storage)) return {{"", cameraInfoOf(storage)}};
  std::vector<ListedCamera> cameras;
  for (const char* ending : {"1", "2", "left", "right", "l", "r"}) {
    const Value::Map own = entriesOf(storage, ending);
    if (hasCameraMatrix(own)) cameras.push_back({ending, cameraInfoOf(own)});
  }
  for (const auto& [name, value] : storage) {
    const auto* group = value.as<Value::Map>();
    if (group != nullptr && hasCameraMatrix(*group)) {
      cameras.push_back({name, cameraInfoOf(*group)});
    }
  }
  return cameras;
}

bool beginsWith(const std::string& text, const std::string& beginning) {
  const std::size_t first = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string::npos && text.compare(first, beginning.size(), beginning) == 0;
}

bool recognisesOpenCv(const std::string& text) {
  return beginsWith(text, "%YAML") || beginsWith(text, "<?xml") ||
         beginsWith(text, "<opencv_storage") || text.find("!!opencv-matrix") != std::string::npos;
}

/// The text in the form that FileStorage expects: with its mark at the very beginning.
std::string marked(const std::string& text) {
  if (beginsWith(text, "<opencv_storage")) return "<?xml version=\"1.0\"?>\n" + text;
  if (beginsWith(text, "%YAML") || beginsWith(text, "<?xml")) {
    return text.substr(text.find_first_of("%<"));
  }
  return "%YAML:1.0\n---\n" + text.substr(beginsWith(text, "---") ? text.find("---") + 3 : 0);
}

/// Reads the text with FileStorage, in a sandbox: FileStorage crashes on deeply nested and on some
/// other texts.
Value storageOf(const std::string& text, const std::string& file) {
  const auto read = [&]() -> std::string {
    try {
      const cv::FileStorage opened(marked(text), cv::FileStorage::READ | cv::FileStorage::MEMORY);
      return base::strictJsonText(valueOf(opened.root()));
    } catch (const Error& error) {
      throw Error(file + ": " + error.what());
    } catch (const cv::Exception& error) {
      throw Error(file + ": OpenCV's FileStorage cannot read it: " + error.err);
    }
  };
  const auto result = base::runSandboxed(read, {});
  if (const auto* crash = std::get_if<base::Crash>(&result)) {
    throw Error(file + ": OpenCV's FileStorage " + crash->how + " on it");
  }
  return base::parseJson(std::get<std::string>(result), file);
}

std::vector<ListedCamera> readOpenCvCalibration(const std::string& text, const std::string& file) {
  const Value storage = storageOf(text, file);
  if (const auto* map = storage.as<Value::Map>()) {
    std::vector<ListedCamera> cameras = camerasOf(*map);
    if (!cameras.empty()) return cameras;
  }
  throw Error(file +
              ": found no camera matrix (camera_matrix, cameraMatrix, K or M), which OpenCV's "
              "storage of a calibration should have");
}

}  // namespace

const CalibrationFormat kOpenCvFormat = {recognisesOpenCv, readOpenCvCalibration};

}  // namespace synthetic_dataset::scene
