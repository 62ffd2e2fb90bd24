#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// A line of an OGRE script: `diffuse 1 0 0` in an object.
struct OgreProperty {
  std::string name;
  std::vector<std::string> values;
  int line = 0;
};

/// A section of an OGRE script: `material Name : Parent { ... }`, with `abstract` before it or not.
struct OgreObject {
  std::string kind;  ///< "material", "technique", "pass", "texture_unit", ...
  std::string name;  ///< may be empty
  std::vector<std::string> parents;
  int line = 0;
  std::vector<OgreProperty> properties;  ///< a later one of the same name takes an earlier's place
  std::vector<OgreObject> objects;
};

struct OgreScript {
  std::vector<std::string> imports;  ///< files: `import Name, Other from "file"`
  std::vector<OgreObject> objects;
};

/// Reads the syntax of OGRE 1.x scripts (manual, "Material Scripts" and "Script Inheritance"),
/// whatever the sections are.
/// @throws Error "line 7: '}' without a '{' before it"
[[nodiscard]] OgreScript parseOgreScript(const std::string& text);

/// Puts the values of variables (`set $name value`) in the places of their names. Inner sections
/// see the variables of outer ones, and a child's hide its parents'.
/// @throws Error "line 7: the variable '$name' has no value"
void replaceVariables(OgreObject& object);

}  // namespace synthetic_dataset::world
