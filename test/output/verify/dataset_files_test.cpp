#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>

#include "output/files/run_lock.h"
#include "output/verify/verification_fixture.h"

namespace synthetic_dataset::output {
namespace dataset_files_test {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

/// A KITTI dataset of two scenes: three files each, and lists.
class VerifyFiles : public VerificationTest {
 protected:
  VerifyFiles() : VerificationTest("Kitti") { write({sceneOfBoth(0), sceneOfBoth(1)}); }

  void overwrite(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
  }

  const std::string label_ = "training/label_2/000001.txt";
};

TEST_F(VerifyFiles, TellsOfOneThatIsMissing) {
  fs::remove(path(label_));
  EXPECT_THAT(problems(), ElementsAre("'" + path(label_) + "' is missing"));
}

TEST_F(VerifyFiles, TellsOfOneThatIsCutShort) {
  const std::string content = read(label_);
  overwrite(label_, content.substr(0, 10));
  EXPECT_THAT(problems(), ElementsAre("'" + path(label_) + "' is cut short: found 10 bytes; it " +
                                      "should have " + std::to_string(content.size())));
}

TEST_F(VerifyFiles, TellsOfOneThatIsTooLong) {
  overwrite(label_, read(label_) + " ");
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("' is too long: found ")));
}

TEST_F(VerifyFiles, TellsOfAByteThatIsChanged) {
  std::string content = read(label_);
  content.back() = ' ';  // instead of the line's end: the label is the same
  overwrite(label_, content);
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("' is changed: found the SHA-256 ")));
}

TEST_F(VerifyFiles, QuicklyLooksAtSizesAlone) {
  std::string content = read(label_);
  content.front() = 'x';
  overwrite(label_, content);
  EXPECT_THAT(problems(VerificationDepth::kSizes), IsEmpty());
  EXPECT_EQ(counts_.labels, 0);
  fs::resize_file(path(label_), 3);
  EXPECT_THAT(problems(VerificationDepth::kSizes), ElementsAre(HasSubstr("is cut short")));
}

TEST_F(VerifyFiles, TellsOfTwoThatAreSwapped) {
  fs::rename(path("training/label_2/000000.txt"), path("swap"));
  fs::rename(path(label_), path("training/label_2/000000.txt"));
  fs::rename(path("swap"), path(label_));
  EXPECT_THAT(problems(), UnorderedElementsAre(HasSubstr("000000.txt' is changed"),
                                               HasSubstr("000001.txt' is changed")));
}

TEST_F(VerifyFiles, TellsOfWhatIsNoFile) {
  fs::remove(path(label_));
  fs::create_directory(path(label_));
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("' is a folder; it should be a file of ")));
  fs::remove(path(label_));
  fs::create_symlink(path("training/label_2/000000.txt"), path(label_));
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("' is a symbolic link; it should be a file of ")));
}

TEST_F(VerifyFiles, TellsOfFilesThatNobodyLists) {
  for (const std::string name : {"c", "a", "b", "training/d"}) (void)folder_.write("w/" + name, "");
  EXPECT_THAT(
      problems(),
      ElementsAre("'" + folder() + "': found 4 files that no manifest lists ('" + path("a") +
                  "', '" + path("b") + "', '" + path("c") + "' and more); it should have none"));
}

TEST_F(VerifyFiles, PassesOverAReport) {
  change("UPDATE writer SET output_folder = './'");
  (void)folder_.write("report.html", "page");
  EXPECT_THAT(problems(VerificationDepth::kSizes), IsEmpty());
  (void)folder_.write("w/report.html", "another's");
  EXPECT_THAT(problems(VerificationDepth::kSizes), ElementsAre(HasSubstr("w/report.html'")));
}

TEST_F(VerifyFiles, TellsOfAFileOfTheDatasetAsAWhole) {
  overwrite("ImageSets/train.txt", "000001\n000000\n");
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("ImageSets/train.txt' is changed")));
}

