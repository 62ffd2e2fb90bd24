/// Every value of every format is changed, one after another, with the right size and digest in the
/// manifest; `verify` has to see each. Values are taken from the files themselves, so that a new
/// one is changed as well.

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <optional>
#include <regex>
#include <sstream>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>

#include "output/verify/verification_fixture.h"
#include "plugins/format_cases.h"

namespace synthetic_dataset::output {
namespace tampered_values_test {

using nlohmann::json;
using testing::IsEmpty;

/// A file's content with one value changed.
struct Tampered {
  std::string what;  ///< which value
  std::string content;
};

/// Values that `verify` says it does not check (docs/verify.md).
bool isUnchecked(const std::string& format, const std::string& what) {
  struct Exception {
    std::string format;
    std::regex what;
  };
  static const std::vector<Exception> kExceptions = {
      // An extra byte at its end does not change what is in the bag.
      {"RosBag", std::regex(R"(dataset\.bag.*)")},
      // Intensities times 255 do not reveal what they were made from, nor categories which object a
      // point belongs to.
      {"NuScenes", std::regex(R"((samples/LIDAR_TOP|lidarseg)/.*\.bin, .*)")},
  };
  return std::any_of(kExceptions.begin(), kExceptions.end(), [&](const Exception& each) {
    return format.rfind(each.format, 0) == 0 && std::regex_match(what, each.what);
  });
}

/// Another number with as many decimals, far enough away to matter.
std::string otherNumber(const std::string& word) {
  std::istringstream stream(word);
  stream.imbue(std::locale::classic());
  double number = 0.0;
  stream >> number;
  const std::size_t point = word.find('.');
  if (point == std::string::npos) return std::to_string(static_cast<long long>(number) + 1);
  const auto decimals = static_cast<int>(word.size() - point - 1);
  const double several_steps = 5.0 * std::pow(10.0, -decimals);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.setf(std::ios::fixed);
  text.precision(decimals);
  text << number + std::max(several_steps, 0.02 * (1.0 + std::abs(number)));
  return text.str();
}

std::string otherWord(const std::string& word) {
  static const std::regex kNumber(R"(-?\d+(\.\d+)?)");
  return std::regex_match(word, kNumber) ? otherNumber(word) : word + "x";
}

json otherValue(const json& value) {
  if (value.is_boolean()) return !value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>() + 1;
  if (value.is_number()) {
    const auto number = value.get<double>();
    return number + 0.02 * (1.0 + std::abs(number));
  }
  if (value.is_string()) return value.get<std::string>() + "x";
  return 0;  // for null
}

/// Each leaf changed, and a member added to each object and an entry to each list.
std::vector<Tampered> ofJson(const std::string& text, const std::string& name) {
  const json whole = json::parse(text);
  std::vector<Tampered> all;
  const std::function<void(const json&, const json::json_pointer&)> visit =
      [&](const json& value, const json::json_pointer& place) {
        json changed = whole;
        json& here = changed[place];
        if (value.is_object()) {
          here["more"] = 1;
        } else if (value.is_array()) {
          here.push_back(value.empty() ? json(1) : value.back());
        } else {
          here = otherValue(value);
        }
        const std::string what = name + place.to_string();
        all.push_back({what, changed.dump()});
        for (const auto& each : value.items()) {
          if (value.is_object()) visit(each.value(), place / each.key());
        }
        for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
          // Only some of many similar entries, such as run lengths.
          if (value.size() > 40 && i % 7 != 0) continue;
          visit(value[i], place / i);
        }
      };
  visit(whole, json::json_pointer());
  return all;
}

/// As ofJson, for each line of a file.
std::vector<Tampered> ofJsonLines(const std::string& text, const std::string& name) {
  std::vector<Tampered> all;
  std::size_t begin = 0;
  for (int line = 1; begin < text.size(); ++line) {
    const std::size_t end = text.find('\n', begin);
    for (const Tampered& each :
         ofJson(text.substr(begin, end - begin), name + ", line " + std::to_string(line))) {
      all.push_back({each.what, text.substr(0, begin) + each.content + text.substr(end)});
    }
    begin = end + 1;
  }
  return all;
}

/// Each word changed, and each line left out.
std::vector<Tampered> ofText(const std::string& text, const std::string& name) {
  std::vector<Tampered> all;
  std::size_t begin = 0;
  for (int line = 1; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size() - 1) + 1;
    const std::string place = name + ", line " + std::to_string(line);
    const bool is_one_of_many = text.size() > 3000 && line % 7 != 0;
    if (!is_one_of_many) all.push_back({place, text.substr(0, begin) + text.substr(end)});
    int word = 0;
    for (std::size_t at = begin; at < end && !is_one_of_many;) {
      const auto isGap = [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; };
      const bool is_xml = text[begin] == '<' || text[begin] == '\t';
      const bool has_commas = std::filesystem::path(name).extension() == ".csv" ||
                              text.find_first_not_of("0123456789.,-", begin) + 1 == end;
      const auto ends = [&](char c) {
        return isGap(c) || (is_xml && (c == '<' || c == '>')) || (has_commas && c == ',');
      };
      if (ends(text[at])) {
        ++at;
        continue;
      }
      std::size_t word_end = at;
      while (word_end < end && !ends(text[word_end])) ++word_end;
      all.push_back(
          {place + ", word " + std::to_string(++word),
           text.substr(0, at) + otherWord(text.substr(at, word_end - at)) + text.substr(word_end)});
      at = word_end;
    }
    begin = end;
  }
  return all;
}

