#include "run/setup/credit.h"

#include <gmock/gmock.h>

#include "support/temporary_folder.h"

namespace synthetic_dataset::run {
namespace credit_test {

class Credits : public testing::Test {
 protected:
  [[nodiscard]] Credit of(const std::string& file) { return finder_.creditOf(folder_ / file); }

  void write(const std::string& name, const std::string& content) const {
    (void)folder_.write(name, content);
  }

  /// A file's path relative to the folder; empty if there is no file.
  [[nodiscard]] std::string below(const std::filesystem::path& file) const {
    return file.empty() ? "" : file.lexically_relative(folder_.path()).string();
  }

  test::TemporaryFolder folder_;
  CreditFinder finder_;
};

TEST_F(Credits, AreThoseOfTheModel) {
  write("chair/model.config",
        "<model><name>chair</name><author><name>Ada</name><email>a@b</email></author>"
        "<author><name> Ben </name></author><license>CC-BY 4.0</license></model>");
  write("chair/meshes/seat.stl", "");
  const Credit credit = of("chair/meshes/seat.stl");
  EXPECT_EQ(credit.author, "Ada; Ben");
  EXPECT_EQ(credit.license, "CC-BY 4.0");
  EXPECT_EQ(below(credit.author_in), "chair/model.config");
  EXPECT_EQ(below(credit.license_in), "chair/model.config");
}

TEST_F(Credits, OfColladaAreItsContributorsAndTheirCopyright) {
  write("a.dae",
        "<?xml version=\"1.0\"?><COLLADA xmlns=\"x\" version=\"1.4.1\"><asset><contributor>"
        "<author>Ada</author><copyright>(c) Ada &amp; sons</copyright></contributor>"
        "<contributor><author>Ada</author></contributor><contributor><author>Ben</author>"
        "</contributor></asset><library_geometries/></COLLADA>");
  const Credit credit = of("a.dae");
  EXPECT_EQ(credit.author, "Ada; Ben");
  EXPECT_EQ(credit.license, "(c) Ada & sons");
  EXPECT_EQ(below(credit.license_in), "a.dae");
}

TEST_F(Credits, OfGltfAreTheCopyrightOfItsAsset) {
  write("a.gltf",
        R"({"asset": {"generator": "x } \" {", "copyright": "2020 Ada, CC0", "version": "2.0"},)"
        R"("scenes": []})");
  EXPECT_EQ(of("a.gltf").license, "2020 Ada, CC0");
  const std::string json = R"({"asset":{"version":"2.0","copyright":"Ben"}})";
  write("b.glb", std::string("glTF\x02\0\0\0\0\0\0\0\0\0\0\0JSON", 20) + json + '\0' + "\xff\xfe");
  EXPECT_EQ(of("b.glb").license, "Ben");
}

TEST_F(Credits, OfWhatTheFileLeavesOpenAreTheModels) {
  write("m/model.config", "<model><author><name>Ada</name></author></model>");
  write("m/meshes/a.dae",
        "<COLLADA><asset><contributor><copyright>CC0</copyright></contributor></asset></COLLADA>");
  const Credit credit = of("m/meshes/a.dae");
  EXPECT_EQ(credit.author, "Ada");
  EXPECT_EQ(credit.license, "CC0");
  EXPECT_EQ(below(credit.author_in), "m/model.config");
}

TEST_F(Credits, OfAPackageAreItsAuthorsElseItsMaintainers) {
  write("one/package.xml",
        "<package><name>one</name><maintainer email='x'>Cleo</maintainer><author>Ada</author>"
        "<license>BSD</license><license>MIT</license></package>");
  write("two/package.xml", "<package><maintainer email='x'>Cleo</maintainer></package>");
  EXPECT_EQ(of("one/models/x/mesh.stl").author, "Ada");
  EXPECT_EQ(of("one/models/x/mesh.stl").license, "BSD; MIT");
  EXPECT_EQ(of("two/models/x/mesh.stl").author, "Cleo");
}

TEST_F(Credits, MayBeAFileCalledLicense) {
  write("worlds/LICENSE", "MIT License ...");
  write("worlds/hall/hall.world", "");
  const Credit credit = of("worlds/hall/hall.world");
  EXPECT_EQ(credit.license, "LICENSE");
  EXPECT_EQ(below(credit.license_in), "worlds/LICENSE");
  EXPECT_EQ(credit.author, "");
}

TEST_F(Credits, AreNotThoseOfFoldersFarAbove) {
  write("LICENSE", "");
  EXPECT_EQ(of("1/2/3/4/5/near.stl").license, "LICENSE");
  EXPECT_TRUE(of("1/2/3/4/5/6/far.stl").license_in.empty());
}

TEST_F(Credits, OfDamagedFilesAreNone) {
  write("model.config", "<model><author>");
  write("package.xml", "");
  write("a.dae", "<COLLADA><asset><contributor>");
  write("b.gltf", R"({"asset": {"copyright": )");
  write("c.gltf", R"({"asset": 5})");
  write("d.glb", "");
  for (const char* file : {"a.dae", "b.gltf", "c.gltf", "d.glb", "missing.dae"}) {
    EXPECT_EQ(of(file).author, "") << file;
    EXPECT_EQ(of(file).license, "") << file;
  }
}

}  // namespace credit_test
}  // namespace synthetic_dataset::run
