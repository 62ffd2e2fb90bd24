#include "plugins/coco/coco_index.h"

#include <fstream>
#include <istream>
#include <streambuf>

#include "plugins/readback/json_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::formats::coco {
namespace {

using nlohmann::json;

/// Another buffer's bytes one by one, counted.
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

/// Hears the parser's events (nlohmann's SAX interface). An entry is an object in a list that is a
/// member of the file's one object; the parser has just read its last brace when it ends.
class CocoIndex::Reader {
 public:
  Reader(CocoIndex& index, const CountingBuffer& buffer) : index_(index), buffer_(buffer) {}

  bool null() { return other(nullptr); }
  bool boolean(bool value) { return other(value); }
  bool number_integer(std::int64_t value) { return number(value); }
  bool number_unsigned(std::uint64_t value) { return number(static_cast<std::int64_t>(value)); }
  bool number_float(double value, const std::string& /*text*/) { return other(value); }
  template <class Bytes>
  bool binary(Bytes& /*value*/) {
    return true;
  }

  bool string(std::string& value) {
    if (depth_ == kInEntry && key_ == "file_name") file_name_ = value;
    return other(value);
  }

  bool start_object(std::size_t /*size*/) {
    if (++depth_ == kMember) begin();
    if (depth_ == kInEntry) {
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
    if (depth_ == kMember) end();
    if (depth_-- != kInEntry) return true;
    place_.end = buffer_.count();
    if (list_ == "images") ++index_.image_count_;
    if (list_ == "annotations") ++index_.annotation_count_;
    if (list_ == "images" && id_) {
      index_.image_ids_[file_name_] = *id_;
      index_.images_[file_name_] = place_;
    }
    if (list_ == "annotations" && image_id_) index_.annotations_[*image_id_].push_back(place_);
    if (list_ == "categories") categories.push_back(place_);
    return true;
  }

  bool start_array(std::size_t /*size*/) {
    if (++depth_ == kMember) begin();
    return true;
  }

  bool end_array() {
    if (depth_ == kMember) end();
    --depth_;
    return true;
  }

  bool parse_error(std::size_t /*position*/, const std::string& /*token*/,
                   const json::exception& error) {
    throw Error("'" + index_.file_.string() + "': " + error.what());
  }

  std::vector<Place> categories;
  std::map<std::string, Place> members;  ///< those that have no index

 private:
  static constexpr int kMember = 2;   // object, and a list or an object in it
  static constexpr int kInEntry = 3;  // object, list, object

  [[nodiscard]] bool isIndexed() const {
    return list_ == "images" || list_ == "annotations" || list_ == "categories";
  }

  void begin() {
    if (!isIndexed()) members[list_].begin = buffer_.count() - 1;
  }

  void end() {
    if (!isIndexed()) members[list_].end = buffer_.count();
  }

  /// A value that may stand where no entry does.
  bool other(const json& value) {
    if (depth_ == 1) index_.rest_[list_] = value;
    if (depth_ == kMember && isIndexed()) index_.rest_["entries that are no objects"] = value;
    return true;
  }

  bool number(std::int64_t value) {
    if (depth_ != kInEntry) return other(value);
    if (key_ == "id") id_ = value;
    if (key_ == "image_id") image_id_ = value;
    return true;
  }

  CocoIndex& index_;
  const CountingBuffer& buffer_;
  int depth_ = 0;
  std::string list_;  ///< the member of the file's object
  std::string key_;   ///< of the entry
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
  for (const auto& [name, place] : reader.members) rest_[name] = entryAt(place);
}

std::optional<json> CocoIndex::image(const std::string& file_name) const {
  const auto found = images_.find(file_name);
  return found == images_.end() ? std::nullopt : std::optional(entryAt(found->second));
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
  return readingJson(file_, [&] { return json::parse(text); });
}

}  // namespace synthetic_dataset::formats::coco