/// Pixels of a square changed, in a picture of any kind.
std::vector<Tampered> ofPicture(const std::string& bytes, const std::string& name) {
  const std::vector<uchar> encoded(bytes.begin(), bytes.end());
  std::vector<Tampered> all;
  // On one object, on the other, and on neither.
  for (const cv::Rect& square :
       {cv::Rect(14, 14, 8, 8), cv::Rect(209, 34, 8, 8), cv::Rect(80, 70, 8, 8)}) {
    cv::Mat picture = cv::imdecode(encoded, cv::IMREAD_UNCHANGED);
    constexpr int kSmall = 8;  // if the squares do not fit, all pixels are changed
    cv::Mat part = picture.cols < kSmall ? picture : picture(square);
    if (picture.depth() == CV_32F) {
      part += cv::Scalar::all(0.25);
    } else {
      part = cv::Scalar::all(255) - part;
    }
    std::vector<uchar> changed;
    cv::imencode(std::filesystem::path(name).extension().string(), picture, changed);
    all.push_back(
        {name + ", pixels at " + std::to_string(square.x), {changed.begin(), changed.end()}});
  }
  return all;
}

/// The numbers of an array of doubles, which are at the file's end.
std::vector<Tampered> ofNumbers(const std::string& bytes, const std::string& name) {
  std::vector<Tampered> all;
  for (std::size_t i = 1; i <= 12; ++i) {
    std::string changed = bytes;
    double number = 0.0;
    char* const place = changed.data() + changed.size() - i * sizeof number;
    std::memcpy(&number, place, sizeof number);
    number += 0.01;
    std::memcpy(place, &number, sizeof number);
    all.push_back({name + ", number " + std::to_string(i) + " from its end", changed});
  }
  return all;
}

/// The coordinates of points of 16 bytes changed, a point added, and a point removed.
std::vector<Tampered> ofPoints(const std::string& bytes, const std::string& name) {
  constexpr std::size_t kPoint = 4 * sizeof(float);
  std::vector<Tampered> all = {{name + ", the last point", bytes.substr(0, bytes.size() - kPoint)},
                               {name + ", a point more", bytes + bytes.substr(0, kPoint)}};
  for (std::size_t at = 0; at < bytes.size(); at += sizeof(float)) {
    if (at / kPoint % 499 != 0) continue;  // some of many
    std::string changed = bytes;
    float number = 0.0F;
    std::memcpy(&number, changed.data() + at, sizeof number);
    number += 0.1F;
    std::memcpy(changed.data() + at, &number, sizeof number);
    all.push_back({name + ", byte " + std::to_string(at), changed});
  }
  return all;
}

std::vector<Tampered> allOf(const std::string& bytes, const std::string& name) {
  const std::string kind = std::filesystem::path(name).extension().string();
  if (kind == ".json") return ofJson(bytes, name);
  if (kind == ".jsonl") return ofJsonLines(bytes, name);
  if (kind == ".png" || kind == ".jpg" || kind == ".tiff") return ofPicture(bytes, name);
  if (kind == ".npy") return ofNumbers(bytes, name);
  if (kind == ".bin") return ofPoints(bytes, name);
  if (kind == ".bag") return {{name, bytes + "x"}};
  return ofText(bytes, name);
}

class TamperedValues : public VerificationTest, public testing::WithParamInterface<FormatCase> {
 protected:
  TamperedValues() : VerificationTest(GetParam().type, GetParam().has_lidar) {}

