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

/// A bag whose content can be read only by librosbag's plugins, and only with the key.
class EncryptedBag : public Error {
 public:
  using Error::Error;
};

/// Where a message lies in the file: a message that was written earlier has a smaller number.
using MessagePlace = std::uint64_t;

/// The places of each connection's messages, in the order of their record times.
using MessagePlaces = std::map<std::uint32_t, std::vector<MessagePlace>>;

/// Checks a bag's records against the file before librosbag (1.15) reads it: librosbag trusts every
/// length and offset, and reads beyond its buffers, never ends or uses up all memory if they are
/// wrong. Bags without an index pass, as librosbag reports these itself.
/// @return the places of the messages that are going to be read; empty for a bag of version 1.2
/// @throws EncryptedBag
/// @throws Error saying what is wrong
MessagePlaces checkBag(const std::string& file, const TopicFilter& is_read);

}  // namespace synthetic_dataset::motion
