#include "world/material/ogre_material.h"

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "world/material/material_conversions.h"

namespace synthetic_dataset::world {
namespace ogre_material_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

OgreMaterial read(const std::string& material) {
  return readOgreMaterial(parseOgreScript("material A {" + material + "}").objects.at(0));
}

OgreMaterial readPass(const std::string& pass) {
  return read("technique { pass {\n" + pass + "\n} }");
}

std::string pictureOf(const OgreMaterial& material) {
  return material.source.texture ? material.source.texture->uri : "none";
}

TEST(OgreMaterial, ReadsColours) {
  const Material found =
      readPass("ambient 0 0 1\ndiffuse .1 .2 .3\nspecular 0.4 0.5 0.6 1 12.5\nemissive 0 1 0")
          .source.material;
  EXPECT_TRUE(found.diffuse.isApprox(Eigen::Vector4f(0.1F, 0.2F, 0.3F, 1)));
  EXPECT_TRUE(found.specular.isApprox(Eigen::Vector3f(0.4F, 0.5F, 0.6F)));
  EXPECT_TRUE(found.emissive.isApprox(Eigen::Vector3f(0, 1, 0)));
  // Walter et al.: an exponent of 12.5 means an alpha of sqrt(2 / 14.5), the squared roughness.
  EXPECT_NEAR(found.roughness * found.roughness, 0.3714F, 1e-4F);
}

TEST(OgreMaterial, ReadsSpecularWithoutAlpha) {
  const Material found = readPass("specular 1 1 1 128").source.material;
  EXPECT_FLOAT_EQ(found.roughness, roughnessOfShininess(128));
  EXPECT_EQ(found.shininess, 128.0F);
}

TEST(OgreMaterial, HasAnAmbientColourOfItsOwn) {
  const Material found = readPass("ambient 0 0.5 1\ndiffuse .1 .2 .3").source.material;
  EXPECT_EQ(found.ambient, Eigen::Vector3f(0, 0.5F, 1));
  EXPECT_EQ(readPass("diffuse .1 .2 .3").source.material.ambient, Eigen::Vector3f(1, 1, 1));
}

/// This is how the lines of a playing field are drawn.
TEST(OgreMaterial, HasItsBlendedPassesAsOverlays) {
  const MaterialSource found =
      read(
          "technique { pass { texture_unit {\ntexture grass.png\n} }\n"
          "pass { scene_blend alpha_blend\nlighting off\n"
          "texture_unit {\ntexture lines.png\n} }\n"
          "pass { scene_blend alpha_blend\ntexture_unit {\ntexture dirt.png\n} }\n"
          "pass { scene_blend alpha_blend\npolygon_mode wireframe\n} }")
          .source;
  EXPECT_EQ(found.texture->uri, "grass.png");
  ASSERT_TRUE(found.overlay);
  EXPECT_EQ(found.overlay->texture->uri, "lines.png");
  EXPECT_FALSE(found.overlay->material.lit);
  EXPECT_TRUE(found.overlay->material.texture_is_glass);
  EXPECT_EQ(found.overlay->texture->alpha, AlphaMeaning::kOpacity);
  ASSERT_TRUE(found.overlay->overlay);
  EXPECT_EQ(found.overlay->overlay->texture->uri, "dirt.png");
  EXPECT_TRUE(found.overlay->overlay->material.lit);
  EXPECT_FALSE(found.overlay->overlay->overlay);
}

TEST(OgreMaterial, IsWhiteWithoutHighlightWhereNothingIsSaid) {
  const Material found = readPass("").source.material;
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(1, 1, 1, 1));
  EXPECT_EQ(found.specular, Eigen::Vector3f(0, 0, 0));
}

TEST(OgreMaterial, LeavesVertexColoursTheirPlace) {
  EXPECT_EQ(readPass("diffuse vertexcolour").source.material.diffuse, Eigen::Vector4f(1, 1, 1, 1));
}

