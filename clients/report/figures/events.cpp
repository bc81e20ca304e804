#include "clients/report/figures/events.h"

#include "clients/report/figures/html.h"
#include "proto/words/counted.h"
#include "proto/words/phase_names.h"
#include "support/plot/number.h"

namespace telepalp::report {
namespace {

using Rows = std::vector<std::vector<std::string>>;

constexpr std::size_t kMostShown = 60;    // of the events that are shown at once
constexpr std::size_t kMostFolded = 500;  // changes of phase

/// A station of an older version has other words in its text, so a change of phase is told by its two phases.
std::string words_of(const msg::StationEvent& event) {
  if (event.kind() != msg::EVENT_KIND_PHASE) return event.text();
  if (event.from() == msg::PHASE_UNSPECIFIED)
    return "The station begins in the state: " + std::string(phase_name(static_cast<int>(event.to())).words);
  return change_in_words(static_cast<int>(event.from()), static_cast<int>(event.to()));
}

std::string shown(const Rows& rows, std::size_t most) {
  Rows first = rows;
  if (first.size() > most) first.resize(most);
  const std::string rest = rows.size() > most ? "<p>" + std::to_string(rows.size() - most) + " more follow.</p>\n" : "";
  return table({"time", "event"}, first, Cells::Words) + rest;
}

}  // namespace

std::string events_section(const Session& session) {
  Rows changes, others;
  for (const msg::StationEvent& event : session.events) {
    const auto since_ns = static_cast<std::int64_t>(event.stamp_ns()) - session.first_ns.value_or(0);
    Rows& rows = event.kind() == msg::EVENT_KIND_PHASE ? changes : others;
    rows.push_back({plot::number(static_cast<double>(since_ns) * 1e-9, 3) + " s", words_of(event)});
  }
  if (changes.empty() && others.empty()) return "";
  std::string content = others.empty() ? "" : shown(others, kMostShown);
  if (!changes.empty())
    content += "<details><summary>" + counted(changes.size(), "change", "changes") + " of state</summary>\n" +
               shown(changes, kMostFolded) + "</details>\n";
  return section("Events", "What the station told, in order. Times count from the session's beginning.", content);
}

}  // namespace telepalp::report
