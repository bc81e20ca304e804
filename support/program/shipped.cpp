#include "support/program/shipped.h"

#include <cstdlib>

namespace telepalp::program {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> below(const fs::path& folder, const fs::path& relative) {
  std::error_code code;
  fs::path file = folder / relative;
  if (!fs::exists(file, code)) return std::nullopt;
  return file;
}

}  // namespace

std::optional<fs::path> shipped_file(const fs::path& relative) {
  if (const char* home = std::getenv("TELEPALP_HOME")) return below(home, relative);
  std::error_code code;
  fs::path folder = fs::read_symlink("/proc/self/exe", code).parent_path();
  while (folder.has_relative_path()) {
    if (std::optional<fs::path> file = below(folder, relative)) return file;
    folder = folder.parent_path();
  }
  return std::nullopt;
}

}  // namespace telepalp::program
