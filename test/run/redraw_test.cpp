#include "run/redraw.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <opencv2/imgcodecs.hpp>

#include "all_at_once_run.h"
#include "base/sqlite.h"
#include "output/files/digest.h"
#include "output/manifest/manifest_schema.h"
#include "run_fixture.h"
#include "support/temporary_folder.h"
#include "support/verification_list.h"
#include "support/writers/plugin_environment.h"

namespace synthetic_dataset::run {
namespace redraw_test {

namespace fs = std::filesystem;
using ::testing::AllOf;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::StartsWith;

/// The findings of `verify --redraw` for a dataset.
struct Verified : test::VerificationList {
  explicit Verified(const std::string& folder) {
    // Never destroyed: class_loader cannot unload libraries once the program ends.
    static output::WriterLoader& writers = *new output::WriterLoader({test::pluginXml()});
    scenes = output::verifyDataset(folder, output::VerificationDepth::kLabels, *this, writers,
                                   [this](const auto& dataset, auto& verifier) {
                                     redraw(dataset, verifier, *this, {test::pluginXml()});
                                   })
                 .drawn;
  }

  std::int64_t scenes = 0;  ///< that were drawn again
};

/// Four scenes of a box that drives past another one.
class RedrawTest : public test::RunFixture {
 protected:
  void SetUp() override { generate(); }

  void change(const std::string& sql) const {
    base::SqliteDatabase(output::manifestFile(folder), base::SqliteDatabase::Mode::kExisting)
        .execute(sql);
  }

  void changePixel(const std::string& picture, int by) const {
    const std::string file = folder + "/" + picture;
    cv::Mat pixels = cv::imread(file, cv::IMREAD_UNCHANGED);
    ASSERT_FALSE(pixels.empty());
    uchar& value = *pixels.ptr(7, 5);
    value = static_cast<uchar>(value < 128 ? value + by : value - by);
    cv::imwrite(file, pixels);
  }
};

TEST_F(RedrawTest, FindsNothingInADatasetThatNobodyHasTouchedAndWritesNothing) {
  const auto before = files();
  const Verified verified(folder);
  EXPECT_THAT(verified.problems, IsEmpty());
  EXPECT_EQ(verified.scenes, 4);
  EXPECT_TRUE(files() == before);
}

TEST_F(RedrawTest, CountsThePixelsOfAPictureThatDiffer) {
  changePixel("yolo/00000002.png", 7);
  EXPECT_THAT(Verified(folder).problems,
              Contains("drawn again, scene 2, writer 'yolo': 00000002.png: 1 of 19200 pixels "
                       "differ, by up to 7"));
}

TEST_F(RedrawTest, NamesTheMaskThatDiffers) {
  changePixel("stvnet/bravo/mask/00000001.png", 255);
  EXPECT_THAT(Verified(folder).problems,
              Contains(AllOf(StartsWith("drawn again, scene 1, writer 'stvnet': "),
                             HasSubstr("bravo/mask/00000001.png: 1 of 19200 pixels differ"))));
}

TEST_F(RedrawTest, NamesAWrongLabelOnce) {
  const std::string file = folder + "/yolo/00000002.txt";
  std::string text = test::readFile(file);
  const std::size_t decimal = text.find('.') + 1;
  text[decimal] = text[decimal] == '1' ? '2' : '1';
  std::ofstream(file) << text;
  const std::string label = "scene 2, writer 'yolo': object '";
  EXPECT_THAT(Verified(folder).problems, ElementsAre(HasSubstr("yolo/00000002.txt' is changed"),
                                                     StartsWith("drawn again, " + label)));
  change("UPDATE file SET digest = '" + output::digestOf(text) +
         "' WHERE path = 'yolo/00000002.txt'");
  EXPECT_THAT(Verified(folder).problems, ElementsAre(StartsWith(label)));
}

TEST_F(RedrawTest, NamesPosesThatTheRecordingDoesNotHave) {
  change("UPDATE scene_object SET y = y + 0.25 WHERE scene = 1 AND object = 0");
  change("UPDATE scene SET z = z + 1 WHERE \"index\" = 3");
  EXPECT_THAT(
      Verified(folder).problems,
      AllOf(Contains(StartsWith("drawn again, scene 1: object 'alpha': found the pose [0, 0, 0;")),
            Contains(StartsWith("drawn again, scene 3: camera 'camera': found the pose ["))));
}

TEST_F(RedrawTest, NamesInputsThatHaveChangedOrAreMissingAndDrawsNothing) {
  fs::remove(run.folder() / "tiny.bag");
  run.folder().write("camera.yaml", "another");
  const Verified verified(folder);
  EXPECT_THAT(verified.problems,
              ElementsAre(HasSubstr("camera.yaml' has changed; restore the file that the dataset"),
                          AllOf(HasSubstr("cannot be drawn again: cannot read '"),
                                HasSubstr("tiny.bag'"))));
  EXPECT_EQ(verified.scenes, 0);
}

TEST_F(RedrawTest, SaysThatAnotherMesaHasDrawnIt) {
  change("UPDATE software SET version = 'another' WHERE name = 'opengl'");
  const Verified verified(folder);
  EXPECT_THAT(verified.problems, IsEmpty());
  EXPECT_THAT(verified.remarks, Contains(HasSubstr("software opengl: then another, now ")));
}

TEST_F(RedrawTest, TakesTheLossOfJpegFilesForNoDifference) {
  fs::remove_all(folder);
  parameters["writers"] = Value(Value::List{
      Value(Value::Map{{"name", Value("w")}, {"type", Value("synthetic_dataset/ImageFolder")}})});
  parameters["w"] = Value(Value::Map{{"image_format", Value("jpg")}});
  parameters["image"] = Value(Value::Map{{"jpeg_quality", Value(60)}});
  for (const char* unused : {"yolo", "bounding_shape", "stvnet"}) parameters.erase(unused);
  generate();
  EXPECT_THAT(Verified(folder).problems, IsEmpty());
}

TEST(RedrawTestOfShards, DrawsTheScenesThatAreThereOfTwoCamerasAndSixFormats) {
  const test::AllAtOnceRun run;
  (void)run.runShard(1, 2, run.folder());
  const Verified verified(run.folder());
  EXPECT_THAT(verified.problems, IsEmpty());
  EXPECT_EQ(verified.scenes, 8);
}

TEST(RedrawTestOfAStoppedRun, DrawsTheScenesThatAreThere) {
  const test::AllAtOnceRun run;
  test::StoppingReporter stopping(3);
  (void)run.run(stopping, run.folder());
  const Verified verified(run.folder());
  EXPECT_THAT(verified.problems, ElementsAre(HasSubstr("its state is 'running'")));
  EXPECT_GE(verified.scenes, 3);
  EXPECT_LT(verified.scenes, 16);
}

}  // namespace redraw_test
}  // namespace synthetic_dataset::run
