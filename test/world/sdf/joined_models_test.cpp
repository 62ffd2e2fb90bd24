#include "world/sdf/joined_models.h"

#include <gmock/gmock.h>
#include <tinyxml2.h>
#include <opencv2/imgcodecs.hpp>

#include "support/description_text.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace joined_models_test {

using synthetic_dataset::test::textOf;
using test::errorsOf;
using test::kBox;
using test::kTriangleObj;
using test::linkElement;
using test::loadText;
using test::meshElement;
using test::modelFile;
using test::TemporaryFolder;
using test::visualElement;
using testing::HasSubstr;

constexpr const char* kNamed =
    "<uri>m.sdf</uri><name>a</name><pose>1 2 3 0.1 0.2 0.3</pose><static>true</static>";

/// How many of a world's includes are joined with the file m.sdf.
int joinedIn(const std::string& includes, const std::string& file,
             const std::string& version = "1.7") {
  const TemporaryFolder folder;
  const auto path = folder.write("m.sdf", file);
  tinyxml2::XMLDocument included;
  included.Parse(file.c_str());
  tinyxml2::XMLDocument document;
  std::string text =
      "<sdf version='" + version + "'><world name='w'>" + includes + "</world></sdf>";
  for (std::size_t at = text.find("m.sdf"); at != std::string::npos; at = text.find("m.sdf", at)) {
    text.replace(at, 5, path.string());
    at += path.string().size();
  }
  document.Parse(text.c_str());
  const bool any = joinModels(*document.RootElement(), [&](const std::filesystem::path& copy) {
    return copy == path ? IncludedFile{included.RootElement(), "/models/m.sdf"} : IncludedFile{};
  });
  int count = 0;
  const tinyxml2::XMLElement* world = document.RootElement()->FirstChildElement("world");
  for (const auto* model = world->FirstChildElement("model"); model != nullptr;
       model = model->NextSiblingElement("model")) {
    EXPECT_STREQ(model->Attribute(kJoinedFrom), "/models/m.sdf");
    ++count;
  }
  EXPECT_EQ(any, count > 0);
  return count;
}

std::string include(const std::string& content, const std::string& attributes = "") {
  return "<include " + attributes + ">" + content + "</include>";
}

const std::string kModel = modelFile("m", linkElement(visualElement(kBox)));

TEST(JoinedModels, StandInThePlaceOfPlainIncludes) {
  EXPECT_EQ(joinedIn(include("<uri>m.sdf</uri>") + include(kNamed), kModel), 2);
}

TEST(JoinedModels, LeaveIncludesThatMayMeanMore) {
  const std::string uri = "<uri>m.sdf</uri>";
  for (const std::string& each :
       {include(uri, "merge='false'"), include(uri + "<placement_frame>f</placement_frame>"),
        include(uri + "<pose relative_to='f'>0 0 0 0 0 0</pose>"), include(uri + "<pose/>"),
        include(uri + "<name>a::b</name>"), include(uri + "<name> a</name>"),
        include(uri + "<name>a</name><name>b</name>"), include("<uri>other.sdf</uri>")}) {
    EXPECT_EQ(joinedIn(each, kModel), 0) << each;
  }
}

TEST(JoinedModels, AreOfFilesOfOneModelInTheWorldsVersion) {
  const std::string plain = include("<uri>m.sdf</uri>");
  EXPECT_EQ(joinedIn(plain, kModel, "1.6"), 0);
  const std::string model = "<model name='m'><link name='l'/></model>";
  EXPECT_EQ(joinedIn(plain, "<sdf version='1.7'>" + model + "</sdf>"), 1);
  for (const std::string& content :
       {model + model, model + "<light name='l'/>", std::string("<light name='l'/>"),
        std::string("<model name='m'><link name='a::l'/></model>"),
        std::string("<model><link name='l'/></model>"),
        std::string("<model name=''><link name='l'/></model>"),
        std::string("<model name='m'><pose>a b c</pose><link name='l'/></model>"),
        std::string("<model name='m'><static>perhaps</static><link name='l'/></model>"),
        std::string("<model name='m'><pose relative_to='l'>0 0 0 0 0 0</pose></model>")}) {
    EXPECT_EQ(joinedIn(plain, "<sdf version='1.7'>" + content + "</sdf>"), 0) << content;
  }
}

/// Worlds that draw in a model of another folder, with a mesh, a picture and a model of its own.
class JoinedModelsInWorlds : public testing::TestWithParam<const char*> {
 protected:
  JoinedModelsInWorlds() {
    folder_.write("m/inner.sdf", "<sdf version='1.4'><model name='i'><link name='l'>" +
                                     visualElement(meshElement("meshes/t.obj")) +
                                     "</link></model></sdf>");
    folder_.write("m/meshes/t.obj", std::string("mtllib t.mtl\nusemtl p\n") + kTriangleObj);
    folder_.write("m/meshes/t.mtl", "newmtl p\nmap_Kd p.png\n");
    cv::imwrite((folder_ / "m/meshes/p.png").string(), cv::Mat(2, 2, CV_8UC3, cv::Scalar(1, 2, 3)));
    folder_.write("m/model.config", "<model><sdf version='1.7'>model.sdf</sdf></model>");
    writeModel("1.7");
  }

  void writeModel(const std::string& version) {
    std::string text = modelFile(
        "m", "<pose>9 9 9 0 0 1</pose>" +
                 linkElement(visualElement(meshElement("meshes/t.obj")) +
                             "<collision name='c'><geometry>" + kBox + "</geometry></collision>" +
                             "<sensor name='s' type='camera'><pose>1 0 0 0 0 0</pose><camera/>" +
                             "</sensor>") +
                 (version == "1.7" ? "<include><uri>inner.sdf</uri><name>i</name></include>" : ""));
    text.replace(text.find("1.7"), 3, version);
    folder_.write("m/model.sdf", text);
  }

  [[nodiscard]] std::string load(const std::string& attributes) const {
    std::string content;
    for (const std::string& rest :
         {std::string(), std::string("<name>a</name><pose>1 2 3 0.1 0.2 0.3</pose>"),
          std::string("<name>b</name><static>true</static>")}) {
      content += include("<uri>model://m</uri>" + rest, attributes);
    }
    return textOf(loadText(folder_, std::string("<sdf version='") + GetParam() +
                                        "'><world name='w'>" + content + "</world></sdf>"));
  }

  TemporaryFolder folder_;
};

TEST_P(JoinedModelsInWorlds, AreAsLibsdformatIncludesThem) {
  writeModel(GetParam());
  const std::string joined = load("");
  EXPECT_EQ(joined, load("merge='false'"));
  EXPECT_THAT(joined, HasSubstr((folder_ / "m/meshes/p.png").string()));
  EXPECT_THAT(joined, HasSubstr("camera a::body::s"));
}

INSTANTIATE_TEST_SUITE_P(OfVersion, JoinedModelsInWorlds,
                         testing::Values("1.3", "1.4", "1.5", "1.6", "1.7"));

TEST(JoinedModels, LeaveErrorsTheirFilesAndLines) {
  const TemporaryFolder folder;
  const auto file =
      folder.write("m.sdf", "<sdf version='1.7'>\n<model name='m'>\n<link/></model></sdf>");
  const std::vector<std::string> errors = errorsOf(folder, test::worldFile(include(kNamed)));
  EXPECT_THAT(errors,
              testing::Contains(HasSubstr(file.string() + ":L3]: Msg: Required attribute[name]")));
}

}  // namespace joined_models_test
}  // namespace synthetic_dataset::world
