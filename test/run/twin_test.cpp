/// Runs that label recorded pictures. The pictures were made by an earlier run, whose labels are
/// the truth.

#include <filesystem>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "base/yaml_value.h"
#include "config/twin_runs.h"
#include "output/verify/dataset_verifier.h"
#include "run_fixture.h"
#include "support/bag_builder.h"
#include "support/error_messages.h"

namespace synthetic_dataset::run {
namespace twin_test {

namespace fs = std::filesystem;
using test::BagBuilder;
using test::milliseconds;
using test::RunFixture;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::UnorderedElementsAre;

Value yaml(const std::string& text) { return base::parseYaml(text, "test"); }

using Files = std::map<std::string, std::string>;

std::vector<std::uint8_t> bytesOf(const std::string& text) { return {text.begin(), text.end()}; }

cv::Mat decoded(const std::string& file) {
  return cv::imdecode(bytesOf(file), cv::IMREAD_UNCHANGED);
}

/// The files below a folder of the dataset.
Files below(const std::string& folder, const Files& all) {
  Files some;
  for (const auto& [name, content] : all) {
    if (name.rfind(folder, 0) == 0) some[name] = content;
  }
  return some;
}

std::vector<std::uint8_t> jpegOf(const cv::Mat& picture) {
  std::vector<std::uint8_t> bytes;
  cv::imencode(".jpg", picture, bytes, {cv::IMWRITE_JPEG_QUALITY, 71});
  return bytes;
}

/// Collects the problems of a dataset.
class Problems : public output::VerificationListener {
 public:
  void problem(const std::string& line) override { all.push_back(line); }
  void remark(const std::string& /*line*/) override {}
  void progress(std::int64_t /*scene_count*/, std::int64_t /*of*/) override {}
  std::vector<std::string> all;
};

class Twin : public RunFixture {
 protected:
  Twin() {
    parameters["writers"] = yaml(
        "[{name: boxes, type: synthetic_dataset/UltralyticsYolo}, "
        "{name: masks, type: synthetic_dataset/Coco}]");
    parameters["boxes"] = yaml("{task: detect, image_format: png}");
    truth = filesAnew();  // at 1, 1.25, 1.5, 1.75 s
    setCamera("image_topic", Value("/eye/image_raw"));
    parameters.erase("simulated_rate");
  }

  void setCamera(const std::string& name, const Value& value) {
    Value::Map camera = *parameters.at("camera").as<Value::Map>();
    camera[name] = value;
    parameters["camera"] = Value(camera);
  }

  /// The number in the names of the n-th scene's files.
  static std::string number(std::size_t scene) { return "0000000" + std::to_string(scene); }

  [[nodiscard]] cv::Mat picture(std::size_t scene) const {
    return decoded(truth.at("boxes/images/train/" + number(scene) + ".png"));
  }

  /// Records something for each of the scenes, `late` after its time.
  template <class Record>
  void record(const Record& record, Duration late = Duration{0}) {
    BagBuilder bag(run.folder() / "pictures.bag");
    for (std::size_t i = 0; i < 4; ++i) {
      record(bag, milliseconds(1000 + 250 * static_cast<int>(i)) + late, i);
    }
    parameters["bag_file"] =
        Value(Value::List{Value((run.folder() / "tiny.bag").string()), Value(bag.close())});
  }

  void recordRaw(Duration late = Duration{0}) {
    record([&](BagBuilder& bag, Stamp stamp,
               std::size_t scene) { bag.picture("/eye/image_raw", stamp, picture(scene), "bgr8"); },
           late);
  }

