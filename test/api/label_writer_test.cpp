#include "synthetic_dataset/label_writer.h"

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset {
namespace label_writer_test {

using ::testing::HasSubstr;

class NullOutput : public SceneOutput {
 public:
  void addImage(const std::string&, const cv::Mat&) override {}
  void addIndexedImage(const std::string&, const cv::Mat&, const std::vector<cv::Vec3b>&) override {
  }
  void addText(const std::string&, std::string) override {}
  void addMask(const std::string&, const Mask&) override {}
  void addRecord(const std::string&, std::string) override {}
  void addWarning(const std::string&) override {}
};

class ThrowingWriter : public LabelWriter {
  void doWriteScene(const Scene&, SceneOutput&) const override {
    throw std::runtime_error("out of ink");
  }
};

class OddWriter : public LabelWriter {
  void doWriteScene(const Scene&, SceneOutput&) const override { throw 7; }
};

void initialize(LabelWriter& writer) {
  WriterParameters parameters(Parameters(Value::Map{}), "mine", "/tmp/mine/");
  writer.initialize(parameters, {});
}

Scene emptyScene() { return Scene(CameraModel(4, 4, {1, 1, 2, 2}, 0.1, 10)); }

TEST(LabelWriter, AddsItsNameToWhateverIsThrown) {
  NullOutput output;
  ThrowingWriter writer;
  initialize(writer);
  EXPECT_THAT(test::messagesOf([&] { writer.writeScene(emptyScene(), output); }),
              testing::ElementsAre("writer 'mine': out of ink"));
  OddWriter odd;
  initialize(odd);
  EXPECT_THAT(test::messagesOf([&] { odd.writeScene(emptyScene(), output); }),
              testing::ElementsAre(HasSubstr("writer 'mine': threw something")));
}

TEST(LabelWriter, KeepsItsLifeCycle) {
  NullOutput output;
  ThrowingWriter writer;
  EXPECT_THROW(writer.writeScene(emptyScene(), output), Error);
  EXPECT_THROW((void)writer.requirements(), Error);
  initialize(writer);
  EXPECT_THROW(initialize(writer), Error);
}

TEST(LabelWriter, NeedsNothingUnlessItSaysSo) {
  ThrowingWriter writer;
  initialize(writer);
  EXPECT_FALSE(writer.requirements().silhouettes);
  EXPECT_TRUE(writer.requirements().frames.empty());
}

TEST(WriterParameters, RememberTheFilesThatTheUserNamed) {
  WriterParameters writer(Parameters(Value::Map{{"main_list", Value("/tmp/list.txt")},
                                                {"inside", Value("list.txt")},
                                                {"folder", Value("/tmp/")}},
                                     "yolo"),
                          "yolo", "/tmp/yolo/");
  EXPECT_EQ(writer.requiredFile("main_list").path(), "/tmp/list.txt");
  EXPECT_EQ(writer.requiredFile("inside").path(), "/tmp/yolo/list.txt");
  (void)writer.requiredFile("folder");
  EXPECT_EQ(writer.files().size(), 2U);
  EXPECT_THAT(writer.errors(),
              testing::ElementsAre("yolo/folder: found '/tmp/'; it should be the path of a file"));
}

TEST(WriterParameters, RefuseAFileWithAControlCharacter) {
  WriterParameters writer(Parameters(Value::Map{{"list", Value("a\nb")}}, "yolo"), "yolo",
                          "/tmp/yolo/");
  (void)writer.requiredFile("list");
  EXPECT_THAT(writer.errors(), testing::ElementsAre(testing::HasSubstr("a control character")));
  EXPECT_TRUE(writer.files().empty());
}

}  // namespace label_writer_test
}  // namespace synthetic_dataset
