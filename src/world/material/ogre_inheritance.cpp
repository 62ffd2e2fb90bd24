#include "world/material/ogre_inheritance.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

/// Real materials have dozens of sections and properties, and few ancestors. Anything beyond these
/// limits is taken for materials that multiply one another.
constexpr std::size_t kLargest = 10000;
constexpr std::size_t kDeepest = 100;

void addTo(OgreObject& base, OgreObject child);

std::string nameOf(const OgreObject& object) {
  return "line " + std::to_string(object.line) + ": " + object.kind + " '" + object.name + "' ";
}

/// The section of the base that a child's section changes: the one with its name or, if it has
/// none, with its index among those of its kind; null if it is a new one.
OgreObject* counterpart(OgreObject& base, const OgreObject& child, std::size_t index) {
  std::size_t count = 0;
  for (OgreObject& candidate : base.objects) {
    if (candidate.kind != child.kind) continue;
    const bool matches = child.name.empty() ? count == index : candidate.name == child.name;
    if (matches) return &candidate;
    ++count;
  }
  return nullptr;
}

void addTo(OgreObject& base, OgreObject child) {
  base.name = child.name.empty() ? base.name : child.name;
  base.line = child.line;
  for (OgreProperty& property : child.properties) base.properties.push_back(std::move(property));
  std::map<std::string, std::size_t> counts;  // of the child's unnamed sections, by kind
  std::vector<OgreObject> added;
  for (OgreObject& inner : child.objects) {
    const std::size_t index = inner.name.empty() ? counts[inner.kind]++ : 0;
    if (OgreObject* const changed = counterpart(base, inner, index)) {
      addTo(*changed, std::move(inner));
    } else {
      added.push_back(std::move(inner));
    }
  }
  std::move(added.begin(), added.end(), std::back_inserter(base.objects));
}

class Resolver {
 public:
  explicit Resolver(const OgreLookUp& lookUp) : lookUp_(lookUp) {}

  OgreObject resolve(const OgreObject& object) {
    size_ += 1 + object.properties.size();
    if (size_ > kLargest) {
      throw Error(nameOf(object) + "is too large: the material has more than " +
                  std::to_string(kLargest) + " sections and properties with all that it inherits");
    }
    OgreObject own = object;
    own.parents.clear();
    for (OgreObject& inner : own.objects) inner = resolve(inner);
    if (object.parents.empty()) return own;
    OgreObject result;
    result.kind = object.kind;
    for (const std::string& name : object.parents) addTo(result, parentOf(object, name));
    addTo(result, std::move(own));
    return result;
  }

 private:
  OgreObject parentOf(const OgreObject& object, const std::string& name) {
    const std::string what = nameOf(object) + "inherits from '" + name + "', ";
    const OgreObject* const parent = lookUp_(object.kind, name);
    if (parent == nullptr) throw Error(what + "which is not there");
    if (std::find(chain_.begin(), chain_.end(), parent) != chain_.end()) {
      throw Error(what + "which inherits from it in turn");
    }
    if (chain_.size() >= kDeepest) {
      throw Error(what + "the end of a chain of more than " + std::to_string(kDeepest) +
                  " that inherit from one another");
    }
    chain_.push_back(parent);
    OgreObject result = resolve(*parent);
    chain_.pop_back();
    return result;
  }

  const OgreLookUp& lookUp_;
  std::vector<const OgreObject*> chain_;  ///< the parents that are being resolved
  std::size_t size_ = 0;                  ///< sections and properties resolved up to now
};

}  // namespace

OgreObject withInherited(const OgreObject& object, const OgreLookUp& lookUp) {
  return Resolver(lookUp).resolve(object);
}

}  // namespace synthetic_dataset::world
