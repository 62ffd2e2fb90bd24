#include "world/material/ogre_script.h"

#include <gmock/gmock.h>

#include "support/error_messages.h"
#include "synthetic_dataset/errors.h"
#include "world/material/ogre_inheritance.h"
#include "world/material/ogre_properties.h"

namespace synthetic_dataset::world {
namespace ogre_script_test {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

std::string errorOf(const std::string& text) {
  try {
    static_cast<void>(parseOgreScript(text));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// The named material of a script, with what it inherits and with its variables replaced.
OgreObject resolved(const std::string& text, const std::string& name) {
  const OgreScript script = parseOgreScript(text);
  const auto look_up = [&](const std::string& kind, const std::string& wanted) {
    const OgreObject* found = nullptr;
    for (const OgreObject& object : script.objects) {
      if (object.kind == kind && object.name == wanted) found = &object;
    }
    return found;
  };
  OgreObject object = withInherited(*look_up("material", name), look_up);
  replaceVariables(object);
  return object;
}

const OgreObject& pass(const OgreObject& material) { return material.objects.at(0).objects.at(0); }

TEST(OgreScript, ReadsSectionsWhereverTheirBracesStand) {
  const OgreScript script = parseOgreScript(
      "material A/B\n{\n  technique {\n pass main\n\n {\n diffuse 1 0 0 } } }\nmaterial C { }");
  ASSERT_THAT(script.objects, SizeIs(2));
  EXPECT_EQ(script.objects[0].name, "A/B");
  EXPECT_EQ(pass(script.objects[0]).name, "main");
  EXPECT_THAT(propertyOf(pass(script.objects[0]), "diffuse")->values, ElementsAre("1", "0", "0"));
}

TEST(OgreScript, ReadsPastComments) {
  const OgreScript script = parseOgreScript(
      "// material X\n/* {\n} */ material A // {\n{ texture http://a/b.png // c\n}");
  ASSERT_THAT(script.objects, SizeIs(1));
  EXPECT_THAT(script.objects[0].properties.at(0).values, ElementsAre("http://a/b.png"));
}

TEST(OgreScript, ReadsQuotedNames) {
  const OgreScript script = parseOgreScript("material \"My Name\" : \"The Parent\" { a \"b c\" }");
  EXPECT_EQ(script.objects.at(0).name, "My Name");
  EXPECT_THAT(script.objects.at(0).parents, ElementsAre("The Parent"));
  EXPECT_THAT(script.objects.at(0).properties.at(0).values, ElementsAre("b c"));
}

TEST(OgreScript, ReadsWindowsLineEnds) {
  const OgreScript script = parseOgreScript("\xEF\xBB\xBFmaterial A\r\n{\r\n  a 1\r\n}\r\n");
  EXPECT_THAT(script.objects.at(0).properties.at(0).values, ElementsAre("1"));
}

TEST(OgreScript, ReadsImports) {
  const OgreScript script = parseOgreScript("import * from \"a.material\"\nimport B, C from b");
  EXPECT_THAT(script.imports, ElementsAre("a.material", "b"));
}

TEST(OgreScript, TellsTheLineOfAFault) {
  EXPECT_THAT(errorOf("material A\n{\n}\n}\n"), HasSubstr("line 4: '}'"));
  EXPECT_THAT(errorOf("\nmaterial A\n{\n technique\n {\n }\n"),
              AllOf(HasSubstr("line 2"), HasSubstr("'material A' has no '}'")));
  EXPECT_THAT(errorOf("{\n"), HasSubstr("line 1: found '{'"));
  EXPECT_THAT(errorOf("a\nb \"c\n"), HasSubstr("line 2: an unclosed quoted name"));
  EXPECT_THAT(errorOf("/* a\n"), HasSubstr("line 1: a comment"));
  EXPECT_THAT(errorOf("import A\n"), HasSubstr("line 1: an import should read"));
}

TEST(OgreScript, RefusesSectionsWithoutEnd) {
  std::string text;
  for (int i = 0; i < 100000; ++i) text += "a {";
  EXPECT_THAT(errorOf(text), HasSubstr("nested too deep"));
}

TEST(OgreInheritance, ChangesUnnamedSectionsInTheirPlace) {
  const OgreObject object = resolved(
      "material Parent { technique { pass { diffuse 1 0 0\n specular 1 1 1 5 } } }\n"
      "material Child : Parent { technique { pass { diffuse 0 1 0 } } }",
      "Child");
  ASSERT_THAT(object.objects, SizeIs(1));
  EXPECT_THAT(propertyOf(pass(object), "diffuse")->values, ElementsAre("0", "1", "0"));
  EXPECT_THAT(propertyOf(pass(object), "specular")->values, SizeIs(4));
}

TEST(OgreInheritance, MatchesNamedSectionsByNameAndAddsOthers) {
  const OgreObject object = resolved(
      "material Parent { technique { pass a { diffuse 1 0 0 } pass b { } } }\n"
      "material Child : Parent { technique { pass b { diffuse 0 1 0 } pass c { } } }",
      "Child");
  const OgreObject& technique = object.objects.at(0);
  ASSERT_THAT(technique.objects, SizeIs(3));
  EXPECT_THAT(propertyOf(technique.objects[1], "diffuse")->values, ElementsAre("0", "1", "0"));
  EXPECT_EQ(technique.objects[2].name, "c");
}

TEST(OgreInheritance, TakesInnerSectionsOfAbstractOnes) {
  const OgreObject object = resolved(
      "abstract pass Shiny { specular 1 1 1 50 }\n"
      "material A { technique { pass : Shiny { diffuse 1 0 0 } } }",
      "A");
  EXPECT_EQ(wordOf(pass(object), "specular", 3), "50");
  EXPECT_EQ(wordOf(pass(object), "diffuse"), "1");
}

TEST(OgreInheritance, LetsChildrenSetVariables) {
  const OgreObject object = resolved(
      "abstract material Base { set $colour \"1 0 0\"\n set $size 2\n"
      "technique { pass { diffuse $colour\n texture_unit { scale $size $size } } } }\n"
      "material A : Base { set $colour \"0 0 1\" }",
      "A");
  EXPECT_THAT(propertyOf(pass(object), "diffuse")->values, ElementsAre("0", "0", "1"));
  EXPECT_THAT(propertyOf(pass(object).objects.at(0), "scale")->values, ElementsAre("2", "2"));
}

TEST(OgreInheritance, TellsOfParentsThatAreNotThereAndOfCircles) {
  EXPECT_THAT(test::messagesOf([] { resolved("\nmaterial A : B { }", "A"); }),
              testing::ElementsAre(
                  HasSubstr("line 2: material 'A' inherits from 'B', which is not there")));
  EXPECT_THAT(test::messagesOf([] { resolved("material A : B { }\nmaterial B : A { }", "A"); }),
              testing::ElementsAre(HasSubstr("in turn")));
  EXPECT_THAT(test::messagesOf([] { resolved("material A { x $y }", "A"); }),
              testing::ElementsAre(HasSubstr("line 1: the variable '$y' has no value")));
}

TEST(OgreVariables, RefusesOnesThatMultiplyAProperty) {
  std::string words;
  std::string uses;
  for (int i = 0; i < 1000; ++i) words += " 1";
  for (int i = 0; i < 1000; ++i) uses += " $a";
  EXPECT_THAT(test::messagesOf([&] {
                resolved("material A { set $a \"" + words + "\"\n x" + uses + " }", "A");
              }),
              testing::ElementsAre(HasSubstr("give 'x' more than 1000 values")));
}

TEST(OgreInheritance, RefusesMaterialsThatMultiplyOneAnother) {
  std::string text = "material m0 { }\n";
  for (int i = 1; i <= 30; ++i) {
    const std::string parent = " m" + std::to_string(i - 1);
    text += "material m" + std::to_string(i) + " :" + parent + parent + " { }\n";
  }
  EXPECT_THAT(test::messagesOf([&] { resolved(text, "m30"); }),
              testing::ElementsAre(
                  AllOf(HasSubstr("line "), HasSubstr("more than 10000 sections and properties"))));
}

TEST(OgreInheritance, RefusesChainsThatAreTooLong) {
  std::string text = "material m0 { }\n";
  for (int i = 1; i <= 5000; ++i) {
    text += "material m" + std::to_string(i) + " : m" + std::to_string(i - 1) + " { }\n";
  }
  EXPECT_NO_THROW(resolved(text, "m100"));
  EXPECT_THAT(test::messagesOf([&] { resolved(text, "m5000"); }),
              testing::ElementsAre(AllOf(HasSubstr("line 4901: material 'm4900'"),
                                         HasSubstr("a chain of more than 100"))));
}

}  // namespace ogre_script_test
}  // namespace synthetic_dataset::world
