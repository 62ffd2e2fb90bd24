#include "output/files/digest.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <fstream>
#include <system_error>
#include <vector>

#include <openssl/evp.h>

#include "base/input_file.h"
#include "synthetic_dataset/errors.h"

namespace synthetic_dataset::output {
namespace {

constexpr std::int64_t kMebibyte = std::int64_t{1} << 20;
constexpr std::int64_t kReadWhole = 64 * kMebibyte;  // larger inputs are only read in part
constexpr std::int64_t kPart = 32 * kMebibyte;       // at each end

[[noreturn]] void failToRead(const std::string& path) {
  throw Error("cannot read '" + path + "': " + std::generic_category().message(errno));
}

std::ifstream opened(const std::string& path, std::int64_t& size) {
  const std::string fault = base::inputFault(path);
  if (!fault.empty()) throw Error("cannot read '" + path + "': it " + fault);
  errno = 0;
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  if (!stream) failToRead(path);
  size = stream.tellg();
  stream.seekg(0);
  if (!stream) failToRead(path);
  return stream;
}

/// Adds the next `count` bytes.
void addPart(Digest& digest, std::ifstream& stream, std::int64_t count, const std::string& path) {
  std::vector<char> buffer(static_cast<std::size_t>(kMebibyte));
  while (count > 0) {
    errno = 0;
    stream.read(buffer.data(), std::min(count, kMebibyte));
    if (stream.gcount() == 0) failToRead(path);
    digest.add({buffer.data(), static_cast<std::size_t>(stream.gcount())});
    count -= stream.gcount();
  }
}

}  // namespace

struct Digest::State {
  struct Free {
    void operator()(EVP_MD_CTX* freed) const { EVP_MD_CTX_free(freed); }
  };
  std::unique_ptr<EVP_MD_CTX, Free> context{EVP_MD_CTX_new()};
};

Digest::Digest() : state_(std::make_unique<State>()) {
  if (EVP_DigestInit_ex(state_->context.get(), EVP_sha256(), nullptr) != 1) {
    throw Error("OpenSSL cannot compute SHA-256");
  }
}

Digest::~Digest() = default;
Digest::Digest(Digest&&) noexcept = default;
Digest& Digest::operator=(Digest&&) noexcept = default;

void Digest::add(std::string_view bytes) {
  EVP_DigestUpdate(state_->context.get(), bytes.data(), bytes.size());
}

std::string Digest::text() {
  std::array<unsigned char, 32> hash{};
  EVP_DigestFinal_ex(state_->context.get(), hash.data(), nullptr);
  static constexpr char kDigits[] = "0123456789abcdef";
  std::string text;
  for (const unsigned char byte : hash) {
    text += kDigits[byte >> 4];
    text += kDigits[byte & 15];
  }
  return text;
}

std::string digestOf(std::string_view bytes) {
  Digest digest;
  digest.add(bytes);
  return digest.text();
}

FileDigest digestOfFile(const std::string& path) {
  std::int64_t size = 0;
  std::ifstream stream = opened(path, size);
  Digest digest;
  addPart(digest, stream, size, path);
  return {size, digest.text()};
}

FileDigest digestOfInput(const std::string& path) {
  std::int64_t size = 0;
  std::ifstream stream = opened(path, size);
  if (size <= kReadWhole) return digestOfFile(path);
  Digest digest;
  addPart(digest, stream, kPart, path);
  stream.seekg(size - kPart);
  addPart(digest, stream, kPart, path);
  return {size, digest.text()};
}

}  // namespace synthetic_dataset::output
