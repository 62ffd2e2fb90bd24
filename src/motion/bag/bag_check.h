#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::motion {

/// Whether the messages of a topic are going to be read.
using TopicFilter = std::function<bool(const std::string& topic)>;

/// A bag whose content only librosbag's plugins, and those who have the key, can read.
class EncryptedBag : public Error {
 public:
  using Error::Error;
};

/// Where a message lies in the file: of two, the one that was written first has the smaller number.
using MessagePlace = std::uint64_t;

/// The places of a connection's messages, in the order of their record times; by connection.
using MessagePlaces = std::map<std::uint32_t, std::vector<MessagePlace>>;

/// Holds a bag's records against the file before librosbag (1.15) reads it: that takes every
/// length and place for true, and reads beyond its buffers, never ends or takes all memory where
/// they are not. Bags without an index pass, as librosbag says so itself.
/// @return where the messages lie that are going to be read; nothing for a bag of version 1.2
/// @throws EncryptedBag
/// @throws Error with what is wrong
MessagePlaces checkBag(const std::string& file, const TopicFilter& is_read);

}  // namespace synthetic_dataset::motion