  Files truth;
};

TEST_F(Twin, LabelsRecordedPicturesAsTheWorldThatTheyShow) {
  recordRaw();
  const Files made = filesAnew();
  EXPECT_EQ(below("boxes/labels/", made), below("boxes/labels/", truth));
  EXPECT_EQ(below("masks/annotations/", made), below("masks/annotations/", truth));
  EXPECT_EQ(below("boxes/images/", made), below("boxes/images/", truth));
}

TEST_F(Twin, KeepsThePictureWhateverTheTwinLooksLike) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    cv::Mat other;
    cv::cvtColor(255 - picture(scene), other, cv::COLOR_BGR2RGB);
    bag.picture("/eye/image_raw", stamp, other, "rgb8");
  });
  const Files made = filesAnew();
  EXPECT_EQ(below("boxes/labels/", made), below("boxes/labels/", truth));
  for (std::size_t i = 0; i < 4; ++i) {
    const cv::Mat now = decoded(made.at("boxes/images/train/" + number(i) + ".png"));
    EXPECT_EQ(cv::norm(now, 255 - picture(i), cv::NORM_INF), 0.0);
  }
}

TEST_F(Twin, CopiesAJpegByteForByteAndVerifiesIt) {
  parameters["boxes"] = yaml("{task: detect, image_format: jpg}");
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    bag.pictureFile("/eye/image_raw", stamp, "bgr8; jpeg compressed bgr8", jpegOf(picture(scene)));
  });
  const Files made = filesAnew();
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(bytesOf(made.at("boxes/images/train/" + number(i) + ".jpg")), jpegOf(picture(i)));
    const cv::Mat in_png = decoded(made.at("masks/images/" + number(i) + ".png"));
    EXPECT_EQ(cv::norm(in_png, cv::imdecode(jpegOf(picture(i)), cv::IMREAD_COLOR), cv::NORM_INF),
              0.0);
  }
  Problems problems;
  (void)output::verifyDataset(folder, output::VerificationDepth::kLabels, problems);
  EXPECT_THAT(problems.all, IsEmpty());
  const std::string jpeg = folder + "/boxes/images/train/" + number(2) + ".jpg";
  fs::remove(jpeg);
  cv::imwrite(jpeg, picture(1));
  (void)output::verifyDataset(folder, output::VerificationDepth::kLabels, problems);
  EXPECT_THAT(problems.all, Contains(HasSubstr(number(2) + ".jpg")));
}

TEST_F(Twin, ReadsCompressedPicturesOfAllChannels) {
  const auto pngOf = [](const cv::Mat& pixels) {
    std::vector<std::uint8_t> bytes;
    cv::imencode(".png", pixels, bytes);
    return bytes;
  };
  const auto wide = [](const cv::Mat& pixels) {
    cv::Mat numbers;
    pixels.convertTo(numbers, CV_16U, 257.0);
    return numbers;
  };
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    cv::Mat other;
    switch (scene) {
      case 0:
        bag.pictureFile("/eye/image_raw", stamp, "bgr8; png compressed bgr8", pngOf(picture(0)));
        break;
      case 1:  // as old versions of compressed_image_transport wrote it
        cv::cvtColor(picture(1), other, cv::COLOR_BGR2RGB);
        bag.pictureFile("/eye/image_raw", stamp, "rgb8; png compressed rgb8", pngOf(other));
        break;
      case 2:
        bag.pictureFile("/eye/image_raw", stamp, "png", pngOf(wide(picture(2))));
        break;
      default:
        cv::cvtColor(picture(3), other, cv::COLOR_BGR2GRAY);
        bag.pictureFile("/eye/image_raw", stamp, "mono16; png compressed ", pngOf(wide(other)));
    }
  });
  parameters["boxes"] = yaml("{task: detect, image_format: png}");
  const Files made = filesAnew();
  for (std::size_t i = 0; i < 4; ++i) {
    cv::Mat expected = picture(i);
    if (i == 3) {
      cv::cvtColor(picture(3), expected, cv::COLOR_BGR2GRAY);
      cv::cvtColor(expected, expected, cv::COLOR_GRAY2BGR);
    }
    const cv::Mat now = decoded(made.at("boxes/images/train/" + number(i) + ".png"));
    EXPECT_EQ(cv::norm(now, expected, cv::NORM_INF), 0.0) << i;
  }
}

