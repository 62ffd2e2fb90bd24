#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::world {

/// A line of an OGRE script, such as `diffuse 1 0 0`.
struct OgreProperty {
  std::string name;
  std::vector<std::string> values;
  int line = 0;
};

/// A section of an OGRE script: `material Name : Parent { ... }`, optionally preceded by
/// `abstract`.
struct OgreObject {
  std::string kind;  ///< "material", "technique", "pass", "texture_unit", ...
  std::string name;  ///< may be empty
  std::vector<std::string> parents;
  int line = 0;
  std::vector<OgreProperty> properties;  ///< a later one overrides an earlier one of the same name
  std::vector<OgreObject> objects;
};

struct OgreScript {
  std::vector<std::string> imports;  ///< files: `import Name, Other from "file"`
  std::vector<OgreObject> objects;
};

/// Parses the syntax of OGRE 1.x scripts (manual, "Material Scripts" and "Script Inheritance"),
/// whatever kinds of section they contain.
/// @throws Error "line 7: '}' without a '{' before it"
[[nodiscard]] OgreScript parseOgreScript(const std::string& text);

/// Replaces variables (`set $name value`) by their values. Inner sections see the variables of
/// outer ones; a child's variables hide its parents'.
/// @throws Error "line 7: the variable '$name' has no value"
void replaceVariables(OgreObject& object);

}  // namespace synthetic_dataset::world
