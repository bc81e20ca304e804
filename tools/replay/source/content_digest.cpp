#include "tools/replay/source/content_digest.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <vector>

namespace telepalp::replay {
namespace {

constexpr std::uint64_t kPrime = 1099511628211ULL;
constexpr std::size_t kBlock = std::size_t{1} << 20U;

bool add_file(ContentDigest& digest, const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::vector<char> block(kBlock);
  while (in) {
    in.read(block.data(), static_cast<std::streamsize>(block.size()));
    digest.add(std::as_bytes(std::span(block).first(static_cast<std::size_t>(in.gcount()))));
  }
  return in.eof();
}

/// The file, or the files of the folder in the order of their names.
std::vector<std::filesystem::path> files_of(const std::filesystem::path& path) {
  std::error_code failed;
  if (std::filesystem::is_regular_file(path, failed)) return {path};
  std::vector<std::filesystem::path> files;
  if (!std::filesystem::is_directory(path, failed)) return files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(path, failed))
    if (entry.is_regular_file(failed)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

void ContentDigest::add(std::span<const std::byte> bytes) noexcept {
  std::uint64_t value = value_;
  while (!bytes.empty()) {
    std::uint64_t word = bytes.size();  // of a last, incomplete word: its length
    const std::size_t taken = std::min(bytes.size(), sizeof word);
    std::memcpy(&word, bytes.data(), taken);
    value = (value ^ word) * kPrime;
    value ^= value >> 32U;
    bytes = bytes.subspan(taken);
  }
  value_ = value;
}

std::string ContentDigest::hex() const {
  std::array<char, 20> text{};
  std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(value_));
  return text.data();
}

std::string digest_of_source(const std::string& source) {
  const std::size_t colon = source.find(':');
  const auto named = files_of(source);
  const auto files = named.empty() && colon != std::string::npos ? files_of(source.substr(colon + 1)) : named;
  ContentDigest digest;
  for (const std::filesystem::path& file : files) {
    digest.add(file.filename().string());
    if (!add_file(digest, file)) return {};
  }
  return files.empty() ? "" : digest.hex();
}

}  // namespace telepalp::replay