TEST_F(VerifyFiles, TakesLinksForWhatTheyName) {
  const std::string image = "training/image_2/000001.png";
  fs::rename(path(image), folder_ / "elsewhere.png");
  fs::create_hard_link(folder_ / "elsewhere.png", path(image));
  EXPECT_THAT(problems(), IsEmpty());
}

TEST_F(VerifyFiles, TellsOfAPictureThatIsNone) {
  replace("training/image_2/000001.png", "no picture");
  EXPECT_THAT(problems(), ElementsAre(AllOf(HasSubstr("scene 1, writer 'w': "),
                                            HasSubstr("000001.png': cannot be decoded"))));
}

TEST_F(VerifyFiles, TellsOfLabelsThatCannotBeRead) {
  replace(label_, "cup 0 0\n");
  EXPECT_THAT(problems(), ElementsAre(AllOf(HasSubstr("scene 1, writer 'w': "),
                                            HasSubstr("found the line 'cup 0 0'"))));
}

TEST_F(VerifyFiles, TellsOfPathsThatLeadOut) {
  change("UPDATE file SET path = '../secret' WHERE path = 'w/" + label_ + "'");
  EXPECT_THAT(problems(), Contains(HasSubstr("the listed path '../secret' leads out")));
  change("UPDATE file SET path = '/etc/hostname' WHERE path = '../secret'");
  EXPECT_THAT(
      problems(),
      Contains(HasSubstr("the listed path '/etc/hostname' is not in the folder of its writer")));
}

TEST_F(VerifyFiles, RemarksThatLabelsAreNotCheckedWithoutTheirWriter) {
  change("UPDATE writer SET type = 'gone/Writer'");
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_THAT(
      remarks_,
      ElementsAre(HasSubstr("the labels of 'w' are not checked, as its writer cannot be run: ")));
}

TEST_F(VerifyFiles, StopsWhereARunIsWriting) {
  const output::RunLock lock((folder_ / "manifest.sqlite").string());
  fs::remove(path(label_));
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("a run is writing it right now")));
}

TEST_F(VerifyFiles, LeavesTheDatasetAsItIs) {
  const auto tree = [&] {
    std::vector<std::string> names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      names.push_back(entry.path().string());
    }
    std::sort(names.begin(), names.end());
    return names;
  };
  const std::vector<std::string> before = tree();
  EXPECT_THAT(problems(), IsEmpty());
  EXPECT_EQ(tree(), before);
}

class VerifyUnfinished : public VerificationTest {
 protected:
  VerifyUnfinished() : VerificationTest("Kitti") {}
};

TEST_F(VerifyUnfinished, SaysHowToGoOn) {
  writeUnfinished({sceneOfBoth(0), sceneOfBoth(1)});
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("its state is 'running': 2 scenes are there, of 3 "
                                                "that the run has; the same command that began "
                                                "it continues it")));
  EXPECT_EQ(counts_.labels, 4);
}

TEST_F(VerifyUnfinished, RemarksWhatAKillLeftHalfWritten) {
  writeUnfinished({sceneOfBoth(0)});
  (void)folder_.write("w/training/label_2/.000000.txt.tmp", "half");
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("its state is 'running'")));
  EXPECT_THAT(remarks_, ElementsAre(HasSubstr("1 files are half written")));
}

TEST_F(VerifyUnfinished, MindsHalfWrittenFilesOfACompleteRun) {
  write({sceneOfBoth(0)});
  (void)folder_.write("w/training/label_2/.000000.txt.tmp", "half");
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("found 1 half-written files of a run")));
}

TEST_F(VerifyUnfinished, TellsThatThereIsNoDataset) {
  EXPECT_THAT(problems(), ElementsAre(HasSubstr("no dataset is there")));
}

}  // namespace dataset_files_test
}  // namespace synthetic_dataset::output
