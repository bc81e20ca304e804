#include "tests/architecture/page_imports.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <regex>
#include <sstream>

namespace telepalp::architecture {
namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "three" of three/examples/x.js, "@bufbuild/protobuf" of @bufbuild/protobuf/wkt.
std::string package_of(const std::string& name) {
  std::size_t end = name.find('/');
  if (name.starts_with('@') && end != std::string::npos) end = name.find('/', end + 1);
  return name.substr(0, end);
}

/// True for `type {A, B}`, `type * as a` and `{type A, type B}`.
bool names_only_types(const std::string& clause) {
  static const std::regex kWhole(R"re(^\s*type\s)re");
  static const std::regex kEach(R"re(^\s*\{\s*(type\s+[\w$\s]+,?\s*)+\}\s*$)re");
  return std::regex_search(clause, kWhole) || std::regex_match(clause, kEach);
}

PageImport import_of(const std::string& name, const std::string& file, bool is_type_only) {
  if (!name.starts_with('.')) return {package_of(name), true, is_type_only};
  return {(fs::path(file).parent_path() / name).lexically_normal().string(), false, is_type_only};
}

Allowed parse_allowed(std::istringstream& words, std::string name) {
  Allowed allowed{std::move(name), {}, {}};
  bool of_packages = false;
  for (std::string word; words >> word;) {
    if (word == "+")
      of_packages = true;
    else if (of_packages)
      allowed.packages.insert(word);
    else
      allowed.rooms.push_back(word);
  }
  return allowed;
}

using Words = std::set<std::string>;

std::string worker_word(const Allowed& worker) { return "the worker " + worker.name; }

/// Rooms and packages that the files of each room import.
struct Used {
  std::map<std::string, Words> rooms, packages;
};

Used used_by_rooms(const PageImports& imports) {
  Used used;
  for (const auto& [file, list] : imports)
    for (const PageImport& one : list) {
      if (one.is_package)
        used.packages[room_of(file)].insert(one.name);
      else if (room_of(one.name) != room_of(file))
        used.rooms[room_of(file)].insert(room_of(one.name));
    }
  return used;
}

void compare(const std::string& who, const Words& allowed, const Words& used, std::vector<std::string>& found) {
  for (const std::string& one : used)
    if (!allowed.contains(one)) found.push_back(who + " may not import " + one);
  for (const std::string& one : allowed)
    if (!used.contains(one)) found.push_back(who + " imports nothing of " + one + ", which its line names");
}

void check_rooms(const PageRooms& rooms, const PageImports& imports, std::vector<std::string>& found) {
  Used used = used_by_rooms(imports);
  Words above;
  for (const Allowed& room : rooms.rooms) {
    for (const std::string& one : room.rooms)
      if (!above.contains(one)) found.push_back(room.name + " names " + one + ", which does not stand above it");
    compare(room.name, {room.rooms.begin(), room.rooms.end()}, used.rooms[room.name], found);
    compare(room.name, room.packages, used.packages[room.name], found);
    above.insert(room.name);
  }
  for (const auto& [file, unused] : imports)
    if (!above.contains(room_of(file))) found.push_back(file + " is in no room of the list");
}

/// The files whose code `from` runs.
Words files_run_by(const std::string& from, const PageImports& imports) {
  Words reached{from};
  std::vector<std::string> open{from};
  while (!open.empty()) {
    const auto file = imports.find(open.back());
    open.pop_back();
    if (file == imports.end()) continue;
    for (const PageImport& one : file->second)
      if (!one.is_package && !one.is_type_only && reached.insert(one.name).second) open.push_back(one.name);
  }
  return reached;
}

void check_workers(const PageRooms& rooms, const PageImports& imports, std::vector<std::string>& found) {
  for (const Allowed& worker : rooms.workers) {
    Words of_rooms, of_packages;
    for (const std::string& file : files_run_by(fs::path(worker.name).replace_extension().string(), imports)) {
      of_rooms.insert(room_of(file));
      const auto list = imports.find(file);
      if (list == imports.end()) continue;
      for (const PageImport& one : list->second)
        if (one.is_package && !one.is_type_only) of_packages.insert(one.name);
    }
    compare(worker_word(worker), {worker.rooms.begin(), worker.rooms.end()}, of_rooms, found);
    compare(worker_word(worker), worker.packages, of_packages, found);
  }
}

/// Adds the circle that the imports below `file` close. `path`: the files that lead to it.
void find_circle(const std::string& file, const PageImports& imports, std::vector<std::string>& path, Words& done,
                 std::vector<std::string>& found) {
  if (const auto begin = std::find(path.begin(), path.end(), file); begin != path.end()) {
    std::string circle;
    for (auto at = begin; at != path.end(); ++at) circle += *at + " -> ";
    found.push_back("a circle: " + circle + file);
    return;
  }
  const auto list = imports.find(file);
  if (list == imports.end() || !done.insert(file).second) return;
  path.push_back(file);
  for (const PageImport& one : list->second)
    if (!one.is_package) find_circle(one.name, imports, path, done, found);
  path.pop_back();
}

}  // namespace

std::vector<PageImport> imports_in(const std::string& text, const std::string& file) {
  static const std::regex kFrom(R"re((?:^|\n)(?:import|export)\s([^;'"]*?)\sfrom\s+['"]([^'"]+)['"])re");
  static const std::regex kBare(R"re((?:^|\n)import\s+['"]([^'"]+)['"]|\bimport\(\s*['"]([^'"]+)['"])re");
  std::vector<PageImport> found;
  for (std::sregex_iterator at(text.begin(), text.end(), kFrom), end; at != end; ++at)
    found.push_back(import_of((*at)[2], file, names_only_types((*at)[1])));
  for (std::sregex_iterator at(text.begin(), text.end(), kBare), end; at != end; ++at)
    found.push_back(import_of((*at)[1].matched ? (*at)[1] : (*at)[2], file, false));
  return found;
}

PageImports read_page_imports(const fs::path& sources) {
  PageImports all;
  for (const auto& entry : fs::recursive_directory_iterator(sources)) {
    if (entry.path().extension() != ".ts") continue;
    const std::string file = fs::relative(entry, sources).replace_extension().string();
    all[file] = imports_in(text_of(entry), file);
  }
  return all;
}

PageRooms read_page_rooms(const fs::path& list) {
  PageRooms rooms;
  std::ifstream in(list);
  for (std::string line; std::getline(in, line);) {
    if (line.empty() || line.starts_with('#')) continue;
    std::istringstream words(line);
    std::string name;
    words >> name;
    const bool is_worker = name == "worker";
    if (is_worker) words >> name;
    if (name.ends_with(':')) name.pop_back();
    (is_worker ? rooms.workers : rooms.rooms).push_back(parse_allowed(words, std::move(name)));
  }
  return rooms;
}

std::string room_of(const std::string& file) {
  const std::size_t end = file.find('/');
  return end == std::string::npos ? "src" : file.substr(0, end);
}

std::vector<std::string> page_violations(const PageRooms& rooms, const PageImports& imports) {
  std::vector<std::string> found;
  check_rooms(rooms, imports, found);
  check_workers(rooms, imports, found);
  std::vector<std::string> path;
  Words done;
  for (const auto& [file, unused] : imports) find_circle(file, imports, path, done, found);
  return found;
}

}  // namespace telepalp::architecture
