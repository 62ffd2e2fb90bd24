#include "output/writers/writer_outputs.h"

#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "support/temporary_folder.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace writer_outputs_test {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

/// The message of the error that an action throws.
template <class Action>
std::string failureOf(const Action& action) {
  try {
    action();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

/// The outputs of the first of two writers, in the folder `first`.
class WriterOutputs : public testing::Test {
 protected:
  [[nodiscard]] std::string path(const std::string& name) const {
    return (folder_ / name).string();
  }

  /// Commits a scene with a single text file.
  void commit(std::int64_t scene, std::size_t writer, const std::string& name) {
    store_.commitScene({scene, Stamp{scene}}, {{{writer, path(name), {}, "text", {}}}, {}});
  }

  test::TemporaryFolder folder_;
  WriterParameters parameters_{Parameters(Value::Map{}, "first"), "first", path("first") + "/"};
  output::SceneFiles files_;
  std::vector<std::string> warnings_;
  GatheringSceneOutput scene_output_{0, parameters_, files_, warnings_};
  output::DatasetStore store_{[&] {
                                output::StoreOptions options;
                                options.folder = folder_.path().string();
                                return options;
                              }(),
                              {{"first", "test/First", path("first/"), {}},
                               {"second", "test/Second", path("second/"), {}}}};
  StoringDatasetOutput dataset_output_{0, parameters_, store_};
};

TEST_F(WriterOutputs, GatherIndicesAndColours) {
  const cv::Mat indices(2, 2, CV_8UC1, cv::Scalar(1));
  scene_output_.addIndexedImage("classes/0.png", indices, {{0, 0, 0}, {1, 2, 3}});
  ASSERT_THAT(files_.files, SizeIs(1));
  EXPECT_EQ(files_.files[0].path, path("first/classes/0.png"));
  EXPECT_EQ(files_.files[0].pixels.data, indices.data);
  EXPECT_THAT(files_.files[0].palette, SizeIs(2));
}

TEST_F(WriterOutputs, GatherMasksAsTheyAre) {
  const Mask mask(cv::Mat(2, 2, CV_8UC1, cv::Scalar(255)), {3, 1}, {8, 6});
  scene_output_.addMask("masks/0.png", mask);
  ASSERT_THAT(files_.files, SizeIs(1));
  EXPECT_EQ(files_.files[0].mask.pixels().data, mask.pixels().data);
  EXPECT_THAT(failureOf([&] { scene_output_.addMask("masks/1.png", {}); }), HasSubstr("no pixels"));
  EXPECT_THAT(failureOf([&] { scene_output_.addMask("masks/1.bmp", mask); }), HasSubstr(".png"));
}

TEST_F(WriterOutputs, RefuseARecordsChannelOfTwoLines) {
  scene_output_.addRecord("images", "a\nb");
  EXPECT_THAT(failureOf([&] { scene_output_.addRecord("a\nb", ""); }), HasSubstr("channel"));
  EXPECT_THAT(files_.records, SizeIs(1));
}

TEST_F(WriterOutputs, WriteNoFileThatTheirParametersDoNotName) {
  WriterParameters others(Parameters(Value::Map{{"list", Value(path("list.txt"))}}), "second",
                          path("second") + "/");
  const FileParameter list = others.requiredFile("list");
  for (const FileParameter& file : {list, FileParameter()}) {
    EXPECT_THAT(failureOf([&] { dataset_output_.addFileAtParameter(file, [](std::ostream&) {}); }),
                HasSubstr("requiredFile"));
  }
}

TEST_F(WriterOutputs, RefuseAnIndexWithoutAColour) {
  const cv::Mat indices(2, 2, CV_8UC1, cv::Scalar(1));
  EXPECT_THAT(failureOf([&] {
                scene_output_.addIndexedImage("0.png", indices, {{0, 0, 0}});
              }),
              AllOf(HasSubstr("the image '0.png' cannot be written"), HasSubstr("a pixel is 1")));
  EXPECT_THAT(files_.files, IsEmpty());
}

TEST_F(WriterOutputs, KnowAnIndexedImagesPathAsAnyOther) {
  const cv::Mat indices(2, 2, CV_8UC1, cv::Scalar(0));
  scene_output_.addText("0.png", "");
  EXPECT_THAT(failureOf([&] {
                scene_output_.addIndexedImage("0.png", indices, {{0, 0, 0}});
              }),
              HasSubstr("'0.png' was used twice"));
  EXPECT_THAT(failureOf([&] {
                scene_output_.addIndexedImage("../0.png", indices, {{0, 0, 0}});
              }),
              HasSubstr("'../0.png'"));
}

TEST_F(WriterOutputs, LetALibraryWriteAFileInTheWritersFolder) {
  dataset_output_.addFileByName("all.bag",
                                [](const std::string& file) { std::ofstream(file) << "bag"; });
  EXPECT_EQ(test::readFile(path("first/all.bag")), "bag");
}

TEST_F(WriterOutputs, LeaveNoFileOfALibraryThatFails) {
  const auto fail = [](const std::string& file) {
    std::ofstream(file) << "half";
    throw std::runtime_error("no more");
  };
  EXPECT_EQ(failureOf([&] { dataset_output_.addFileByName("all.bag", fail); }), "no more");
  EXPECT_TRUE(std::filesystem::is_empty(path("first")));
}

TEST_F(WriterOutputs, LinkAndReadAWritersOwnSceneFiles) {
  commit(0, 0, "first/deep/0.txt");
  EXPECT_EQ(dataset_output_.readFile("deep/0.txt"), "text");
  dataset_output_.addLink("train/1.txt", "deep/0.txt");
  EXPECT_TRUE(std::filesystem::equivalent(path("first/deep/0.txt"), path("first/train/1.txt")));
}

TEST_F(WriterOutputs, ReachNoFileOfAnotherWriter) {
  commit(0, 1, "second/0.txt");
  EXPECT_THAT(failureOf([&] { (void)dataset_output_.readFile("../second/0.txt"); }),
              HasSubstr("the path '../second/0.txt' cannot be used"));
  EXPECT_THAT(failureOf([&] { dataset_output_.addLink("0.txt", "../second/0.txt"); }),
              HasSubstr("the path '../second/0.txt' cannot be used"));
  EXPECT_THAT(failureOf([&] { (void)dataset_output_.readFile(path("second/0.txt")); }),
              HasSubstr("cannot be used"));
  EXPECT_TRUE(std::filesystem::is_empty(path("first")));
}

TEST_F(WriterOutputs, UseEachPathOfADatasetOnce) {
  commit(0, 0, "first/0.txt");
  dataset_output_.addLink("1.txt", "0.txt");
  EXPECT_THAT(failureOf([&] { dataset_output_.addLink("1.txt", "0.txt"); }),
              HasSubstr("'1.txt' was used twice"));
  EXPECT_THAT(failureOf([&] { dataset_output_.addFileByName("1.txt", [](const auto&) {}); }),
              HasSubstr("'1.txt' was used twice"));
}

}  // namespace writer_outputs_test
}  // namespace synthetic_dataset::output