TEST_F(Twin, TakesEveryNthPictureAndThePicturesClock) {
  recordRaw(milliseconds(37));
  setCamera("time_offset", Value(-0.037));
  parameters["twin"] = yaml("{every: 2}");
  const Files made = filesAnew();
  const std::string labels = "boxes/labels/train/";
  EXPECT_EQ(made.at(labels + number(0) + ".txt"), truth.at(labels + number(0) + ".txt"));
  EXPECT_EQ(made.at(labels + number(1) + ".txt"), truth.at(labels + number(2) + ".txt"));
  EXPECT_EQ(below(labels, made).size(), 2U);
}

TEST_F(Twin, CorrectsWhereTheCameraIs) {
  recordRaw();
  // TF has the camera 10 cm too far to the right, along its x.
  setCamera("pose", yaml("[-3.0, 0.1, 0.5, -0.5, 0.5, -0.5, 0.5]"));
  EXPECT_NE(below("boxes/labels/", filesAnew()), below("boxes/labels/", truth));
  setCamera("correction", yaml("[-0.1, 0, 0, 0, 0, 0, 1]"));
  EXPECT_EQ(below("boxes/labels/", filesAnew()), below("boxes/labels/", truth));
}

TEST_F(Twin, GivesTheSameBytesWhenItGoesOn) {
  recordRaw();
  const Files made = filesAnew();
  fs::remove_all(folder);
  test::StoppingReporter stopping(1);
  (void)generate(stopping);
  EXPECT_LT(files().size(), made.size());
  (void)generate();
  EXPECT_TRUE(files() == made);
}

TEST_F(Twin, MeasuresHowWellLabelsMeetPictures) {
  recordRaw();
  (void)filesAnew();
  const base::SqliteDatabase manifest(folder + "/manifest.sqlite",
                                      base::SqliteDatabase::Mode::kReadOnly);
  base::SqliteStatement rows(manifest, "SELECT alignment FROM scene_alignment ORDER BY scene");
  int count = 0;
  for (; rows.step(); ++count) EXPECT_GT(rows.real(0), 0.85);
  EXPECT_EQ(count, 4);
  base::SqliteStatement objects(manifest, "SELECT count(*) FROM object_alignment");
  ASSERT_TRUE(objects.step());
  EXPECT_EQ(objects.integer(0), 8);
}

TEST_F(Twin, LeavesOutScenesWhoseLabelsDoNotMeetThePicture) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    // In the third picture, alpha is where it was in the first.
    bag.picture("/eye/image_raw", stamp, picture(scene == 2 ? 0 : scene), "bgr8");
  });
  parameters["twin"] = yaml("{min_alignment: 0.8}");
  fs::remove_all(folder);
  const RunSummary summary = generate();
  EXPECT_EQ(summary.warnings.at("scene left out: its alignment is below twin/min_alignment"), 1);
  const Files made = files();
  const std::string labels = "boxes/labels/train/";
  EXPECT_EQ(below(labels, made).size(), 3U);
  EXPECT_EQ(made.count(labels + number(2) + ".txt"), 0U);
  EXPECT_EQ(made.at(labels + number(3) + ".txt"), truth.at(labels + number(3) + ".txt"));
  Problems problems;
  (void)output::verifyDataset(folder, output::VerificationDepth::kLabels, problems);
  EXPECT_THAT(problems.all, IsEmpty());
  EXPECT_TRUE(generate().was_complete);
  fs::remove_all(folder);
  test::StoppingReporter stopping(3);
  (void)generate(stopping);
  (void)generate();
  EXPECT_TRUE(files() == made) << "also when a run goes on behind it";
}

TEST_F(Twin, DrawsTheSameInstants) {
  recordRaw(milliseconds(20));
  setCamera("time_offset", Value(-0.02));
  setCamera("effects", yaml("{exposure: 1.0}"));
  parameters["twin"] = yaml("{output: both}");
  const std::vector<Value> runs = config::twinRuns(Value(parameters));
  ASSERT_EQ(runs.size(), 2U);
  std::map<std::string, Files> made;
  for (const Value& each : runs) {
    parameters = *each.as<Value::Map>();
    (void)generate();
    const std::string output = *parameters.at("output_folder").as<std::string>();
    made[fs::path(output).filename().string()] = test::AllAtOnceRun::files(output);
  }
  for (const std::string output : {"real", "synthetic"}) {
    EXPECT_EQ(below("boxes/labels/", made.at(output)), below("boxes/labels/", truth)) << output;
  }
  EXPECT_EQ(below("boxes/images/", made.at("real")), below("boxes/images/", truth));
  const std::string first = "boxes/images/train/" + number(0) + ".png";
  EXPECT_GT(cv::mean(decoded(made.at("synthetic").at(first)))[0], 1.2 * cv::mean(picture(0))[0])
      << "effects are those of the drawn pictures";
}

