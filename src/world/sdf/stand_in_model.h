#pragma once

namespace tinyxml2 {
class XMLElement;
}

namespace synthetic_dataset::world {

/// Puts an empty model of the same name and pose in the place of an `<include>` that cannot be
/// followed, so that poses relative to it remain right, and takes out the joints of its unknown
/// links. Its only link is called kStandInLink. Where another model has the name, the include is
/// just taken out.
/// @param include  is deleted
void replaceByStandIn(tinyxml2::XMLElement& include);

}  // namespace synthetic_dataset::world
