/// Templates through the loader; for xacro, with stand-ins for the program on PATH.

#include "world/files/template_file.h"

#include <cstdlib>

#include <gmock/gmock.h>

#include <sys/stat.h>

#include "support/error_messages.h"
#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace template_file_test {

using synthetic_dataset::test::messagesOf;
using test::TemporaryFolder;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class Xacro : public testing::Test {
 protected:
  ~Xacro() override { setenv("PATH", path_.c_str(), 1); }

  /// Puts a program `xacro` before all others on PATH.
  void install(const std::string& script) const {
    const auto file = folder_.write("bin/xacro", "#!/bin/sh\n" + script);
    chmod(file.c_str(), 0755);
    setenv("PATH", ((folder_ / "bin").string() + ":" + path_).c_str(), 1);
  }

  /// Sets a PATH without xacro and without Python.
  void uninstall() const {
    (void)folder_.write("none/nothing", "");
    setenv("PATH", (folder_ / "none").c_str(), 1);
  }

  TemporaryFolder folder_;
  const std::string path_ = std::getenv("PATH");
  const std::filesystem::path file_ = folder_.write("arm.urdf.xacro", "<robot/>");
  ResourceFinder finder_ = test::finderIn(folder_);
};

TEST_F(Xacro, MakesARobotOfItsFileAndArguments) {
  install("echo \"<robot name='r'><link name='${2#prefix:=}arm'/></robot>\"");
  WorldLoader loader(finder_);
  const Model model = loader.loadModel(file_.string(), "alpha", {{"prefix", "left_"}});
  ASSERT_EQ(model.links.size(), 1U);
  EXPECT_EQ(model.links[0].name, "left_arm");
}

TEST_F(Xacro, MayMakeAnSdfModel) {
  install("cat <<E\n" + test::modelFile("m", test::linkElement(test::visualElement(test::kBox))) +
          "\nE\n");
  WorldLoader loader(finder_);
  EXPECT_EQ(loader.loadModel(file_.string(), "alpha").links.at(0).visuals.size(), 1U);
}

TEST_F(Xacro, FindsMeshesBesideItsFile) {
  (void)folder_.write("arm.obj", test::kTriangleObj);
  install(
      "echo \"<robot name='r'><link name='a'><visual><geometry><mesh filename='arm.obj'/>"
      "</geometry></visual></link></robot>\"");
  WorldLoader loader(finder_);
  EXPECT_EQ(loader.loadModel(file_.string(), "alpha").links.at(0).visuals.size(), 1U);
}

TEST_F(Xacro, TellsWhatIsWrongWithTheFile) {
  install("echo 'No such argument: prefix' >&2; exit 2");
  WorldLoader loader(finder_);
  EXPECT_THAT(
      messagesOf([&] { (void)loader.loadModel(file_.string(), "alpha"); }),
      ElementsAre(AllOf(HasSubstr("arm.urdf.xacro: '"), HasSubstr("exit code 2"),
                        HasSubstr("No such argument: prefix"), HasSubstr("model_arguments"))));
}

TEST_F(Xacro, TellsHowToGetItWhereThereIsNone) {
  uninstall();
  WorldLoader loader(finder_);
  EXPECT_THAT(messagesOf([&] {
                (void)loader.loadModel(file_.string(), "alpha", {{"prefix", "a b"}});
              }),
              ElementsAre(AllOf(HasSubstr("there is no xacro to expand it"),
                                HasSubstr("pip install --no-deps"), HasSubstr("'prefix:=a b'"),
                                HasSubstr("> robot.urdf"))));
}