  /// The part of the scene with both objects in it: small pictures are verified faster.
  Scene smallScene() {
    const cv::Rect part(96, 96, 240, 88);
    const Scene whole = sceneOfBoth(0);
    Scene scene(CameraModel(part.width, part.height, {500.0, 510.0, 120.0, 44.0}, 0.05, 100.0));
    dataset_.cameras = {{"camera", "camera/optical_link", scene.camera}};
    scene.name = whole.name;
    scene.camera_name = whole.camera_name;
    scene.stamp = whole.stamp;
    scene.X_GC = makePose({0.1, 0.2, 0.3}, Eigen::Quaterniond(0.9, 0.1, -0.2, 0.3).normalized());
    scene.image = whole.image(part).clone();
    scene.instance_map = whole.instance_map()(part).clone();
    scene.class_map = whole.class_map()(part).clone();
    scene.world_map = whole.world_map()(part).clone();
    scene.part_map = whole.part_map()(part).clone();
    scene.depth = whole.depth()(part).clone();
    scene.setTransforms([](const std::string&, const std::string&) { return Pose::Identity(); });
    const auto moved = [&](const std::optional<Box>& box) -> std::optional<Box> {
      if (!box) return std::nullopt;
      return Box{box->left - part.x, box->top - part.y, box->right - part.x, box->bottom - part.y};
    };
    for (SceneObject object : whole.objects) {
      object.X_CO = object.X_GO;
      object.X_GO = scene.X_GC * *object.X_CO;
      object.silhouette = Mask(object.silhouette().whole()(part).clone());
      object.visible_mask = Mask(object.visible_mask().whole()(part).clone());
      object.loose_box = moved(object.loose_box);
      object.silhouette_box = moved(object.silhouette_box());
      object.keypoints.front().pixel = Eigen::Vector2d(21.5, 30.25);
      scene.objects.push_back(std::move(object));
    }
    if (whole.clouds.isKnown()) scene.clouds = whole.clouds();
    return scene;
  }

  [[nodiscard]] std::vector<std::string> files() const {
    std::vector<std::string> names;
    for (const auto& each : std::filesystem::recursive_directory_iterator(folder())) {
      if (each.is_regular_file()) names.push_back(each.path().string().substr(folder().size()));
    }
    std::sort(names.begin(), names.end());
    return names;
  }

  /// Changes every value of every file of a scene.
  void expectThatEachChangeIsSeen(const Scene& scene) {
    write({scene}, GetParam().parameters);
    change("UPDATE file SET linked_to = NULL");  // each name is changed by itself
    ASSERT_THAT(problems(), IsEmpty());
    ASSERT_THAT(remarks_, testing::SizeIs(GetParam().remarks));
    std::vector<std::string> unseen;
    std::size_t count = 0;
    for (const std::string& file : files()) {
      const std::string right = read(file);
      for (const Tampered& each : allOf(right, file)) {
        replace(file, each.content);
        ++count;
        const bool is_seen = !problems().empty();
        if (!is_seen && !isUnchecked(GetParam().name, each.what)) unseen.push_back(each.what);
      }
      replace(file, right);
    }
    EXPECT_THAT(unseen, IsEmpty());
    EXPECT_GE(count, 10U);
    RecordProperty("values", static_cast<int>(count));
  }
};

TEST_P(TamperedValues, AreAllSeen) {
  dataset_.motions = {{"walk", 0, 1, 12.0}};
  expectThatEachChangeIsSeen(smallScene());
}

INSTANTIATE_TEST_SUITE_P(Formats, TamperedValues, testing::ValuesIn(formatCases()),
                         [](const auto& format) { return format.param.name; });

INSTANTIATE_TEST_SUITE_P(OtherPackages, TamperedValues,
                         testing::Values(FormatCase{
                             "BoxTable", "box_table_writer/BoxTable", {{"table", "boxes.csv"}}}),
                         [](const auto& format) { return format.param.name; });

/// A world with a floor, a wall and pixels of neither; the first object has two parts.
class TamperedClassesOfTheWorldAndParts : public TamperedValues {};

TEST_P(TamperedClassesOfTheWorldAndParts, AreAllSeen) {
  dataset_.world_classes = {"floor", "wall"};
  dataset_.objects[0].part_names = {"handle", "lid"};
  Scene scene = smallScene();
  cv::Mat world = scene.world_map();
  world(cv::Rect(0, 60, 200, 28)).setTo(1);
  world(cv::Rect(60, 0, 30, 20)).setTo(2);
  world.setTo(0, scene.instance_map() != 0);
  cv::Mat parts = scene.part_map();
  parts(cv::Rect(0, 0, 20, 30)).setTo(1);
  parts(cv::Rect(20, 10, 10, 30)).setTo(2);
  parts.setTo(0, scene.instance_map() != 1);
  expectThatEachChangeIsSeen(scene);
}

INSTANTIATE_TEST_SUITE_P(
    Formats, TamperedClassesOfTheWorldAndParts,
    testing::Values(FormatCase{"Cityscapes", "Cityscapes"},
                    FormatCase{"Coco", "Coco", {{"panoptic", true}, {"background", "rest"}}},
                    FormatCase{"CocoPolygons", "Coco", {{"segmentation", "polygons"}}},
                    FormatCase{"PascalVoc", "PascalVoc"},
                    FormatCase{"PascalVocBorder", "PascalVoc", {{"void_border", 1}}}),
    [](const auto& format) { return format.param.name; });

}  // namespace tampered_values_test
}  // namespace synthetic_dataset::output
