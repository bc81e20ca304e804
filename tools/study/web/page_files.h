#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::study {

struct PageFile {
  std::string bytes;
  std::string_view type;  ///< of its content
};
/// The page's files by their address, such as "/designer.js"; "/" is the page.
using PageFiles = std::map<std::string, PageFile, std::less<>>;

/// Reads the files of a page by their paths in the repository. They are installed with the program. Each gets its name
/// as its address. Error: one is missing.
[[nodiscard]] Result<PageFiles> read_page_files(std::span<const char* const> paths);

}  // namespace telepalp::study
