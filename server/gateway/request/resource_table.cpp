#include "server/gateway/request/resource_table.h"

#include <algorithm>
#include <array>

#include "server/origin/origin.h"

namespace telepalp::gateway {
namespace {

using keys::Operation;

constexpr std::string_view kPlaysNoForeignPage =
    "this web page is from another site, which may not control a played session. fix: allow the page's scheme and "
    "host: telepalp-server --allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kRecordsNoForeignPage =
    "this web page is from another site, which may not record. fix: allow the page's scheme and host: telepalp-server "
    "--allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kRecordsNothing =
    "recording from the web page is off on this server. fix: start telepalp-server with --record-dir DIR";

/// A part of a played session. Moving, impairing or noting on it changes what all viewers see.
constexpr ResourceRow played(std::string_view path, Operation change_own) {
  return {.path = path,
          .read = Operation::Watch,
          .change = Operation::Play,
          .change_own = change_own,
          .people = kOnlyForPlayers,
          .pages = kPlaysNoForeignPage,
          .absent = kNoSession,
          .empty_if_absent = false,
          .is_audited = false};
}

constexpr ResourceRow recorded(std::string_view path, Operation read, std::string_view people, bool is_audited) {
  return {.path = path,
          .read = read,
          .change = Operation::Record,
          .change_own = Operation::Record,
          .people = people,
          .pages = kRecordsNoForeignPage,
          .absent = kRecordsNothing,
          .empty_if_absent = true,
          .is_audited = is_audited};
}

constexpr std::array kRows{
    played(origin::kPlaybackPath, Operation::Watch),
    played(origin::kEventsPath, Operation::Watch),
    played(origin::kNetworkPath, Operation::Watch),
    played(origin::kNotesPath, Operation::Play),  // they are kept beside the session, for all
    played(origin::kComparisonPath, Operation::Record),  // it shows another recording, perhaps of another patient
    recorded(origin::kRecordingPath, Operation::Watch, "only doctors, technicians and QA may record", true),
    recorded(origin::kSessionsPath, Operation::Record, "only doctors, technicians and QA may open recorded sessions",
             false),
};

}  // namespace

const ResourceRow* resource_at(std::string_view path) noexcept {
  const auto found = std::ranges::find(kRows, path, &ResourceRow::path);
  return found == kRows.end() ? nullptr : &*found;
}

}  // namespace telepalp::gateway
