#include "tests/architecture/cpp_laws.h"

#include <algorithm>
#include <filesystem>

namespace telepalp::architecture {
namespace {

constexpr std::size_t kMostFilesInAFolder = 25;
constexpr std::size_t kMostDoors = 4;

const Rule* rule_for(const std::string& file, const std::vector<Rule>& rules) {
  const Rule* best = nullptr;
  for (const Rule& rule : rules)
    if (is_below(file, rule.folder) && (best == nullptr || rule.folder.size() > best->folder.size())) best = &rule;
  return best;
}

bool enters(const std::string& file, const std::string& include, const std::string& room) {
  return is_below(include, room) && !is_below(file, room);
}

/// Rooms whose namespace is not their folder's name.
const std::map<std::string, std::string> kOtherNamespaces{
    {"proto/words", "telepalp"},             // the vocabulary of all rooms
    {"proto/wire/mcap", "telepalp::wire"},   // its parts are in telepalp::wire::mcap
    {"tools/keys", "telepalp::keys_tool"}};  // proto/keys has the name

/// The namespaces that a file may open: those of the rooms around it. A room within a room may have its own.
std::set<std::string> allowed_namespaces(const std::string& file, const Rooms& rooms) {
  std::set<std::string> allowed;
  for (const auto& [room, doors] : rooms.doors) {
    if (!is_below(file, room)) continue;
    const auto other = kOtherNamespaces.find(room);
    allowed.insert(other != kOtherNamespaces.end() ? other->second
                                                   : "telepalp::" + std::filesystem::path(room).filename().string());
  }
  return allowed;
}

using Graph = std::map<std::string, std::set<std::string>>;

/// For each folder, the other folders that its files include.
Graph folder_graph(const Includes& all) {
  Graph graph;
  for (const auto& [file, list] : all)
    for (const std::string& include : list)
      if (is_ours(include) && folder_of(include) != folder_of(file)) graph[folder_of(file)].insert(folder_of(include));
  return graph;
}

/// A path from `folder` back to itself; empty without one.
std::vector<std::string> cycle_through(const Graph& graph, const std::string& folder) {
  std::map<std::string, std::string> came_from;
  std::vector<std::string> open{folder};
  while (!open.empty()) {
    const std::string here = open.back();
    open.pop_back();
    const auto edges = graph.find(here);
    if (edges == graph.end()) continue;
    for (const std::string& next : edges->second) {
      if (!came_from.emplace(next, here).second) continue;
      if (next != folder) {
        open.push_back(next);
        continue;
      }
      std::vector<std::string> path{folder};
      for (std::string at = here; at != folder; at = came_from[at]) path.push_back(at);
      return path;
    }
  }
  return {};
}

}  // namespace

Sentences forbidden_includes(const Includes& all, const std::vector<Rule>& rules) {
  Sentences found;
  for (const auto& [file, list] : all) {
    const Rule* rule = rule_for(file, rules);
    if (rule == nullptr) found.push_back(file + " has no rule");
    for (const std::string& include : list)
      if (rule != nullptr && is_ours(include) &&
          std::none_of(rule->may_include.begin(), rule->may_include.end(),
                       [&](const auto& allowed) { return is_below(include, allowed); }))
        found.push_back(file + " may not include " + include);
  }
  return found;
}

Sentences includes_past_the_doors(const Includes& all, const Rooms& rooms) {
  Sentences found;
  for (const auto& [file, list] : all)
    for (const std::string& include : list)
      for (const auto& [room, doors] : rooms.doors)
        if (enters(file, include, room) && !doors.contains(include))
          found.push_back(file + " passes by the doors of " + room + ": " + include);
  return found;
}

Sentences rooms_with_many_doors(const Rooms& rooms) {
  Sentences found;
  for (const auto& [room, doors] : rooms.doors)
    if (doors.size() > kMostDoors && !rooms.with_a_reason.contains(room))
      found.push_back(room + " has " + std::to_string(doors.size()) + " doors and no reason");
  return found;
}

Sentences files_outside_rooms(const Includes& all, const Rooms& rooms) {
  Sentences found;
  for (const auto& [file, unused] : all) {
    const bool is_main_of_a_program = folder_of(file).find('/') == std::string::npos;
    const bool is_in_a_room = std::any_of(rooms.doors.begin(), rooms.doors.end(),
                                          [&](const auto& room) { return is_below(file, room.first); });
    if (!is_main_of_a_program && !is_in_a_room) found.push_back(file + " is in no room");
  }
  return found;
}

Sentences crowded_folders(const Includes& all) {
  std::map<std::string, std::size_t> files;
  for (const auto& [file, unused] : all) ++files[folder_of(file)];
  Sentences found;
  for (const auto& [folder, count] : files)
    if (count > kMostFilesInAFolder) found.push_back(folder + " has " + std::to_string(count) + " files");
  return found;
}

Sentences foreign_namespaces(const Namespaces& all, const Rooms& rooms) {
  Sentences found;
  for (const auto& [file, opened] : all) {
    const std::set<std::string> allowed = allowed_namespaces(file, rooms);
    if (allowed.empty()) continue;  // the main of a program
    for (const std::string& one : opened)
      if (std::none_of(allowed.begin(), allowed.end(),
                       [&](const std::string& own) { return one == own || one.starts_with(own + "::"); }))
        found.push_back(file + " opens " + one);
  }
  return found;
}

Sentences circles_of_folders(const Includes& all) {
  const Graph graph = folder_graph(all);
  Sentences found;
  for (const auto& [folder, unused] : graph) {
    std::string circle;
    for (const std::string& step : cycle_through(graph, folder)) circle += step + " <- ";
    if (!circle.empty()) found.push_back("a circle: " + circle + folder);
  }
  return found;
}

Sentences banned_includes(const Includes& all, const std::vector<std::string>& folders,
                          const std::vector<std::string>& banned) {
  Sentences found;
  for (const auto& [file, list] : all) {
    if (std::none_of(folders.begin(), folders.end(), [&](const auto& folder) { return is_below(file, folder); }))
      continue;
    for (const std::string& include : list)
      for (const std::string& part : banned)
        if (include.find(part) != std::string::npos) found.push_back(file + " includes " + include);
  }
  return found;
}

}  // namespace telepalp::architecture
