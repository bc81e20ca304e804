#include "support/program/files/shipped.h"

#include <cstdlib>
#include <fstream>
#include <string>

namespace telepalp::program {
namespace {

namespace fs = std::filesystem;

std::optional<fs::path> below(const fs::path& folder, const fs::path& relative) {
  std::error_code code;
  fs::path file = folder / relative;
  if (folder.empty() || !fs::exists(file, code)) return std::nullopt;
  return file;
}

fs::path own_folder() {
  std::error_code code;
  return fs::read_symlink("/proc/self/exe", code).parent_path();
}

/// The repository that a build directory was configured from; empty when `folder` is no build directory.
fs::path source_of_build(const fs::path& folder) {
  std::ifstream note(folder / "telepalp_source.txt");
  std::string path;
  std::getline(note, path);
  return path;
}

}  // namespace

std::optional<fs::path> shipped_file(const fs::path& relative) {
  if (const char* home = std::getenv("TELEPALP_HOME")) return below(home, relative);
  fs::path folder = own_folder();
  while (folder.has_relative_path()) {
    for (const fs::path& place : {folder / "share/telepalp", folder, source_of_build(folder)})
      if (std::optional<fs::path> file = below(place, relative)) return file;
    folder = folder.parent_path();
  }
  return std::nullopt;
}

fs::path sibling_program(std::string_view name) { return own_folder() / name; }

}  // namespace telepalp::program
