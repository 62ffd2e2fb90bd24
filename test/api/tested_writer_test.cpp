#include "synthetic_dataset/tested_writer.h"

#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <opencv2/core.hpp>
#include <ostream>

#include "support/error_messages.h"
#include "synthetic_dataset/hand_made.h"

namespace synthetic_dataset {
namespace tested_writer_test {

using test::messagesOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

/// A writer whose behaviour is set by the test.
class AnyWriter : public LabelWriter {
 public:
  std::function<void(const Scene&, SceneOutput&)> write = [](const Scene&, SceneOutput&) {};
  std::function<void(const SceneRecords&, DatasetOutput&)> end = [](const SceneRecords&,
                                                                    DatasetOutput&) {};
  Requirements requirements_of_test;

 private:
  void doInitialize(WriterParameters& parameters, const DatasetInfo& /*dataset*/) override {
    list_ = parameters.requiredFile("list");
    if (parameters.optional("chatty", false)) parameters.addWarning("much is said");
  }
  Requirements doRequirements() const override { return requirements_of_test; }
  void doWriteScene(const Scene& scene, SceneOutput& output) const override {
    write(scene, output);
  }
  void doFinalize(const SceneRecords& records, DatasetOutput& output) const override {
    output.addFileAtParameter(list_, [](std::ostream& text) { text << "all"; });
    end(records, output);
  }

  FileParameter list_;
};

const Value::Map kParameters = {{"list", Value("/tmp/list.txt")}};

class TestedWriterTest : public testing::Test {
 protected:
  TestedWriter tested(Value::Map parameters = kParameters) {
    return {writer_, parameters, handMadeDataset({cup_})};
  }
  Scene scene(std::int64_t index = 0) const { return handMadeScene(index, {cup_}); }

  AnyWriter writer_;
  SceneObject cup_ = handMadeObject("cup", {10, 20, 30, 40});
};

TEST_F(TestedWriterTest, GivesWhatASceneBecomes) {
  writer_.requirements_of_test.visible_masks = true;
  writer_.write = [](const Scene& scene, SceneOutput& output) {
    output.addImage("a.png", scene.image);
    output.addMask("b.png", scene.objects[0].visible_mask());
    output.addText("c.txt", "three");
    output.addRecord("names", scene.name);
    output.addWarning("it is late");
  };
  const WrittenFiles files = tested().write(scene());
  EXPECT_EQ(files.images.at("a.png").at<cv::Vec3b>(0, 0), cv::Vec3b::all(50));
  EXPECT_EQ(cv::countNonZero(files.images.at("b.png")), 1200);
  EXPECT_EQ(files.texts.at("c.txt"), "three");
  EXPECT_THAT(files.records, ElementsAre(Pair("names", "00000000")));
  EXPECT_THAT(files.warnings, ElementsAre("it is late"));
}

TEST_F(TestedWriterTest, GivesTheFilesOfTheDatasetByTheRecordsOfItsScenes) {
  writer_.write = [](const Scene& scene, SceneOutput& output) {
    output.addText(scene.name + ".txt", "of " + scene.name);
    output.addRecord("names", scene.name);
  };
  writer_.end = [](const SceneRecords& records, DatasetOutput& output) {
    output.addFile("all.txt", [&](std::ostream& text) {
      records.forEach("names", [&](std::int64_t index, const std::string& name) {
        text << index << name << output.readFile(name + ".txt") << '\n';
      });
    });
    output.addLink("last.txt", "00000002.txt");
    output.addFileByName("named.txt",
                         [](const std::string& file) { std::ofstream(file) << "by name"; });
  };
  TestedWriter writer = tested();
  (void)writer.write(scene(2));
  (void)writer.write(scene(1));
  const WrittenFiles files = writer.finalize();
  EXPECT_EQ(files.texts.at("all.txt"), "100000001of 00000001\n200000002of 00000002\n");
  EXPECT_EQ(files.texts.at("/tmp/list.txt"), "all");
  EXPECT_EQ(files.texts.at("named.txt"), "by name");
  EXPECT_EQ(files.links.at("last.txt"), "00000002.txt");
}

TEST_F(TestedWriterTest, KeepsFromTheWriterWhatItDoesNotRequire) {
  writer_.write = [](const Scene& scene, SceneOutput& output) {
    output.addMask("a.png", scene.objects[0].visible_mask());
  };
  EXPECT_THAT(messagesOf([&] { (void)tested().write(scene()); }),
              Contains(HasSubstr("Requirements::visible_masks")));
}

TEST_F(TestedWriterTest, RefusesAWriterThatKeepsSomethingFromCallToCall) {
  int calls = 0;
  writer_.write = [&](const Scene&, SceneOutput& output) {
    output.addText("a.txt", std::to_string(calls++));
  };
  EXPECT_THAT(messagesOf([&] { (void)tested().write(scene()); }),
              Contains(HasSubstr("when asked again")));
}

TEST_F(TestedWriterTest, RefusesPathsAsTheCoreDoes) {
  writer_.write = [](const Scene&, SceneOutput& output) { output.addText("../a.txt", ""); };
  EXPECT_THAT(messagesOf([&] { (void)tested().write(scene()); }), Contains(HasSubstr("'..'")));
  AnyWriter twice;
  twice.write = [](const Scene&, SceneOutput& output) {
    output.addText("a.txt", "");
    output.addText("a.txt", "");
  };
  TestedWriter writer(twice, kParameters, handMadeDataset({cup_}));
  EXPECT_THAT(messagesOf([&] { (void)writer.write(scene()); }), Contains(HasSubstr("used twice")));
}

TEST_F(TestedWriterTest, SaysAllThatIsWrongWithTheParameters) {
  EXPECT_THAT(messagesOf([&] {
                (void)tested({{"lst", Value("a.txt")}});
              }),
              Contains(HasSubstr("w/lst: is not")));
  AnyWriter another;
  EXPECT_THAT(messagesOf([&] { (void)TestedWriter(another, Value::Map{}, handMadeDataset({})); }),
              Contains(HasSubstr("w/list")));
}

TEST_F(TestedWriterTest, KeepsTheWarningsOfTheStart) {
  Value::Map parameters = kParameters;
  parameters["chatty"] = Value(true);
  EXPECT_THAT(tested(parameters).warnings(), ElementsAre("much is said"));
}

}  // namespace tested_writer_test
}  // namespace synthetic_dataset
