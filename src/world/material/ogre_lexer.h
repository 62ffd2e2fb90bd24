#pragma once

#include <string>
#include <vector>

namespace synthetic_dataset::world {

enum class OgreTokenKind { kWord, kQuoted, kOpen, kClose, kColon, kLineEnd };

struct OgreToken {
  OgreTokenKind kind = OgreTokenKind::kWord;
  std::string text;  ///< of words, without quotes
  int line = 0;
};

/// An OGRE script in words, braces, colons and line ends; comments are gone. As in OGRE, a colon or
/// a comment counts as such only where a word could begin, so that `http://x` is one word.
/// @throws Error "line 7: a quoted name without its end"
[[nodiscard]] std::vector<OgreToken> readOgreTokens(const std::string& text);

}  // namespace synthetic_dataset::world
