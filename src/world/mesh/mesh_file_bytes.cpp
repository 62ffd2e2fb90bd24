#include "world/mesh/mesh_file_bytes.h"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "base/sandbox/byte_stream.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::world {
namespace {

using Embedded = std::shared_ptr<const EmbeddedPicture>;
using Reference = std::optional<TextureReference>;

/// Each picture of a file once, however many materials name it.
using EmbeddedPictures = std::vector<Embedded>;

EmbeddedPictures gather(const MeshFile& file) {
  EmbeddedPictures pictures;
  for (const MaterialSource& source : file.materials) {
    for (const Reference* reference : referencesOf(source)) {
      if (!*reference || !(*reference)->embedded) continue;
      const Embedded& picture = (*reference)->embedded;
      if (std::find(pictures.begin(), pictures.end(), picture) == pictures.end()) {
        pictures.push_back(picture);
      }
    }
  }
  return pictures;
}

// Numbers start from 1; 0 means that the picture is not embedded.
std::uint64_t numberOf(const Embedded& picture, const EmbeddedPictures& pictures) {
  if (!picture) return 0;
  const auto found = std::find(pictures.begin(), pictures.end(), picture);
  return static_cast<std::uint64_t>(found - pictures.begin()) + 1;
}

void write(const Reference& reference, const EmbeddedPictures& pictures, base::ByteWriter& writer) {
  writer.number(reference.has_value());
  if (!reference) return;
  writer.text(reference->uri);
  writer.text(reference->folder.string());
  writer.number(numberOf(reference->embedded, pictures));
  writer.number(reference->alpha);
  writer.number(reference->content);
}

Reference readReference(const EmbeddedPictures& pictures, base::ByteReader& reader) {
  if (!reader.number<bool>()) return std::nullopt;
  TextureReference reference;
  reference.uri = reader.text();
  reference.folder = reader.text();
  const auto number = reader.number<std::uint64_t>();
  if (number > pictures.size()) throw Error("its content arrived incomplete");
  if (number > 0) reference.embedded = pictures[number - 1];
  reference.alpha = reader.number<AlphaMeaning>();
  reference.content = reader.number<PictureContent>();
  return reference;
}

template <class Vector>
void writeVector(const Vector& vector, base::ByteWriter& writer) {
  for (int i = 0; i < vector.size(); ++i) writer.number(vector[i]);
}

template <class Vector>
void readVector(base::ByteReader& reader, Vector& vector) {
  for (int i = 0; i < vector.size(); ++i) vector[i] = reader.number<float>();
}

void write(const Material& material, base::ByteWriter& writer) {
  writeVector(material.diffuse, writer);
  writeVector(material.ambient, writer);
  writeVector(material.specular, writer);
  writeVector(material.emissive, writer);
  writer.number(material.shininess);
  writer.number(material.roughness);
  writer.number(material.metalness);
  writeVector(material.texture_scale, writer);
  writeVector(material.texture_offset, writer);
  writer.number(material.alpha_threshold);
  writer.number(material.texture_is_glass);
  writer.number(material.double_sided);
  writer.number(material.lit);
  writer.number(material.is_default);
}

Material readMaterial(base::ByteReader& reader) {
  Material material;
  readVector(reader, material.diffuse);
  readVector(reader, material.ambient);
  readVector(reader, material.specular);
  readVector(reader, material.emissive);
  material.shininess = reader.number<float>();
  material.roughness = reader.number<float>();
  material.metalness = reader.number<float>();
  readVector(reader, material.texture_scale);
  readVector(reader, material.texture_offset);
  material.alpha_threshold = reader.number<float>();
  material.texture_is_glass = reader.number<bool>();
  material.double_sided = reader.number<bool>();
  material.lit = reader.number<bool>();
  material.is_default = reader.number<bool>();
  return material;
}

void write(const MeshPart& part, base::ByteWriter& writer) {
  writer.number<std::uint64_t>(part.names.size());
  for (const std::string& name : part.names) writer.text(name);
  writer.list(part.mesh.positions);
  writer.list(part.mesh.normals);
  writer.list(part.mesh.texture_coordinates);
  writer.list(part.mesh.colours);
  writer.list(part.mesh.indices);
  writer.number<std::uint64_t>(part.material);
}

MeshPart readPart(base::ByteReader& reader) {
  MeshPart part;
  const std::size_t names = reader.entries();
  for (std::size_t i = 0; i < names; ++i) part.names.push_back(reader.text());
  part.mesh.positions = reader.list<Eigen::Vector3f>();
  part.mesh.normals = reader.list<Eigen::Vector3f>();
  part.mesh.texture_coordinates = reader.list<Eigen::Vector2f>();
  part.mesh.colours = reader.list<Eigen::Vector4f>();
  part.mesh.indices = reader.list<std::uint32_t>();
  part.material = static_cast<std::size_t>(reader.number<std::uint64_t>());
  return part;
}

}  // namespace

std::string toBytes(const MeshFile& file) {
  base::ByteWriter writer;
  const EmbeddedPictures pictures = gather(file);
  writer.number<std::uint64_t>(pictures.size());
  for (const Embedded& picture : pictures) {
    writer.text(picture->name);
    writer.list(picture->bytes);
  }
  writer.number<std::uint64_t>(file.materials.size());
  for (const MaterialSource& source : file.materials) {
    write(source.material, writer);
    writer.number(source.is_default);
    for (const Reference* reference : referencesOf(source)) write(*reference, pictures, writer);
  }
  writer.number<std::uint64_t>(file.parts.size());
  for (const MeshPart& part : file.parts) write(part, writer);
  writer.number<std::uint64_t>(file.notes.size());
  for (const std::string& note : file.notes) writer.text(note);
  writer.number<std::uint64_t>(file.files.size());
  for (const std::filesystem::path& each : file.files) writer.text(each.string());
  writer.number(file.has_lines);
  writer.number(file.y_up);
  writer.text(file.refusal);
  return writer.take();
}

MeshFile meshFileOf(std::string_view bytes) {
  base::ByteReader reader(bytes);
  EmbeddedPictures pictures(reader.entries());
  for (Embedded& picture : pictures) {
    EmbeddedPicture content;
    content.name = reader.text();
    content.bytes = reader.list<std::uint8_t>();
    picture = std::make_shared<const EmbeddedPicture>(std::move(content));
  }
  MeshFile file;
  file.materials.resize(reader.entries());
  for (MaterialSource& source : file.materials) {
    source.material = readMaterial(reader);
    source.is_default = reader.number<bool>();
    for (Reference* reference : referencesOf(source)) *reference = readReference(pictures, reader);
  }
  const std::size_t parts = reader.entries();
  for (std::size_t i = 0; i < parts; ++i) file.parts.push_back(readPart(reader));
  file.notes.resize(reader.entries());
  for (std::string& note : file.notes) note = reader.text();
  file.files.resize(reader.entries());
  for (std::filesystem::path& each : file.files) each = reader.text();
  file.has_lines = reader.number<bool>();
  file.y_up = reader.number<bool>();
  file.refusal = reader.text();
  return file;
}

}  // namespace synthetic_dataset::world
