#include "tools/study/web/page_files.h"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "support/program/files/shipped.h"

namespace telepalp::study {
namespace {

/// The type of a file by the end of its name.
std::string_view type_of(std::string_view name) {
  if (name.ends_with(".js")) return "text/javascript; charset=utf-8";
  if (name.ends_with(".css")) return "text/css; charset=utf-8";
  if (name.ends_with(".svg")) return "image/svg+xml";
  return "text/html; charset=utf-8";
}

}  // namespace

Result<PageFiles> read_page_files(std::span<const char* const> paths) {
  PageFiles files;
  for (const char* const relative : paths) {
    const auto path = program::shipped_file(relative);
    std::ifstream in;
    if (path) in.open(*path, std::ios::binary);
    if (!path || !in)
      return Error{.what = "a file of the page is missing",
                   .where = relative,
                   .fix = "install telepalp again, or let TELEPALP_HOME name the folder share/telepalp"};
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    const std::string name = std::filesystem::path(relative).filename();
    files[name == "index.html" ? "/" : "/" + name] = {std::move(bytes), type_of(name)};
  }
  return files;
}

}  // namespace telepalp::study
