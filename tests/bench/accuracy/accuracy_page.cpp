#include "tests/bench/accuracy/accuracy_page.h"

#include <cmath>
#include <fstream>
#include <sstream>

#include "support/plot/number.h"

namespace telepalp::bench {
namespace {

std::string line_of(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& text : cells) line += " " + text + " |";
  return line + "\n";
}

Error cannot(const std::filesystem::path& file, const std::string& what) {
  return {.what = what, .where = file.string(), .fix = "give the repository's docs folder to --write"};
}

Result<void> write_file(const std::filesystem::path& file, const std::string& text) {
  std::error_code code;
  std::filesystem::create_directories(file.parent_path(), code);
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  if (!(out << text) || !out.flush()) return cannot(file, "cannot be written");
  return {};
}

}  // namespace

std::string cell(double value) { return std::isfinite(value) ? plot::readable(value) : "–"; }

std::string to_markdown(const PageTable& table) {
  std::string text = line_of(table.head);
  text += line_of(std::vector<std::string>(table.head.size(), "---"));
  for (const auto& row : table.rows) text += line_of(row);
  return text;
}

Result<std::string> with_parts(const std::string& page, const std::vector<PagePart>& parts, const std::string& name) {
  std::string out = page;
  for (const PagePart& part : parts) {
    const std::string begin = "<!-- begin " + part.name + " -->\n";
    const std::string end = "<!-- end " + part.name + " -->";
    const std::size_t from = out.find(begin);
    const std::size_t to = from == std::string::npos ? from : out.find(end, from);
    if (to == std::string::npos)
      return Error{.what = "has no lines '" + begin.substr(0, begin.size() - 1) + "' and '" + end + "'",
                   .where = name,
                   .fix = "put these two lines where this part of the page belongs"};
    out.replace(from + begin.size(), to - from - begin.size(), part.text);
  }
  return out;
}

Result<void> rewrite_page(const std::filesystem::path& page, const std::vector<PagePart>& parts,
                          const std::vector<PagePicture>& pictures) {
  std::ifstream in(page, std::ios::binary);
  std::ostringstream before;
  if (!in || !(before << in.rdbuf())) return cannot(page, "cannot be read");
  const Result<std::string> after = with_parts(before.str(), parts, page.string());
  if (!after) return after.error();
  for (const PagePicture& picture : pictures)
    if (const Result<void> done = write_file(page.parent_path() / picture.file, picture.svg + "\n"); !done)
      return done.error();
  return write_file(page, *after);
}

}  // namespace telepalp::bench
