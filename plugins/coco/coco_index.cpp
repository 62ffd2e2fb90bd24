#include "plugins/coco/coco_index.h"

#include <fstream>
#include <istream>
#include <streambuf>

#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::coco {
namespace {

using nlohmann::json;

/// Passes on another buffer's bytes one by one, and counts them.
class CountingBuffer : public std::streambuf {
 public:
  explicit CountingBuffer(std::streambuf& source) : source_(source) {}

  [[nodiscard]] std::int64_t count() const { return count_; }

 protected:
  int_type underflow() override { return source_.sgetc(); }
  int_type uflow() override {
    const int_type byte = source_.sbumpc();
    if (byte != traits_type::eof()) ++count_;
    return byte;
  }

 private:
  std::streambuf& source_;
  std::int64_t count_ = 0;
};

}  // namespace

/// Handles the parser's events (nlohmann's SAX interface). An entry is an object in a list that is
/// a member of the file's top-level object; when the event of its end arrives, the parser has just
/// read its last brace.
class CocoIndex::Reader {
 public:
  Reader(CocoIndex& index, const CountingBuffer& buffer) : index_(index), buffer_(buffer) {}

  static bool null() { return true; }
  static bool boolean(bool /*value*/) { return true; }
  bool number_integer(std::int64_t value) { return number(value); }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<std::int64_t>(value)); }
  static bool number_float(double /*value*/, const std::string& /*text*/) { return true; }
  template <class Bytes>
  bool binary(Bytes& /*value*/) {
    return true;
  }

  bool string(std::string& value) {
    if (depth_ == kInEntry && key_ == "file_name") file_name_ = value;
    return true;
  }

  bool start_object(std::size_t /*size*/) {
    if (++depth_ == kInEntry) {
      place_.begin = buffer_.count() - 1;
      id_ = image_id_ = std::nullopt;
      file_name_.clear();
    }
    return true;
  }

  bool key(std::string& key) {
    if (depth_ == 1) list_ = key;
    if (depth_ == kInEntry) key_ = key;
    return true;
  }

  bool end_object() {
    if (depth_-- != kInEntry) return true;
    place_.end = buffer_.count();
    if (list_ == "images" && id_) index_.image_ids_[file_name_] = *id_;
    if (list_ == "annotations" && image_id_) index_.annotations_[*image_id_].push_back(place_);
    if (list_ == "categories") categories.push_back(place_);
    return true;
  }

  bool start_array(std::size_t /*size*/) {
    ++depth_;
    return true;
  }

  bool end_array() {
    --depth_;
    return true;
  }

  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const json::exception& error) {
    throw Error("'" + index_.file_.string() + "': " + error.what());
  }

  std::vector<Place> categories;

 private:
  static constexpr int kInEntry = 3;  // object, list, object

  bool number(std::int64_t value) {
    if (depth_ != kInEntry) return true;
    if (key_ == "id") id_ = value;
    if (key_ == "image_id") image_id_ = value;
    return true;
  }

  CocoIndex& index_;
  const CountingBuffer& buffer_;
  int depth_ = 0;
  std::string list_;  ///< key of the current list in the file's object
  std::string key_;   ///< current key in the entry
  Place place_;
  std::optional<std::int64_t> id_;
  std::optional<std::int64_t> image_id_;
  std::string file_name_;
};

CocoIndex::CocoIndex(const std::filesystem::path& file) : file_(file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error("'" + file.string() + "': cannot be read");
  CountingBuffer buffer(*stream.rdbuf());
  std::istream counted(&buffer);
  Reader reader(*this, buffer);
  json::sax_parse(counted, &reader);
  for (const Place& place : reader.categories) categories_.push_back(entryAt(place));
}

std::optional<std::int64_t> CocoIndex::imageId(const std::string& file_name) const {
  const auto found = image_ids_.find(file_name);
  return found == image_ids_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<json> CocoIndex::annotationsOf(std::int64_t image_id) const {
  std::vector<json> annotations;
  const auto found = annotations_.find(image_id);
  if (found == annotations_.end()) return annotations;
  for (const Place& place : found->second) annotations.push_back(entryAt(place));
  return annotations;
}

json CocoIndex::entryAt(const Place& place) const {
  std::ifstream stream(file_, std::ios::binary);
  std::string text(static_cast<std::size_t>(place.end - place.begin), ' ');
  if (!stream.seekg(place.begin) ||
      !stream.read(text.data(), static_cast<std::streamsize>(text.size()))) {
    throw Error("'" + file_.string() + "': cannot be read");
  }
  return readingJson(file_, [&] { return parsedJson<json>(text); });
}

}  // namespace synthetic_dataset::formats::coco
