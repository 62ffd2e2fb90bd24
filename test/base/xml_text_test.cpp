#include "base/xml_text.h"

#include <string>

#include <gtest/gtest.h>

namespace synthetic_dataset::base {
namespace xml_text_test {

std::string elementWith(int attributes, const std::string& before = "") {
  std::string text = before + "<a";
  for (int i = 0; i < attributes; ++i) text += " b" + std::to_string(i) + "='>\"'";
  return text + "/>";
}

std::string faultOf(const std::string& text) {
  tinyxml2::XMLDocument document;
  const auto fault = parseXml(document, text);
  return fault ? fault->text() : "";
}

TEST(XmlText, RefusesAnElementOfTooManyAttributes) {
  EXPECT_EQ("", faultOf(elementWith(1000)));
  EXPECT_EQ("line 3: cannot be read as XML (an element has more than 1000 attributes)",
            faultOf(elementWith(1001, "<!-- <b \" -->\n<?x '?>\n")));
  EXPECT_NE("", faultOf(elementWith(200000)));  // tinyxml2 would take minutes
  EXPECT_NE("", faultOf("<r><![CDATA[<x ' ]]>" + elementWith(2000) + "</r>"));
}

TEST(XmlText, SaysWhatIsNoXml) {
  EXPECT_EQ("line 2: cannot be read as XML (XML_ERROR_MISMATCHED_ELEMENT)", faultOf("\n<a></b>"));
  EXPECT_EQ("cannot be read as XML (XML_ERROR_EMPTY_DOCUMENT)", faultOf(""));
}

TEST(XmlText, ExpandsEntitiesNextToOneAnother) {
  tinyxml2::XMLDocument document;
  const std::string type = "<!DOCTYPE a [<!ENTITY none ''><!ENTITY one 'x'>]>";
  EXPECT_FALSE(parseXml(document, type + "<a>&none;&none;&one;&one;&lt;</a>"));
  EXPECT_STREQ("xx<", document.RootElement()->GetText());
}

TEST(XmlText, RefusesWhatNestsWithoutBound) {
  std::string text;
  for (int i = 0; i < 50000; ++i) text += "<a>";
  EXPECT_NE(std::string::npos, faultOf(text).find("DEPTH_EXCEEDED")) << faultOf(text);
}

}  // namespace xml_text_test
}  // namespace synthetic_dataset::base
