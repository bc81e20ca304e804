#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

namespace telepalp::keys {

/// The content of `file`, cut off after `most` + 1 bytes, so that a larger file is known by its size; nullopt: it
/// cannot be read.
[[nodiscard]] inline std::optional<std::string> read_small_file(const std::filesystem::path& file, std::size_t most) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return std::nullopt;
  std::string text(most + 1, '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

}  // namespace telepalp::keys
