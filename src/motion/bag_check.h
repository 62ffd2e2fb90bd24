#pragma once

#include <functional>
#include <string>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

/// Whether the messages of a topic are going to be read.
using TopicFilter = std::function<bool(const std::string& topic)>;

/// A bag whose content only librosbag's plugins, and those who have the key, can read.
class EncryptedBag : public Error {
 public:
  using Error::Error;
};

/// Holds a bag's records against the file before librosbag (1.15) reads it: that takes every
/// length and place for true, and reads beyond its buffers, never ends or takes all memory where
/// they are not. Bags without an index pass, as librosbag says so itself.
/// @throws EncryptedBag
/// @throws Error with what is wrong
void checkBag(const std::string& file, const TopicFilter& is_read);

}  // namespace synthetic_dataset::motion
