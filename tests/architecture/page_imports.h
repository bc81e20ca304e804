#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace telepalp::architecture {

/// One import of a TypeScript file.
struct PageImport {
  std::string name;  ///< a file relative to clients/viewer/src, without ".ts", or the name of an npm package
  bool is_package = false;
  bool is_type_only = false;  ///< the bundle contains nothing of it
};

/// File (relative to clients/viewer/src, without ".ts") to its imports.
using PageImports = std::map<std::string, std::vector<PageImport>>;

/// The imports of the TypeScript `text` of `file`: of each statement import and export … from, and of each import().
[[nodiscard]] std::vector<PageImport> imports_in(const std::string& text, const std::string& file);

/// The imports of every file below `sources`.
[[nodiscard]] PageImports read_page_imports(const std::filesystem::path& sources);

/// What the code of a room or of a worker may import.
struct Allowed {
  std::string name;  ///< folder of a room, or the file of a worker
  std::vector<std::string> rooms;
  std::set<std::string> packages;
};

/// clients/viewer/rooms.txt.
struct PageRooms {
  std::vector<Allowed> rooms;  ///< lowest first
  std::vector<Allowed> workers;
};

[[nodiscard]] PageRooms read_page_rooms(const std::filesystem::path& list);

/// The room of a file: its first folder, or "src" for a file of src/ itself.
[[nodiscard]] std::string room_of(const std::string& file);

/// Each violation of a law of the page's rooms, as a sentence. The laws: a room is in the list; it may import only
/// rooms above it in the list; it imports no room and no package that its line does not name; its line names nothing
/// that it does not import; no files import each other in a circle; a worker runs code only of the rooms in its line.
[[nodiscard]] std::vector<std::string> page_violations(const PageRooms& rooms, const PageImports& imports);

}  // namespace telepalp::architecture