TEST_F(Twin, NeedsAFolderForBothDatasets) {
  parameters["twin"] = yaml("{output: both}");
  for (const std::string folder : {"", "missing"}) {
    parameters["output_folder"] = Value(folder);
    if (folder == "missing") parameters.erase("output_folder");
    EXPECT_THAT(test::messagesOf([&] { (void)config::twinRuns(Value(parameters)); }),
                ElementsAre(HasSubstr("output_folder: missing; with twin/output: both")));
  }
}

TEST_F(Twin, RefusesPicturesThatDoNotFitBeforeTheFirstScene) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    if (scene == 0) {
      bag.picture("/eye/image_raw", stamp, picture(scene), "bgr8");
    } else if (scene == 1) {
      bag.picture("/eye/image_raw", stamp, cv::Mat(60, 80, CV_8UC1, cv::Scalar(1)), "mono8");
    } else {
      bag.picture("/eye/image_raw", stamp, picture(scene), "bgr12");
    }
  });
  EXPECT_THAT(errors(),
              UnorderedElementsAre(
                  AllOf(HasSubstr("camera/image_topic: the picture of '/eye/image_raw' at "
                                  "1.500000000 s has the encoding 'bgr12'"),
                        HasSubstr("the same holds for 1 more")),
                  HasSubstr("the picture of '/eye/image_raw' at 1.250000000 s has 80 x 60 pixels; "
                            "its calibration is of 160 x 120")));
}

TEST_F(Twin, RefusesAJpegThatBreaksOff) {
  record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
    std::vector<std::uint8_t> jpeg = jpegOf(picture(scene));
    if (scene == 3) jpeg.resize(jpeg.size() / 2);
    bag.pictureFile("/eye/image_raw", stamp, "jpeg", jpeg);
  });
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("at 1.750000000 s of format 'jpeg' cannot be "
                                              "decoded: the file breaks off or is damaged")));
}

TEST_F(Twin, RefusesSettingsThatContradictPictures) {
  recordRaw();
  setCamera("effects", yaml("{blur: 1}"));
  parameters["randomize"] = yaml("{objects: {alpha: {present: 0.5}}}");
  EXPECT_THAT(errors(), ElementsAre(HasSubstr("camera/effects: found together with image_topic"),
                                    HasSubstr("randomize/objects: found together with")));
}

TEST_F(Twin, LabelsCamerasOfOneShutterTogetherAndRefusesOthers) {
  Value::Map camera = *parameters.at("camera").as<Value::Map>();
  Value::Map other = camera;
  other["image_topic"] = Value("/other");
  parameters.erase("camera");
  parameters["cameras"] = Value(Value::Map{{"left", Value(camera)}, {"right", Value(other)}});
  const auto recordBoth = [&](Duration late) {
    record([&](BagBuilder& bag, Stamp stamp, std::size_t scene) {
      bag.picture("/eye/image_raw", stamp, picture(scene), "bgr8");
      bag.picture("/other", stamp + late, picture(scene), "bgr8");
    });
  };
  fs::remove_all(folder);
  recordBoth(std::chrono::microseconds(900));
  EXPECT_EQ(generate().scenes, 8);
  recordBoth(milliseconds(17));
  EXPECT_THAT(errors(), ElementsAre(AllOf(HasSubstr("cameras/right/image_topic: none of its "
                                                    "pictures is within 1.000 ms"),
                                          HasSubstr("17.000 ms away"))));
}

}  // namespace twin_test
}  // namespace synthetic_dataset::run
