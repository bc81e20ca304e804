#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "proto/words/result.h"

namespace telepalp::bench {

/// A table as text; every row has as many cells as the head.
struct PageTable {
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
};
[[nodiscard]] std::string to_markdown(const PageTable& table);

/// A part of a page that a benchmark writes: `text` replaces the lines between `<!-- begin NAME -->` and `<!-- end NAME
/// -->`.
struct PagePart {
  std::string name;
  std::string text;
};

/// `page` with the text of its parts replaced. Text outside the markers is written by people and stays. An error names
/// missing markers.
[[nodiscard]] Result<std::string> with_parts(const std::string& page, const std::vector<PagePart>& parts,
                                             const std::string& name);

/// A picture beside the page.
struct PagePicture {
  std::string file;  ///< relative to the page's folder
  std::string svg;
};

/// Rewrites the parts of the page file `page`, and its pictures.
[[nodiscard]] Result<void> rewrite_page(const std::filesystem::path& page, const std::vector<PagePart>& parts,
                                        const std::vector<PagePicture>& pictures);

/// Three significant digits, for a cell; "–" for what is not finite.
[[nodiscard]] std::string cell(double value);

}  // namespace telepalp::bench
