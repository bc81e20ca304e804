#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace telepalp::study {

/// The bytes of `file`; empty if it cannot be read.
inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

inline bool says(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace telepalp::study
