/// Label files against those of the original tool, from the bag to the file.

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>

#include <gtest/gtest.h>

#include "reference/golden_case.h"
#include "run/generator.h"
#include "support/temporary_folder.h"
#include "support/writers/plugin_environment.h"
#include "synthetic_dataset/label_text.h"

namespace synthetic_dataset {
namespace golden_labels_test {

namespace fs = std::filesystem;
using test::GoldenCase;
using test::readFile;

// The original rounds stamps through a double of seconds, so its poses are off by up to 0.1 um and
// a last digit may differ.
constexpr double kTolerance = 1.1e-5;

constexpr double kWidth = 640.0;
constexpr double kHeight = 480.0;

/// Whether the texts are equal, except that numbers may differ by the tolerance.
::testing::AssertionResult sameLabels(const std::string& ours, const std::string& original) {
  std::istringstream our_words(ours);
  std::istringstream original_words(original);
  std::string our_word;
  std::string original_word;
  while (original_words >> original_word) {
    if (!(our_words >> our_word)) return ::testing::AssertionFailure() << "ends early: " << ours;
    if (our_word == original_word) continue;
    char* end = nullptr;
    const double difference =
        std::strtod(our_word.c_str(), &end) - std::strtod(original_word.c_str(), nullptr);
    if (*end != '\0' || std::abs(difference) > kTolerance ||
        our_word.find('.') == std::string::npos) {
      return ::testing::AssertionFailure() << our_word << " instead of " << original_word << " in\n"
                                           << ours << "instead of\n"
                                           << original;
    }
  }
  // White space is part of the format: with all digits made equal, the texts have to be the same.
  const auto shape = [](std::string text) {
    for (char& c : text) {
      if (std::isdigit(static_cast<unsigned char>(c)) != 0) c = '0';
    }
    return text;
  };
  if (shape(ours) != shape(original)) {
    return ::testing::AssertionFailure()
           << "'" << ours << "' is laid out unlike '" << original << "'";
  }
  return ::testing::AssertionSuccess();
}

bool whollyInView(const GoldenCase::ObjectFrame& object) {
  return !object.behind_camera && object.box[0] >= 0 && object.box[1] >= 0 &&
         object.box[2] <= kWidth && object.box[3] <= kHeight;
}

bool outOfView(const GoldenCase::ObjectFrame& object) {
  return object.box[2] <= 0 || object.box[3] <= 0 || object.box[0] >= kWidth ||
         object.box[1] >= kHeight;
}

/// The original's YOLO lines with boxes cut to the image (defect D5 mended).
std::string mendedYolo(const std::string& original, const GoldenCase::Frame& frame,
                       const std::vector<std::string>& objects) {
  std::istringstream lines(original);
  std::string result;
  for (const std::string& object : objects) {
    std::string line;
    std::getline(lines, line);
    const GoldenCase::ObjectFrame& known = frame.objects.at(object);
    if (outOfView(known)) continue;
    if (!whollyInView(known)) {
      const double left = std::max(known.box[0], 0.0) / kWidth;
      const double right = std::min(known.box[2], kWidth) / kWidth;
      const double top = std::max(known.box[1], 0.0) / kHeight;
      const double bottom = std::min(known.box[3], kHeight) / kHeight;
      line = line.substr(0, line.find(' '));
      for (const double n : {(left + right) / 2, (top + bottom) / 2, right - left, bottom - top}) {
        line += " " + fixed(n, 5);
      }
    }
    result += line + "\n";
  }
  return result;
}

struct Expected {
  std::string name;
  std::vector<std::string> objects;
  std::int64_t scenes;
  std::int64_t scenes_before_the_originals_first;
};

class GoldenLabels : public ::testing::TestWithParam<Expected> {
 protected:
  void SetUp() override {
    test::preparePluginEnvironment();
    const Value parameters = golden.parameters(folder / "out", folder / "boxes.world");
    run::Reporter silent;
    run::Generator generator(parameters, silent, {test::pluginXml()});
    summary = generator.run();
  }

  [[nodiscard]] std::string ours(const std::string& file) const {
    return readFile(folder / "out" / file);
  }
  [[nodiscard]] std::string ourNumber(std::size_t original_frame) const {
    return sceneNumber(static_cast<std::int64_t>(original_frame) +
                       GetParam().scenes_before_the_originals_first);
  }

  GoldenCase golden{GetParam().name};
  test::TemporaryFolder folder;
  run::RunSummary summary;
};

TEST_P(GoldenLabels, HaveTheSameScenes) {
  EXPECT_EQ(summary.scenes, GetParam().scenes);
  EXPECT_EQ(static_cast<std::int64_t>(golden.frames().size()) +
                GetParam().scenes_before_the_originals_first,
            GetParam().scenes);
}

TEST_P(GoldenLabels, OfYoloAreTheOriginals) {
  for (std::size_t i = 0; i < golden.frames().size(); ++i) {
    const std::string original =
        readFile(golden.folder() / "yolo" / (sceneNumber(static_cast<std::int64_t>(i)) + ".txt"));
    EXPECT_TRUE(sameLabels(ours("yolo/data/" + ourNumber(i) + ".txt"),
                           mendedYolo(original, golden.frames()[i], GetParam().objects)))
        << "frame " << i;
  }
}

TEST_P(GoldenLabels, OfStvNetAreTheOriginals) {
  for (const std::string& object : GetParam().objects) {
    for (std::size_t i = 0; i < golden.frames().size(); ++i) {
      const fs::path file = fs::path("stvnet") / object / "labels" / (ourNumber(i) + ".txt");
      if (outOfView(golden.frames()[i].objects.at(object))) {
        EXPECT_FALSE(fs::exists(folder / "out" / file)) << file;
        continue;
      }
      const std::string original = readFile(golden.folder() / "stvnet" / object / "labels" /
                                            (sceneNumber(static_cast<std::int64_t>(i)) + ".txt"));
      EXPECT_TRUE(sameLabels(ours(file.string()), original)) << file;
    }
  }
}

TEST_P(GoldenLabels, OfBoundingShapeAreTheOriginalsOneFileAScene) {
  for (std::size_t i = 0; i < golden.frames().size(); ++i) {
    const std::string original = readFile(golden.folder() / "expected_fixed" / "bounding_shape" /
                                          (sceneNumber(static_cast<std::int64_t>(i)) + ".txt"));
    EXPECT_TRUE(sameLabels(ours("bounding_shape/" + ourNumber(i) + ".txt"), original))
        << "frame " << i;
  }
}

TEST_P(GoldenLabels, MainListNamesEveryImage) {
  std::string expected;
  for (std::int64_t i = 0; i < GetParam().scenes; ++i) {
    expected += (folder / "out").string() + "/yolo/data/" + sceneNumber(i) + ".png\n";
  }
  EXPECT_EQ(ours("yolo/output.txt"), expected);
}

INSTANTIATE_TEST_SUITE_P(
    Cases, GoldenLabels,
    ::testing::Values(Expected{"example", {"athreos"}, 3, 0},
                      Expected{"nested_late_early", {"bravo", "alpha", "charlie"}, 15, 0},
                      // From exactly 12.34 s; the original's rounding loses the first scene.
                      Expected{"simtime_trunc", {"solo"}, 37, 1}),
    [](const auto& golden) { return golden.param.name; });

}  // namespace golden_labels_test
}  // namespace synthetic_dataset
