#include "server/gateway/request/resource_table.h"

#include <algorithm>
#include <array>

#include "server/origin/resources.h"

namespace telepalp::gateway {
namespace {

using keys::Operation;

constexpr std::string_view kPlaysNoForeignPage =
    "this web page is from another site, which may not control a played session. fix: allow the page's scheme and "
    "host: telepalp-server --allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kRecordsNoForeignPage =
    "this web page is from another site, which may not record. fix: allow the page's scheme and host: telepalp-server "
    "--allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kNoReading =
    "this address names no session that was opened for one page. fix: add ?reading=NUMBER of an open page";
constexpr std::string_view kComparesNothing =
    "this server compares no sessions. fix: start telepalp-server with --source session:FILE.mcap and --compare-dir "
    "DIR";
constexpr std::string_view kSetsUpNoForeignPage =
    "this web page is from another site, which may not choose the source. fix: allow the page's scheme and host: "
    "telepalp-server --allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kChoosesNothing =
    "the page of this server does not choose the source. fix: start telepalp-server with another --source";
constexpr std::string_view kExposesNothing =
    "this server shows no camera. fix: choose a camera, or the synthetic patient, as its source";
constexpr std::string_view kMarksNoForeignPage =
    "this web page is from another site, which may not mark moments. fix: allow the page's scheme and host: "
    "telepalp-server --allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kMarksNothing =
    "this server shows no camera, so there is no moment to mark. fix: write a note on the played session: POST "
    "/playback/notes";
constexpr std::string_view kSendsOutNoForeignPage =
    "this web page is from another site, which may not send persons out. fix: allow the page's scheme and host: "
    "telepalp-server --allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kKnowsNobody =
    "this server has no keys, so it knows nobody by name. fix: start telepalp-server with --key FILE";
constexpr std::string_view kOpensNoForeignPage =
    "this web page is from another site, which may not open the room's microphone. fix: allow the page's scheme and "
    "host: telepalp-server --allow-origin ORIGIN, such as https://app.foxglove.dev";
constexpr std::string_view kHasNoRoomVoice =
    "this server has no microphone in the patient's room. fix: start telepalp-server with --voice alsa";
constexpr std::string_view kRecordsNothing =
    "recording from the web page is off on this server. fix: start telepalp-server with --record-dir DIR";

/// A part of a played session. Moving, impairing or noting on it changes what all viewers see.
constexpr ResourceRow played(const origin::StateTopic& state, Operation change_own,
                             std::string_view absent = kNoSession) {
  return {.path = state.topic.name,
          .read = Operation::Watch,
          .change = Operation::Play,
          .change_own = change_own,
          .people = kOnlyForPlayers,
          .pages = kPlaysNoForeignPage,
          .absent = absent,
          .empty_if_absent = false,
          .audited_as = {}};
}

constexpr ResourceRow recorded(const origin::StateTopic& state, Operation read, std::string_view people,
                               std::optional<access::AuditEvent> audited_as) {
  return {.path = state.topic.name,
          .read = read,
          .change = Operation::Record,
          .change_own = Operation::Record,
          .people = people,
          .pages = kRecordsNoForeignPage,
          .absent = kRecordsNothing,
          .empty_if_absent = true,
          .audited_as = audited_as};
}

constexpr ResourceRow set_up(const origin::StateTopic& state, std::string_view absent, access::AuditEvent audited_as) {
  return {.path = state.topic.name,
          .read = Operation::SetUp,
          .change = Operation::SetUp,
          .change_own = Operation::SetUp,
          .people = "only technicians may choose the source and set the camera's exposure",
          .pages = kSetsUpNoForeignPage,
          .absent = absent,
          .empty_if_absent = false,
          .audited_as = audited_as};
}

constexpr std::array kRows{
    played(origin::kPlayback, Operation::Watch),
    played(origin::kEvents, Operation::Watch),
    played(origin::kNetwork, Operation::Watch),
    played(origin::kNotes, Operation::Play),  // they are kept beside the session, for all
    played(origin::kComparison, Operation::Record,
           kComparesNothing),  // it shows another recording, perhaps of another patient
    ResourceRow{.path = origin::kReading.topic.name,
                .read = Operation::Watch,
                .change = Operation::Play,
                .change_own = Operation::Watch,
                .people = kOnlyForPlayers,
                .pages = kPlaysNoForeignPage,
                .absent = kNoReading,
                .empty_if_absent = false,
                .audited_as = {}},
    recorded(origin::kRecording, Operation::Watch, "only doctors, technicians and QA may record",
             access::AuditEvent::Records),
    recorded(origin::kSessions, Operation::Record, "only doctors, technicians and QA may open recorded sessions",
             std::nullopt),  // the server notes each file once it is whole
    set_up(origin::kSource, kChoosesNothing, access::AuditEvent::ChoseSource),
    set_up(origin::kExposure, kExposesNothing, access::AuditEvent::SetExposure),
    ResourceRow{.path = origin::kMarks.topic.name,
                .read = Operation::Watch,
                .change = Operation::Record,
                .change_own = Operation::Record,
                .people = "only doctors, technicians and QA may mark moments",
                .pages = kMarksNoForeignPage,
                .absent = kMarksNothing,
                .empty_if_absent = true,
                .audited_as = {}},  // the mark itself says whose it is
    ResourceRow{.path = origin::kPeople.topic.name,
                .read = Operation::SetUp,
                .change = Operation::SetUp,
                .change_own = Operation::SetUp,
                .people = "only technicians may see who watches, send persons out and take the touch away",
                .pages = kSendsOutNoForeignPage,
                .absent = kKnowsNobody,
                .empty_if_absent = false,
                .audited_as = {}},  // Access notes each command in the audit log by itself
    ResourceRow{.path = origin::kRoomVoice.topic.name,
                .read = Operation::Listen,
                .change = Operation::SpeakAtPatient,
                .change_own = Operation::SpeakAtPatient,
                .people = "only technicians may open the microphone in the patient's room",
                .pages = kOpensNoForeignPage,
                .absent = kHasNoRoomVoice,
                .empty_if_absent = true,
                .audited_as = access::AuditEvent::SetMicrophone},
};

constexpr bool has_row(const origin::StateTopic& state) {
  return std::ranges::find(kRows, state.topic.name, &ResourceRow::path) != kRows.end();
}
static_assert(std::ranges::all_of(origin::kStateTopics, has_row) && kRows.size() == origin::kStateTopics.size(),
              "each state of a resource has its rights here");

}  // namespace

std::span<const ResourceRow> all_resources() noexcept { return kRows; }

const ResourceRow* resource_at(std::string_view path) noexcept {
  const auto found = std::ranges::find(kRows, path, &ResourceRow::path);
  return found == kRows.end() ? nullptr : &*found;
}

}  // namespace telepalp::gateway
