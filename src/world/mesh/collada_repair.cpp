#include "world/mesh/collada_repair.h"

#include <string_view>

#include <tinyxml2.h>

#include "base/input_file.h"
#include "base/xml_text.h"
#include "synthetic_dataset/errors.h"
#include "world/files/text.h"

namespace synthetic_dataset::world {
namespace {

using tinyxml2::XMLElement;
using tinyxml2::XMLNode;

bool isEmpty(const XMLElement* element) {
  return element == nullptr || (element->GetText() == nullptr && element->NoChildren());
}

/// Repairs one document.
class ColladaMender {
 public:
  /// Visits all elements without recursion, as files may nest them arbitrarily deep.
  bool mend(XMLElement& root) {
    XMLNode* node = &root;
    while (node != nullptr) {
      if (XMLElement* element = node->ToElement()) mendElement(*element);
      XMLNode* next = node->FirstChild();
      while (next == nullptr && node != &root) {
        next = node->NextSibling();
        node = node->Parent();
      }
      node = next;
    }
    return mended_;
  }

 private:
  void mendElement(XMLElement& element) {
    dropComments(element);
    for (XMLNode* child = element.FirstChild(); child != nullptr; child = child->NextSibling()) {
      if (tinyxml2::XMLText* text = child->ToText()) trim(*text);
    }
    const std::string_view name = element.Name();
    if (name == "image") nameAPicture(element);
    if (name == "node" && element.FirstChildElement("matrix") != nullptr) keepOnlyMatrix(element);
  }

  void dropComments(XMLElement& element) {
    XMLNode* next = nullptr;
    for (XMLNode* child = element.FirstChild(); child != nullptr; child = next) {
      next = child->NextSibling();
      if (child->ToComment() != nullptr) drop(*child);
    }
  }

  void trim(tinyxml2::XMLText& text) {
    const std::string_view value = text.Value();
    constexpr std::string_view kBlanks = " \t\r\n";
    const auto isBlank = [&](char c) { return kBlanks.find(c) != std::string_view::npos; };
    if (value.empty() || !(isBlank(value.front()) || isBlank(value.back()))) return;
    const std::string trimmed_text = trimmed(std::string(value));
    text.SetValue(trimmed_text.c_str());
    mended_ = true;
  }

  void nameAPicture(XMLElement& image) {
    XMLElement* from = image.FirstChildElement("init_from");
    if (!isEmpty(from) || !isEmpty(image.FirstChildElement("data"))) return;
    if (from == nullptr) {
      from = image.GetDocument()->NewElement("init_from");
      image.InsertEndChild(from);
    }
    from->SetText(kNoPicture);
    mended_ = true;
  }

  void keepOnlyMatrix(XMLElement& node) {
    bool has_matrix = false;
    XMLElement* next = nullptr;
    for (XMLElement* child = node.FirstChildElement(); child != nullptr; child = next) {
      next = child->NextSiblingElement();
      const std::string_view name = child->Name();
      const bool is_matrix = name == "matrix";
      const bool moves = is_matrix || name == "translate" || name == "rotate" || name == "scale" ||
                         name == "skew" || name == "lookat";
      if (moves && (!is_matrix || has_matrix)) drop(*child);
      has_matrix = has_matrix || is_matrix;
    }
  }

  void drop(XMLNode& node) {
    node.Parent()->DeleteChild(&node);
    mended_ = true;
  }

  bool mended_ = false;
};

bool saysYUp(const XMLElement& root) {
  const XMLElement* asset = root.FirstChildElement("asset");
  const XMLElement* axis = asset != nullptr ? asset->FirstChildElement("up_axis") : nullptr;
  return axis != nullptr && axis->GetText() != nullptr && trimmed(axis->GetText()) == "Y_UP";
}

}  // namespace

ColladaText prepareCollada(const std::filesystem::path& file) {
  tinyxml2::XMLDocument document;
  if (const auto fault = base::parseXml(document, base::readInput(file))) {
    throw Error("cannot be read: line " + std::to_string(fault->line) + " is not XML (" +
                fault->reason + ")");
  }
  XMLElement* root = document.FirstChildElement("COLLADA");
  if (root == nullptr) throw Error("cannot be read: it has no <COLLADA> element");
  ColladaText result;
  result.y_up = saysYUp(*root);
  if (!ColladaMender().mend(*root)) return result;
  tinyxml2::XMLPrinter printer(nullptr, true);  // compact: no blanks around what was trimmed
  document.Print(&printer);
  result.mended = std::string(printer.CStr(), static_cast<std::size_t>(printer.CStrSize()) - 1);
  return result;
}

}  // namespace synthetic_dataset::world