TEST(OgreMaterial, MeansAlphaOnlyWhereItBlends) {
  EXPECT_EQ(readPass("diffuse 1 0 0 0.25").source.material.diffuse.w(), 1.0F);
  const OgreMaterial blended =
      readPass("scene_blend alpha_blend\ndiffuse 1 0 0 0.25\ntexture_unit { texture a.png }");
  EXPECT_EQ(blended.source.material.diffuse.w(), 0.25F);
  EXPECT_TRUE(blended.source.material.texture_is_glass);
  EXPECT_EQ(blended.source.texture->alpha, AlphaMeaning::kOpacity);
}

TEST(OgreMaterial, RejectsAlphaBelowItsThreshold) {
  const OgreMaterial found =
      readPass("alpha_rejection greater 51\ncull_hardware none\ntexture_unit { texture a.png }");
  EXPECT_FLOAT_EQ(found.source.material.alpha_threshold, 0.2F);
  EXPECT_FALSE(found.source.material.texture_is_glass);
  EXPECT_EQ(found.source.texture->alpha, AlphaMeaning::kOpacity);
  EXPECT_TRUE(found.source.material.double_sided);
}

TEST(OgreMaterial, ShowsItsPictureAloneWhereUnlit) {
  const Material found = readPass("lighting off\ndiffuse 1 0 0\nemissive 1 1 1").source.material;
  EXPECT_FALSE(found.lit);
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(1, 1, 1, 1));
}

TEST(OgreMaterial, TakesColoursOfOperations) {
  const Material found = readPass(
                             "lighting off\nscene_blend alpha_blend\ntexture_unit {\n"
                             "colour_op_ex source1 src_manual src_current 1 0 0\n"
                             "alpha_op_ex source1 src_manual src_current 0.5\n}")
                             .source.material;
  EXPECT_EQ(found.diffuse, Eigen::Vector4f(1, 0, 0, 0.5F));
}

TEST(OgreMaterial, TakesTheFirstPictureThatIsNoReflection) {
  EXPECT_EQ(pictureOf(readPass("texture_unit { texture env.png\n env_map spherical }\n"
                               "texture_unit { texture \"my wall.png\" 2d }\n"
                               "texture_unit { texture light.png }")),
            "my wall.png");
}

TEST(OgreMaterial, TellsNormalMapsByTheirUnitsNames) {
  const OgreMaterial found = readPass(
      "texture_unit normalMap { texture n.png }\ntexture_unit diffuseMap { texture d.png }");
  EXPECT_EQ(pictureOf(found), "d.png");
  ASSERT_TRUE(found.source.normal_map);
  EXPECT_EQ(found.source.normal_map->uri, "n.png");
}

TEST(OgreMaterial, ReadsTheShaderGeneratorsNormalMap) {
  const OgreMaterial found =
      readPass("rtshader_system { lighting_stage normal_map n.png tangent_space 0 }");
  ASSERT_TRUE(found.source.normal_map);
  EXPECT_EQ(found.source.normal_map->uri, "n.png");
}

TEST(OgreMaterial, ReplacesAliases) {
  const OgreMaterial found = read(
      "set_texture_alias Skin b.png\n"
      "technique { pass { texture_unit { texture_alias Skin\n texture a.png } } }");
  EXPECT_EQ(pictureOf(found), "b.png");
}

TEST(OgreMaterial, TakesAnAnimationsFirstFrame) {
  EXPECT_EQ(pictureOf(readPass("texture_unit { anim_texture fire.png 4 2.5 }")), "fire_0.png");
  EXPECT_EQ(pictureOf(readPass("texture_unit { anim_texture a.png b.png 1 }")), "a.png");
}

TEST(OgreMaterial, ScalesPicturesAboutTheirMiddle) {
  const Material found =
      readPass("texture_unit { texture a.png\n scale 0.5 2\n scroll 0.25 0 }").source.material;
  // Half as wide, so twice as many; only the scroll moves the middle.
  EXPECT_EQ(found.texture_scale, Eigen::Vector2f(2.0F, 0.5F));
  const Eigen::Vector2f middle(0.5F, 0.5F);
  const Eigen::Vector2f placed = middle.cwiseProduct(found.texture_scale) + found.texture_offset;
  EXPECT_EQ(placed, Eigen::Vector2f(0.75F, 0.5F));
}

