#include "world/mesh/collada_repair.h"

#include <tinyxml2.h>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

bool isEmpty(const tinyxml2::XMLElement* element) {
  return element == nullptr || (element->GetText() == nullptr && element->NoChildren());
}

/// @return whether the image had no picture
bool mend(tinyxml2::XMLElement& image) {
  tinyxml2::XMLElement* from = image.FirstChildElement("init_from");
  if (!isEmpty(from) || !isEmpty(image.FirstChildElement("data"))) return false;
  if (from == nullptr) {
    from = image.GetDocument()->NewElement("init_from");
    image.InsertEndChild(from);
  }
  from->SetText(kNoPicture);
  return true;
}

}  // namespace

void checkCollada(const std::filesystem::path& file) {
  tinyxml2::XMLDocument document;
  if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) {
    throw Error("cannot be read: line " + std::to_string(document.ErrorLineNum()) +
                " is not XML (" + document.ErrorName() + ")");
  }
  if (document.FirstChildElement("COLLADA") == nullptr) {
    throw Error("cannot be read: it has no <COLLADA> element");
  }
}

std::optional<std::string> withPictureNames(const std::filesystem::path& file) {
  tinyxml2::XMLDocument document;
  if (document.LoadFile(file.c_str()) != tinyxml2::XML_SUCCESS) return std::nullopt;
  tinyxml2::XMLElement* root = document.FirstChildElement("COLLADA");
  tinyxml2::XMLElement* library =
      root != nullptr ? root->FirstChildElement("library_images") : nullptr;
  bool mended = false;
  for (; library != nullptr; library = library->NextSiblingElement("library_images")) {
    for (auto* image = library->FirstChildElement("image"); image != nullptr;
         image = image->NextSiblingElement("image")) {
      mended = mend(*image) || mended;
    }
  }
  if (!mended) return std::nullopt;
  tinyxml2::XMLPrinter printer;
  document.Print(&printer);
  return std::string(printer.CStr());
}

}  // namespace synthetic_dataset::world
