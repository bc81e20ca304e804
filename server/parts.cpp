#include "server/parts.h"

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <utility>
#include <vector>

#include "proto/keys/secret/passphrase.h"
#include "server/capture/capture_source.h"
#include "server/gateway/health/metrics.h"
#include "server/origin/camera_origin.h"
#include "server/origin/people_resource.h"
#include "server/relay/relay_origin.h"
#include "support/program/address.h"

namespace telepalp::server {
namespace {

/// The origin that --source names.
Result<std::unique_ptr<origin::Origin>> open(const Asked& asked, origin::SessionShelf& shelf,
                                             boost::asio::io_context& io, const wire::SessionClock& clock) {
  if (asked.source.starts_with(kSession)) return shelf.play(asked.source.substr(kSession.size()), asked.loop);
  auto source = capture::open_source(asked.source, {.clock = clock, .loop = asked.loop, .paced = true});
  if (!source) return source.error();
  return origin::of_camera(io, std::move(source).value(), asked.source, asked.encode, clock);
}

/// Where a recorder on this machine reaches the server: at its address, or on loopback when it listens everywhere.
std::string own_address(const std::string& bind, std::uint16_t port) {
  const std::string host = bind == "0.0.0.0" ? "127.0.0.1" : bind == "::" ? "::1" : bind;
  return program::to_text({host, port});
}

/// Lets the gateway's visitors begin and end recordings.
origin::Resource recording_resource(recording::SessionRecorder& recorder) {
  return {.state = [&recorder] { return origin::state_message(recorder.state()); },
          .change = origin::at_once([&recorder](const std::string& json, const std::string&) -> Result<void> {
            const Result<msg::RecordingCommand> command = recording::read_command(json);
            if (!command) return command.error();
            return recorder.apply(*command, std::chrono::system_clock::now());
          })};
}

/// Opens a source that a technician has chosen: a camera or the synthetic patient, or a recording of the folder.
void open_later(Parts& parts, const Asked& asked, const std::string& name, origin::Progress progress,
                origin::OpenedOrigin done) {
  const bool is_first = name == asked.source;
  if (!is_first && name.starts_with(kSession))
    return parts.shelf->play_later(name.substr(kSession.size()), std::move(progress), done);
  if (is_first && name.starts_with(kSession)) return parts.shelf->play_again(std::move(progress), done);
  using Source = std::unique_ptr<capture::CaptureSource>;
  const capture::SourceOptions options{.clock = parts.server->clock(), .loop = asked.loop, .paced = true};
  parts.opening.run<Source>(
      [name, options](const origin::Progress&) { return capture::open_source(name, options); }, std::move(progress),
      [&parts, &asked, name, done](Result<Source> source) {
        if (!source) return done(source.error());
        parts.shelf->play_nothing();
        done(origin::of_camera(parts.io, std::move(source).value(), name, asked.encode, parts.server->clock()));
      });
}

std::vector<origin::SourceChoice::Source> found_cameras() {
  std::vector<origin::SourceChoice::Source> found;
  for (const capture::FoundCamera& camera : capture::find_cameras()) found.push_back({camera.spec, camera.name});
  return found;
}

/// Lets technicians choose the source on the page.
void open_sources(Parts& parts, const Asked& asked) {
  parts.sources.emplace(
      parts.opening,
      origin::SourceChoice::Parts{
          .first = {asked.source, "as the server was started"},
          .recordings =
              [&parts] {
                std::vector<origin::SourceChoice::Source> all;
                const msg::SessionList sessions = parts.shelf->list();
                for (const auto& session : sessions.sessions())
                  all.push_back({std::string(kSession) + session.name(), "a recording"});
                return all;
              },
          .look_for_cameras = found_cameras,
          .open =
              [&parts, &asked](const std::string& name, origin::Progress progress, origin::OpenedOrigin done) {
                open_later(parts, asked, name, std::move(progress), std::move(done));
              },
          .show =
              [&parts](std::unique_ptr<origin::Origin> chosen) {
                if (!parts.gateway) return;  // the server ends
                origin::Offer offer = chosen->offer();
                if (parts.voice) parts.voice->session_is_played(bool(offer.playback));
                parts.gateway->offer(std::move(offer));
                parts.server->replace(std::move(chosen));
              }});
}

/// Lets the gateway's visitors see and change the origin, record, and open recorded sessions for themselves.
void offer(gateway::GatewayOptions& options, Parts& parts) {
  origin::SessionShelf& shelf = *parts.shelf;
  recording::SessionRecorder* const recorder = parts.recorder.get();
  options.offer = parts.origin->offer();
  options.resources[origin::kSource.topic.name] = parts.sources->resource();
  if (options.access->has_keys())
    options.resources[origin::kPeople.topic.name] = origin::people_resource(*options.access);
  if (parts.voice) options.resources[origin::kRoomVoice.topic.name] = parts.voice->resource();
  options.open_session = [&shelf](const origin::ReadingSpec& asked, origin::Progress progress,
                                  const origin::OpenedOrigin& done) {
    shelf.read_alone(asked, std::move(progress), done);
  };
  if (recorder == nullptr) return;
  options.resources[origin::kRecording.topic.name] = recording_resource(*recorder);
  options.resources[origin::kSessions.topic.name] = {
      .state = [&shelf] { return origin::state_message(shelf.list()); },
      .change = [&shelf](const std::string& json, const std::string& who,
                         origin::Resource::Done done) { shelf.take(json, who, std::move(done)); }};
}

/// Of an edge: connects to the cluster, whose session clock the server takes over.
Result<void> open_upstream(Parts& parts, Asked& asked) {
  if (!asked.relay.shows) return {};
  Result<relay::Upstream> upstream =
      relay::connect_upstream(parts.io, {.address = *asked.relay.shows, .log = log_line});
  if (!upstream) return upstream.error();
  asked.server.clock_upstream = upstream->clock;
  parts.origin = std::move(upstream->origin);
  char text[120];
  std::snprintf(text, sizeof text, "edge of %s: its session clock is known to within %.2f ms",
                relay::in_words(*asked.relay.shows).c_str(), to_milliseconds(upstream->clock_error));
  log_line(text);
  return {};
}

/// Publishes what the server distributes, for edges.
Result<void> open_publisher(Parts& parts, Asked& asked) {
  if (!asked.relay.publishes) return {};
  auto opened = relay::Publisher::open(parts.io, parts.server->hub(), parts.server->clock(),
                                       {.address = *asked.relay.publishes, .log = log_line});
  if (!opened) return opened.error();
  parts.publisher = std::move(opened).value();
  const std::string to = relay::in_words(*asked.relay.publishes);
  asked.server.access->note_own(access::AuditEvent::Joined, "program=relay to=" + to);
  log_line("publishes for edges at " + to);
  return {};
}

Result<void> open_server(Parts& parts, Asked& asked) {
  if (asked.keys) {
    auto access = access::Access::with_key(*asked.keys);
    if (!access) return access.error();
    asked.server.access = std::move(access).value();
  }
  asked.server.relays = [&parts] { return parts.meet ? parts.meet->relays() : std::vector<msg::IceRelay>{}; };
  Result<std::unique_ptr<Server>> listening = Server::listen(parts.io, asked.server);
  if (!listening) return listening.error();
  parts.server = std::move(listening).value();
  parts.shelf.emplace(
      parts.io, parts.server->clock(), parts.opening,
      origin::SessionShelf::Options{.recordings = asked.recorder ? asked.recorder->folder : std::filesystem::path(),
                                    .compared = asked.compare_folder,
                                    .say = log_line,
                                    .on_brought = [access = asked.server.access](const std::string& text) {
                                      access->note_own(access::AuditEvent::BroughtSession, text + " program=browser");
                                    }});
  if (parts.origin) return {};  // of an edge
  Result<std::unique_ptr<origin::Origin>> opened = open(asked, *parts.shelf, parts.io, parts.server->clock());
  if (!opened) return opened.error();
  parts.origin = std::move(opened).value();
  return {};
}

/// Why the health check fails; empty: healthy.
std::string health_problem(const Parts& parts, const access::Access& access) {
  const std::string of_server = parts.server->problem();
  return of_server.empty() ? access.alarm() : of_server;
}

Result<void> open_recorder(Parts& parts, Asked& asked) {
  if (!asked.recorder) return {};
  // Told at the start, and not when a doctor presses Record. The patient can be examined without a recording.
  const auto key =
      keys::load_client_key(asked.recorder->key, std::chrono::system_clock::now(), keys::passphrase_of_environment);
  if (!key) log_line("recordings from the web page will fail: " + to_string(key.error()));
  asked.recorder->server = own_address(asked.server.bind, parts.server->port());
  auto opened = recording::SessionRecorder::open(*asked.recorder);
  if (!opened) return opened.error();
  parts.recorder = std::move(opened).value();
  return {};
}

/// Before the gateway, whose visitors open the microphone and speak at the same side.
Result<void> open_voice(Parts& parts, Asked& asked) {
  if (!asked.room_voice) return {};
  auto floor = asked.gateway ? asked.gateway->patient_floor : std::make_shared<voice::VoiceFloor>();
  parts.voice = std::make_unique<voice::RoomVoice>(parts.io, parts.server->hub(), parts.server->clock(),
                                                   voice::RoomVoice::Options{.device = asked.room_voice->name,
                                                                             .is_open = asked.room_voice->is_open,
                                                                             .floor = std::move(floor),
                                                                             .log = log_line});
  parts.voice->session_is_played(bool(parts.origin->offer().playback));
  if (asked.gateway) asked.gateway->more_metrics = [&parts] { return parts.voice ? parts.voice->metrics() : ""; };
  return {};
}

Result<void> open_hospital(Parts& parts, Asked& asked) {
  if (!asked.gateway || asked.sign_in.empty()) return {};
  Result<oidc::Settings> settings = oidc::read_settings(asked.sign_in);
  if (!settings) return settings.error();
  log_line("browsers sign in at " + settings->issuer + ", which leads them back to " + settings->back());
  parts.hospital = std::make_unique<oidc::HospitalSignIn>(parts.io, std::move(settings).value(), log_line);
  asked.gateway->hospital = parts.hospital.get();
  return {};
}

Result<void> open_gateway(Parts& parts, Asked& asked) {
  if (!asked.gateway) return {};
  Server& server = *parts.server;
  asked.gateway->access = asked.server.access;
  asked.gateway->problem = [&parts, access = asked.server.access] { return health_problem(parts, *access); };
  asked.gateway->datagrams = [&server] { return server.datagram_counts(); };
  open_sources(parts, asked);
  offer(*asked.gateway, parts);
  auto listens = gateway::Gateway::open(
      parts.io, server.hub(), [&server] { return server.clock().now(); }, *asked.gateway);
  if (!listens) return listens.error();
  parts.gateway = std::move(listens).value();
  return {};
}

Result<void> open_health(Parts& parts, Asked& asked) {
  if (!asked.health) return {};
  asked.health->problem = [&parts, access = asked.server.access] { return health_problem(parts, *access); };
  asked.health->metrics = [&parts, access = asked.server.access] {
    return gateway::metrics_text(parts.server->hub(), access->counts(), parts.server->datagram_counts(),
                                 {.browsers = parts.gateway ? parts.gateway->connections() : 0,
                                  .touch_is_held = access->touch().holder(std::chrono::steady_clock::now()).has_value(),
                                  .is_healthy = health_problem(parts, *access).empty()}) +
           (parts.voice ? parts.voice->metrics() : "");
  };
  auto listens = gateway::HealthPort::open(parts.io, *asked.health);
  if (!listens) return listens.error();
  parts.health = std::move(listens).value();
  return {};
}

/// Lets callers come in through the meeting point.
Result<void> open_meet(Parts& parts, Asked& asked) {
  if (!asked.meet) return {};
  asked.meet->key = asked.server.access->key();
  asked.meet->takes = [&parts](const meet::MeetDialer::Caller& caller) { return !caller.is_browser || parts.gateway; };
  asked.meet->on_caller = [&parts](boost::asio::ip::tcp::socket socket, const meet::MeetDialer::Caller& caller) {
    if (!caller.is_browser)
      parts.server->admit(std::move(socket));
    else if (parts.gateway)
      parts.gateway->admit(std::move(socket));
  };
  auto dialer = meet::MeetDialer::start(parts.io, *asked.meet);
  if (!dialer) return dialer.error();
  parts.meet = std::move(dialer).value();
  return {};
}

}  // namespace

Result<void> open_parts(Parts& parts, Asked& asked) {
  for (const auto open_part : {open_upstream, open_server, open_recorder, open_voice, open_hospital, open_gateway,
                               open_health, open_meet, open_publisher})
    if (const Result<void> opened = open_part(parts, asked); !opened) return opened.error();
  return {};
}

}  // namespace telepalp::server