TEST(OgreMaterial, TakesTheLastPassThatCovers) {
  const OgreMaterial found = read(
      "technique { pass { ambient 1 1 1 } pass { diffuse 1 0 0\n texture_unit { texture a.png "
      "} } pass { scene_blend add\n diffuse 0 1 0\n texture_unit { texture b.png } } }");
  EXPECT_EQ(pictureOf(found), "a.png");
  EXPECT_EQ(found.source.material.diffuse, Eigen::Vector4f(1, 0, 0, 1));
  EXPECT_THAT(found.notes, IsEmpty());
}

TEST(OgreMaterial, PassesOverTechniquesOfSchemes) {
  EXPECT_EQ(pictureOf(read("technique { scheme GBuffer\n pass { texture_unit { texture a.png } } }"
                           "technique { pass { texture_unit { texture b.png } } }")),
            "b.png");
}

TEST(OgreMaterial, ReadsPastShaderPrograms) {
  EXPECT_EQ(pictureOf(readPass("vertex_program_ref X { param_named a float 1 }\n"
                               "texture_unit { texture a.png\n tex_address_mode clamp }")),
            "a.png");
}

TEST(OgreMaterial, TakesNoNormalMapOfAShaderForItsColour) {
  const OgreMaterial water = readPass(
      "fragment_program_ref Waves { param_named deepColor float4 0 0.05 0.2 1\n"
      "param_named shallowColor float4 0 0.6 1 1\n"
      "param_named bumpMap int 0\n param_named cubeMap int 1 }\n"
      "texture_unit { texture waves.dds\n scale 0.5 0.5 }\n texture_unit { texture sky.jpg }");
  EXPECT_EQ(pictureOf(water), "none");
  ASSERT_TRUE(water.source.normal_map);
  EXPECT_EQ(water.source.normal_map->uri, "waves.dds");
  EXPECT_TRUE(water.source.material.diffuse.isApprox(Eigen::Vector4f(0, 0.05F, 0.2F, 1)));
  EXPECT_EQ(water.source.material.texture_scale, Eigen::Vector2f(2, 2));
}

TEST(OgreMaterial, KnowsNormalMapsOfShadersByTheirFilesToo) {
  const OgreMaterial found = readPass(
      "fragment_program_ref X { param_named a float 1 }\n"
      "texture_unit { texture rock.png }\n texture_unit { texture rock_Normal.png }");
  EXPECT_EQ(pictureOf(found), "rock.png");
  EXPECT_EQ(found.source.normal_map->uri, "rock_Normal.png");
  EXPECT_FALSE(found.source.factor);
}

TEST(OgreMaterial, MultipliesASecondPicture) {
  const OgreMaterial table =
      readPass("texture_unit { texture marble.png }\n texture_unit { texture baked.png }");
  EXPECT_EQ(pictureOf(table), "marble.png");
  ASSERT_TRUE(table.source.factor);
  EXPECT_EQ(table.source.factor->uri, "baked.png");
}

TEST(OgreMaterial, MultipliesNoPictureThatLiesElsewhereOrReplaces) {
  for (const char* more : {"scale 2 2", "tex_coord_set 1", "colour_op replace",
                           "colour_op_ex add src_texture src_current"}) {
    EXPECT_FALSE(readPass("texture_unit { texture a.png }\n texture_unit { texture b.png\n" +
                          std::string(more) + "\n}")
                     .source.factor)
        << more;
  }
}

TEST(OgreMaterial, NotesWhatItCannotDraw) {
  EXPECT_THAT(readPass("scene_blend add\ndiffuse 1 1 1").notes,
              ElementsAre(HasSubstr("scene_blend 'add'")));
}

TEST(OgreMaterial, TellsOfNumbersThatAreNone) {
  const auto messages = [](const char* pass) { return test::messagesOf([&] { readPass(pass); }); };
  EXPECT_THAT(messages("diffuse 1 red 0"),
              ElementsAre(HasSubstr("line 2: diffuse: found '1 red 0'")));
  EXPECT_THAT(messages("specular 1"), ElementsAre(HasSubstr("3 numbers or more")));
  EXPECT_THAT(messages("texture_unit { texture a.png\n scale 0 1 }"),
              ElementsAre(HasSubstr("scale: neither may be 0")));
}

}  // namespace ogre_material_test
}  // namespace synthetic_dataset::world
