#pragma once

#include <algorithm>
#include <iterator>
#include <list>
#include <stdexcept>
#include <utility>

namespace synthetic_dataset {

/// A map that keeps the order in which keys were added, for JSON objects with few members: keys are
/// found by linear search. It replaces nlohmann::ordered_map, which releases before 3.9 (Ubuntu
/// 20.04) lack, and has what `nlohmann::basic_json` requires of an object type to build, read and
/// write it; members cannot be erased by key.
template <class Key, class Mapped, class Compare, class Allocator>
class OrderedMap : public std::list<std::pair<const Key, Mapped>, Allocator> {
  using Members = std::list<std::pair<const Key, Mapped>, Allocator>;

 public:
  using key_type = Key;
  using mapped_type = Mapped;
  using key_compare = Compare;
  using typename Members::const_iterator;
  using typename Members::iterator;
  using typename Members::size_type;

  OrderedMap() = default;

  template <class Iterator>
  OrderedMap(Iterator first, Iterator last) {
    insert(first, last);
  }

  [[nodiscard]] iterator find(const Key& key) { return found(*this, key); }
  [[nodiscard]] const_iterator find(const Key& key) const { return found(*this, key); }
  [[nodiscard]] size_type count(const Key& key) const { return find(key) == this->end() ? 0 : 1; }

  template <class Value>
  std::pair<iterator, bool> emplace(const Key& key, Value&& value) {
    const iterator present = find(key);
    if (present != this->end()) return {present, false};
    this->emplace_back(key, std::forward<Value>(value));
    return {std::prev(this->end()), true};
  }

  Mapped& operator[](const Key& key) { return emplace(key, Mapped()).first->second; }

  Mapped& at(const Key& key) { return present(*this, key); }
  [[nodiscard]] const Mapped& at(const Key& key) const { return present(*this, key); }

  std::pair<iterator, bool> insert(const std::pair<const Key, Mapped>& member) {
    return emplace(member.first, member.second);
  }

  template <class Iterator>
  void insert(Iterator first, Iterator last) {
    for (; first != last; ++first) insert(*first);
  }

 private:
  template <class Map>
  static auto found(Map& map, const Key& key) {
    return std::find_if(map.begin(), map.end(),
                        [&](const auto& member) { return member.first == key; });
  }

  template <class Map>
  static auto& present(Map& map, const Key& key) {
    const auto member = map.find(key);
    if (member == map.end()) throw std::out_of_range("no such key");
    return member->second;
  }
};

}  // namespace synthetic_dataset