TEST_F(Xacro, KnowsWhatRos2CallsAPackagesFolder) {
  install("echo \"Unknown substitution command [find-pkg-share arm]\" >&2; exit 2");
  (void)folder_.write("python/xacro.py",
                      "def eval_extension(text):\n"
                      "    return text.replace('$(find arm)', 'shoulder')\n"
                      "def main():\n"
                      "    name = eval_extension('$(find-pkg-share arm)')\n"
                      "    print(\"<robot name='r'><link name='%s'/></robot>\" % name)\n");
  setenv("PYTHONPATH", (folder_ / "python").c_str(), 1);
  WorldLoader loader(finder_);
  const Model model = loader.loadModel(file_.string(), "alpha");
  unsetenv("PYTHONPATH");
  EXPECT_EQ(model.links.at(0).name, "shoulder");
}

TEST_F(Xacro, IsGivenThePackagesOfRos2) {
  setenv("AMENT_PREFIX_PATH", "/opt/jazzy", 1);
  install("echo \"<robot name='r'><link name='${ROS_PACKAGE_PATH##*:/opt}'/></robot>\"");
  WorldLoader loader(finder_);
  const Model model = loader.loadModel(file_.string(), "alpha");
  unsetenv("AMENT_PREFIX_PATH");
  EXPECT_THAT(model.links.at(0).name, HasSubstr("/jazzy/share:/usr/share"));
}

TEST_F(Xacro, IsEndedWhereItCrashes) {
  install("kill -SEGV $$");
  EXPECT_THAT(messagesOf([&] { (void)expandTemplate(file_, {}); }),
              ElementsAre(HasSubstr("crashes (Segmentation fault)")));
}

TEST_F(Xacro, ExpandsAFileThatAModelsFolderNames) {
  install("echo \"<robot name='x'><link name='arm'/></robot>\"");
  (void)folder_.write("models/x/model.config",
                      "<model><name>x</name><sdf version='1.5'>x.xacro</sdf></model>");
  (void)folder_.write("models/x/x.xacro", "<robot/>");
  const ResourceFinder finder({(folder_ / "models").string()}, nullptr);
  const auto world = folder_.write("a.world", test::worldFile(test::includeElement("model://x")));
  EXPECT_EQ(loadWorld(world.string(), finder).models.at(0).links.at(0).name, "arm");
}

TEST(Jinja, MakesAWorldOfItsFile) {
  const TemporaryFolder folder;
  const auto world = folder.write(
      "a.world.jinja",
      test::worldFile("{%- set y = 0.3 -%}{% for i in range(2) %}" +
                      test::modelElement(
                          "m{{ i }}", "<pose>0 {{ i * y }} 0 0 0 0</pose>" + test::linkElement()) +
                      "{% endfor %}"));
  const Description described = loadWorld(world.string(), test::finderIn(folder));
  ASSERT_EQ(described.models.size(), 2U);
  EXPECT_DOUBLE_EQ(described.models[1].X_WM.translation().y(), 0.3);
}

TEST(Jinja, IsGivenTheArgumentsOfAModel) {
  const TemporaryFolder folder;
  (void)folder.write("part.sdf", test::linkElement());
  const auto file = folder.write(
      "a.sdf.jinja", test::modelFile("m", "{% if arm %}{% include 'part.sdf' %}{% endif %}"));
  const ResourceFinder finder = test::finderIn(folder);
  WorldLoader loader(finder);
  EXPECT_EQ(loader.loadModel(file.string(), "alpha", {{"arm", "1"}}).links.size(), 1U);
}

TEST(Jinja, TellsWhatIsWrongWithTheFile) {
  const TemporaryFolder folder;
  const auto faultOf = [&](const std::string& text) {
    const auto file = folder.write("a.sdf.jinja", text);
    return messagesOf([&] { (void)expandTemplate(file, {}); });
  };
  EXPECT_THAT(faultOf("<sdf>\n{% if %}</sdf>"),
              ElementsAre(AllOf(HasSubstr("a.sdf.jinja: "), HasSubstr("line 2: "))));
  EXPECT_THAT(faultOf("{{ ''.__class__.__mro__ }}"), ElementsAre(HasSubstr("SecurityError")));
}

}  // namespace template_file_test
}  // namespace synthetic_dataset::world
