// Materials in OGRE's scripts, and what they inherit from one another.
#include "fuzzing.h"
#include "world/material/ogre_inheritance.h"
#include "world/material/ogre_material.h"
#include "world/material/ogre_script.h"

namespace {

using namespace synthetic_dataset;

const world::OgreObject* findIn(const world::OgreScript& script, const std::string& kind,
                                const std::string& name) {
  for (const world::OgreObject& object : script.objects) {
    if (object.kind == kind && object.name == name) return &object;
  }
  return nullptr;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzzing::tolerating([&] {
    const auto script = world::parseOgreScript(std::string(fuzzing::view(data, size)));
    for (const world::OgreObject& object : script.objects) {
      if (object.kind != "material") continue;
      fuzzing::tolerating([&] {
        world::OgreObject material =
            world::withInherited(object, [&](const std::string& kind, const std::string& name) {
              return findIn(script, kind, name);
            });
        world::replaceVariables(material);
        static_cast<void>(world::readOgreMaterial(material));
      });
    }
  });
  return 0;
}
