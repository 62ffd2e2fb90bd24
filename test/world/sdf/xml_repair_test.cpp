#include "world/sdf/xml_repair.h"

#include <gmock/gmock.h>
#include <tinyxml2.h>

#include "world/sdf/sdf_loader_support.h"

namespace synthetic_dataset::world {
namespace xml_repair_test {

using namespace test;

TEST(XmlRepair, QuotesAttributes) {
  EXPECT_EQ(repairedXml("<a b=c d = 'e=f'><g h=1/></a>"), "<a b=\"c\" d = 'e=f'><g h=\"1\"/></a>");
}

TEST(XmlRepair, LeavesTextCommentsAndQuotesAlone) {
  const std::string text = "<a b='x>y=z'>c=d<!-- e=f <g h=i> --><![CDATA[ j=k <l m=n> ]]></a>";
  EXPECT_EQ(repairedXml(text), text);
}

TEST(XmlRepair, BlanksADeclarationAndKeepsLines) {
  EXPECT_EQ(repairedXml("<!-- a\n -->\n<?xml\nversion='1.0'?>\n<b/>"),
            "<!-- a\n -->\n     \n               \n<b/>");
}

TEST(XmlRepair, SurvivesWhatEndsTooSoon) {
  for (const std::string text :
       {"<a b=", "<a b=\"c", "<!-- a", "<![CDATA[ a", "<?xml", "<", "<a b=c"}) {
    EXPECT_EQ(repairedXml(text).substr(0, 1), "<") << text;
  }
}

TEST(SdfLoader, ReadsXmlAsGazebosParserDoes) {
  const TemporaryFolder folder;
  const std::string world =
      worldFile("<model name=m><link name=body>" + visualElement(kBox) + "</link></model>");
  const Description read = loadText(folder, "<!-- licence -->\n<?xml version='1.0'?>" + world);
  EXPECT_EQ(read.models.at(0).name, "m");
  EXPECT_THAT(read.models.at(0).links.at(0).visuals, SizeIs(1));
}

}  // namespace xml_repair_test
}  // namespace synthetic_dataset::world
