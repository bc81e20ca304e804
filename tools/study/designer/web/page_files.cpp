#include "tools/study/designer/web/page_files.h"

#include <fstream>
#include <iterator>

#include "support/program/files/shipped.h"

namespace telepalp::study {
namespace {

struct Name {
  const char* file;
  std::string_view type;
};
constexpr std::string_view kScript = "text/javascript; charset=utf-8";
constexpr Name kNames[] = {{"index.html", "text/html; charset=utf-8"},
                           {"designer.css", "text/css; charset=utf-8"},
                           {"icon.svg", "image/svg+xml"},
                           {"chart.js", kScript},
                           {"compare.js", kScript},
                           {"designer.js", kScript},
                           {"drawing.js", kScript},
                           {"link.js", kScript},
                           {"parameters.js", kScript},
                           {"search.js", kScript},
                           {"theme.js", kScript}};

}  // namespace

Result<PageFiles> read_page_files() {
  PageFiles files;
  for (const auto& [name, type] : kNames) {
    const std::string relative = std::string("tools/study/designer/page/") + name;
    const auto path = program::shipped_file(relative);
    std::ifstream in;
    if (path) in.open(*path, std::ios::binary);
    if (!path || !in)
      return Error{.what = "a file of the designer's page is missing",
                   .where = relative,
                   .fix = "install telepalp again, or let TELEPALP_HOME name the folder share/telepalp"};
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    files[std::string(name) == "index.html" ? "/" : "/" + std::string(name)] = {std::move(bytes), type};
  }
  return files;
}

}  // namespace telepalp::study
