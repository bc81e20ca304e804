#include "clients/report/summary/scene_difference.h"

#include <algorithm>
#include <sstream>
#include <vector>

#include "proto/words/counted.h"

namespace telepalp::report {
namespace {

constexpr std::size_t kMostPlaces = 3;
constexpr std::size_t kMostLines = 2000;  // the table below has the square of it

struct Line {
  std::size_t number = 0;  ///< from 1
  std::string text;
};

std::vector<Line> lines_of(const std::string& scene) {
  std::vector<Line> lines;
  std::istringstream in(scene);
  std::string text;
  for (std::size_t number = 1; std::getline(in, text) && lines.size() < kMostLines; ++number) {
    const std::size_t from = text.find_first_not_of(" \t"), until = text.find_last_not_of(" \t\r");
    if (from == std::string::npos || text[from] == '#') continue;
    lines.push_back({number, text.substr(from, until + 1 - from)});
  }
  return lines;
}

/// Lines of A that B replaces by lines of its own; one of both may be empty.
struct Place {
  std::vector<Line> a, b;
};

/// Lengths of the longest common subsequences of the lines from (i, j) on.
std::vector<std::vector<std::size_t>> common_lengths(const std::vector<Line>& a, const std::vector<Line>& b) {
  std::vector<std::vector<std::size_t>> length(a.size() + 1, std::vector<std::size_t>(b.size() + 1, 0));
  for (std::size_t i = a.size(); i-- > 0;)
    for (std::size_t j = b.size(); j-- > 0;)
      length[i][j] = a[i].text == b[j].text ? 1 + length[i + 1][j + 1] : std::max(length[i + 1][j], length[i][j + 1]);
  return length;
}

std::vector<Place> places_of(const std::vector<Line>& a, const std::vector<Line>& b) {
  const auto length = common_lengths(a, b);
  std::vector<Place> places;
  bool open = false;
  for (std::size_t i = 0, j = 0; i < a.size() || j < b.size();) {
    if (i < a.size() && j < b.size() && a[i].text == b[j].text) {
      ++i, ++j;
      open = false;
      continue;
    }
    if (!open) places.emplace_back();
    open = true;
    if (j == b.size() || (i < a.size() && length[i + 1][j] >= length[i][j + 1]))
      places.back().a.push_back(a[i++]);
    else
      places.back().b.push_back(b[j++]);
  }
  return places;
}

std::string numbers(const std::vector<Line>& lines) {
  if (lines.size() == 1) return "line " + std::to_string(lines.front().number);
  return "lines " + std::to_string(lines.front().number) + " to " + std::to_string(lines.back().number);
}

std::string lacked(const char* who, const char* whose, const std::vector<Line>& lines) {
  constexpr std::size_t kShown = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(kShown, lines.size()); ++i) text += (i == 0 ? "" : " ") + lines[i].text;
  return std::string(who) + " lacks " + numbers(lines) + " of " + whose + ": " + text +
         (lines.size() > kShown ? " …" : "");
}

std::string in_words(const Place& place) {
  if (place.b.empty()) return lacked("B", "A", place.a);
  if (place.a.empty()) return lacked("A", "B", place.b);
  const bool more = place.a.size() > 1 || place.b.size() > 1;
  return numbers(place.a) + ": " + place.a.front().text + (more ? " …" : "") + " in A, " + place.b.front().text +
         (more ? " …" : "") + " in B";
}

}  // namespace

std::string scene_difference(const std::string& a, const std::string& b) {
  const std::vector<Place> places = places_of(lines_of(a), lines_of(b));
  std::string text;
  for (std::size_t i = 0; i < std::min(kMostPlaces, places.size()); ++i)
    text += (i == 0 ? "" : "; ") + in_words(places[i]);
  if (places.size() > kMostPlaces) text += "; and " + counted(places.size() - kMostPlaces, "more place", "more places");
  return text;
}

}  // namespace telepalp::report
