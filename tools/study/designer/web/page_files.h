#pragma once

#include <map>
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

/// Reads all files of the page, which are installed with the program. Error: one is missing.
[[nodiscard]] Result<PageFiles> read_page_files();

}  // namespace telepalp::study
