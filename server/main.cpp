#include <boost/asio/io_context.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "proto/keys/secret/passphrase.h"
#include "server/capture/capture_source.h"
#include "server/gateway/gateway.h"
#include "server/gateway/health/metrics.h"
#include "server/gateway/monitoring/health_port.h"
#include "server/meet/site/meet_dialer.h"
#include "server/origin/camera_origin.h"
#include "server/origin/opening_pool.h"
#include "server/origin/people_resource.h"
#include "server/origin/session_shelf.h"
#include "server/origin/source_choice.h"
#include "server/pipeline/depth_options.h"
#include "server/recording/session_recorder.h"
#include "server/relay/publisher.h"
#include "server/relay/relay_options.h"
#include "server/relay/relay_origin.h"
#include "server/server.h"
#include "support/program/address.h"
#include "support/program/default_ports.h"
#include "support/program/ending.h"
#include "support/program/files/ready_file.h"
#include "support/program/files/shipped.h"
#include "support/program/log.h"
#include "support/program/options.h"
#include "support/program/version.h"

namespace {

using namespace telepalp;

constexpr const char* kProgram = "telepalp-server";
constexpr std::string_view kSession = "session:";  // the source that plays a session

void log_line(const std::string& text) { program::log(kProgram, text); }

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "streams a patient to stations, recorders and browsers",
          .positional = {},
          .options = {{"source", "SOURCE",
                       "camera openni2[:URI], recording oni:FILE, images:DIR, pcd:FILE or session:FILE.mcap, "
                       "synthetic[:MODEL], or another server's nats://HOST/SITE",
                       "synthetic"},
                      {"loop", "yes|no", "repeat a recording when it ends", "yes"},
                      {"seconds", "S", "stop after S seconds; 0: never", "0"},
                      {"bind", "ADDRESS", "listen here; a network address needs --key", "127.0.0.1"},
                      {"key", "FILE", "this server's key; clients then need one each"},
                      {"web-cert", "FILE", "certificate that browsers see; default: that of --key"},
                      {"web-key", "FILE", "private key of --web-cert"},
                      {"revoked", "FILE", "list of revoked keys; default: revoked.crl beside --key"},
                      {"audit", "FILE", "log of who did what; default: audit.log beside the key"},
                      {"port", "PORT", "port for stations and recorders; 0: any free one", program::kServerPort},
                      {"http-port", "PORT", "port of the web viewer; 0: any free one; default: none"},
                      {"publish", "URL", "publish for edges, to NATS: nats://HOST/SITE"},
                      {"meet", "HOST[:PORT]", "meeting point that callers dial; default: none"},
                      {"health-port", "PORT", "port of /health and /metrics, plain HTTP; default: none"},
                      {"health-bind", "ADDRESS", "address of --health-port; default: 127.0.0.1"},
                      {.name = "allow-origin",
                       .argument = "ORIGIN",
                       .help = "other site whose pages may open the stream; repeatable",
                       .repeatable = true},
                      {"viewer", "DIR", "the web viewer's files; default: beside this program"},
                      {"record-dir", "DIR", "folder for the web page's recordings; default: none"},
                      {"compare-dir", "DIR", "folder of sessions to compare; default: none"},
                      {"record-key", "FILE", "recorder's key file for --record-dir; needed with --key"},
                      {"ready-file", "FILE", "write the ports to FILE once it listens; default: none"},
                      {"depth-mode", "MODE",
                       "lossless: fast, intra, temporal; near-lossless, for viewing, not touch: bounded", "fast"},
                      {"depth-bound", "LEAST,PER_M2", "error at z m: max(LEAST, PER_M2 z²) mm; default: 1,2.85"},
                      {"key-every", "N", "temporal, bounded: every Nth frame is a key frame", "12"},
                      {"jpeg-quality", "1..100", "quality of colour images", "85"},
                      {"video-rate", "KBIT/S", "rate of colour as video", "800"},
                      {"name", "NAME", "server name that clients show", kProgram}},
          .example = "telepalp-server --source synthetic --seconds 60"};
}

struct Asked {
  std::string source;
  bool loop = true;
  std::chrono::duration<double> seconds{0.0};
  std::filesystem::path ready_file;
  std::optional<access::Access::Options> keys;  // nullopt: no TLS, and peers of this machine only
  server::Server::Options server;
  pipeline::EncodeOptions encode;
  relay::RelayOptions relay;
  std::optional<gateway::GatewayOptions> gateway;               // nullopt: browsers are not served
  std::optional<gateway::HealthPort::Options> health;           // nullopt: no port for monitoring
  std::optional<meet::MeetDialer::Options> meet;                // nullopt: no meeting point
  std::optional<recording::SessionRecorder::Options> recorder;  // nullopt: the web viewer records nothing
  std::filesystem::path compare_folder;                         // empty: the played session is compared with no other
};

Result<bool> yes_or_no(const program::Arguments& arguments, std::string_view option) {
  const std::string text = arguments.text(option);
  if (text == "yes" || text == "no") return text == "yes";
  return Error{
      .what = "'" + text + "' is neither yes nor no", .where = "--" + std::string(option), .fix = "give yes or no"};
}

Error no_effect_without(const std::string& needed, const std::string& option) {
  return {.what = "this option has no effect without --" + needed,
          .where = "--" + option,
          .fix = "add --" + needed + ", or leave --" + option + " out"};
}

Result<std::optional<gateway::GatewayOptions>> gateway_options(const program::Arguments& arguments,
                                                               const std::string& address) {
  if (!arguments.has("http-port")) {
    for (const char* option : {"allow-origin", "viewer"})
      if (arguments.has(option)) return no_effect_without("http-port", option);
    return std::optional<gateway::GatewayOptions>{};
  }
  const Result<std::int64_t> port = arguments.whole("http-port", 0, 65535);
  if (!port) return port.error();
  gateway::GatewayOptions options;
  options.address = address;
  options.port = static_cast<std::uint16_t>(*port);
  options.server_name = arguments.text("name");
  options.log = log_line;
  options.policy.allowed_origins = arguments.all("allow-origin");
  for (const std::string& origin : options.policy.allowed_origins)
    if (const Result<void> exact = gateway::check_origin(origin); !exact) return exact.error();
  options.viewer_files = arguments.text("viewer");
  if (!arguments.has("viewer")) {
    const auto index = program::shipped_file("viewer/index.html");
    if (!index)
      return Error{.what = "the files of the web viewer are not found",
                   .where = "--http-port",
                   .fix = "build the target telepalp_viewer, or name by --viewer the folder with its index.html"};
    options.viewer_files = index->parent_path();
  }
  return std::optional{std::move(options)};
}

Result<std::optional<gateway::HealthPort::Options>> health_options(const program::Arguments& arguments) {
  if (!arguments.has("health-port")) {
    if (arguments.has("health-bind")) return no_effect_without("health-port", "health-bind");
    return std::optional<gateway::HealthPort::Options>{};
  }
  const Result<std::int64_t> port = arguments.whole("health-port", 0, 65535);
  if (!port) return port.error();
  gateway::HealthPort::Options options{.port = static_cast<std::uint16_t>(*port)};
  if (arguments.has("health-bind")) options.address = arguments.text("health-bind");
  return std::optional(std::move(options));
}

Result<std::optional<access::Access::Options>> key_options(const program::Arguments& arguments) {
  for (const auto& [one, other] :
       {std::pair{"web-cert", "web-key"}, std::pair{"web-key", "web-cert"}, std::pair{"web-cert", "http-port"}})
    if (arguments.has(one) && !arguments.has(other)) return no_effect_without(other, one);
  if (arguments.has("key"))
    return std::optional(access::Access::Options{.key = arguments.text("key"),
                                                 .revoked = arguments.text("revoked"),
                                                 .audit = arguments.text("audit"),
                                                 .web_certificate = arguments.text("web-cert"),
                                                 .web_key = arguments.text("web-key"),
                                                 .say = log_line});
  for (const char* option : {"revoked", "audit", "web-cert", "web-key"})
    if (arguments.has(option)) return no_effect_without("key", option);
  return std::optional<access::Access::Options>{};
}

Result<std::optional<meet::MeetDialer::Options>> meet_options(const program::Arguments& arguments) {
  if (!arguments.has("meet")) return std::optional<meet::MeetDialer::Options>{};
  if (!arguments.has("key")) return no_effect_without("key", "meet");
  const Result<program::Address> at = program::parse_address(arguments.text("meet"), "--meet", program::kMeetPort);
  if (!at) return at.error();
  return std::optional(
      meet::MeetDialer::Options{.host = at->host, .port = at->port, .key = {}, .on_caller = {}, .log = log_line});
}

Result<std::optional<recording::SessionRecorder::Options>> recorder_options(const program::Arguments& arguments) {
  std::optional<recording::SessionRecorder::Options> none;
  const auto wrong = [](const char* what, const char* where, const char* fix) {
    return Error{.what = what, .where = where, .fix = fix};
  };
  if (!arguments.has("record-dir")) {
    if (!arguments.has("record-key")) return none;
    return no_effect_without("record-dir", "record-key");
  }
  if (!arguments.has("http-port"))
    return wrong("this option is for recordings from the web page, and the web page is off", "--record-dir",
                 "add --http-port PORT, or run telepalp-record");
  if (arguments.has("key") && !arguments.has("record-key"))
    return wrong("this server requires keys, so the recorder needs a key, too", "--record-dir",
                 "add --record-key FILE, made by telepalp-keys client --role technician");
  return std::optional(recording::SessionRecorder::Options{.folder = arguments.text("record-dir"),
                                                           .program = program::sibling_program("telepalp-record"),
                                                           .key = arguments.text("record-key"),
                                                           .server = {}});
}

Result<std::filesystem::path> compare_option(const program::Arguments& arguments) {
  if (!arguments.has("compare-dir")) return std::filesystem::path();
  if (!arguments.has("http-port") || !arguments.text("source").starts_with(kSession))
    return Error{
        .what = "only the web page of a played session shows a comparison, and this server serves no such page",
        .where = "--compare-dir",
        .fix = "add --source session:FILE.mcap and --http-port PORT, or run telepalp-report A B"};
  return std::filesystem::path(arguments.text("compare-dir"));
}

Result<Asked> read_asked(const program::Arguments& arguments) {
  const Result<relay::RelayOptions> relay = relay::relay_options_of(arguments);
  if (!relay) return relay.error();
  if (!relay->shows)
    if (const Result<void> source = capture::check_source(arguments.text("source")); !source) return source.error();
  const Result<bool> loop = yes_or_no(arguments, "loop");
  if (!loop) return loop.error();
  const Result<double> seconds = arguments.number("seconds", 0.0, 1e7);
  if (!seconds) return seconds.error();
  const Result<std::int64_t> port = arguments.whole("port", 0, 65535);
  if (!port) return port.error();
  const Result<std::int64_t> quality = arguments.whole("jpeg-quality", 1, 100);
  const Result<std::int64_t> video_rate = arguments.whole("video-rate", 50, 50'000);
  if (!quality) return quality.error();
  if (!video_rate) return video_rate.error();
  const Result<codec::DepthStreamSettings> depth =
      pipeline::read_depth_settings(arguments, {.mode = "depth-mode", .bound = "depth-bound"});
  if (!depth) return depth.error();
  const Result<boost::asio::ip::address> address = hub::listening_address(arguments.text("bind"), arguments.has("key"));
  if (!address) return address.error();
  const Result<std::optional<gateway::GatewayOptions>> gateway = gateway_options(arguments, address->to_string());
  if (!gateway) return gateway.error();
  const Result<std::optional<gateway::HealthPort::Options>> health = health_options(arguments);
  if (!health) return health.error();
  const Result<std::optional<meet::MeetDialer::Options>> meet = meet_options(arguments);
  if (!meet) return meet.error();
  const Result<std::optional<access::Access::Options>> keys = key_options(arguments);
  if (!keys) return keys.error();
  const Result<std::optional<recording::SessionRecorder::Options>> recorder = recorder_options(arguments);
  if (!recorder) return recorder.error();
  const Result<std::filesystem::path> compare_folder = compare_option(arguments);
  if (!compare_folder) return compare_folder.error();
  return Asked{.source = arguments.text("source"),
               .loop = *loop,
               .seconds = std::chrono::duration<double>(*seconds),
               .ready_file = arguments.text("ready-file"),
               .keys = *keys,
               .server = {.name = arguments.text("name"),
                          .bind = address->to_string(),
                          .port = static_cast<std::uint16_t>(*port),
                          .software = program::software(kProgram),
                          .log = log_line},
               .encode = {.depth = *depth,
                          .jpeg_quality = static_cast<int>(*quality),
                          .video_kbit_per_s = static_cast<int>(*video_rate)},
               .relay = *relay,
               .gateway = *gateway,
               .health = *health,
               .meet = *meet,
               .recorder = *recorder,
               .compare_folder = *compare_folder};
}

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

/// All parts of a running server. The later ones use the earlier ones.
struct Parts {
  boost::asio::io_context io;
  std::unique_ptr<server::Server> server;
  origin::OpeningPool opening{io};
  std::optional<origin::SessionShelf> shelf;
  std::optional<origin::SourceChoice> sources;           // nullopt: no browsers
  std::unique_ptr<origin::Origin> origin;                // handed to the server at the start
  std::unique_ptr<recording::SessionRecorder> recorder;  // null: visitors may not record
  std::unique_ptr<gateway::Gateway> gateway;             // null: no browsers
  std::unique_ptr<gateway::HealthPort> health;           // null: no port for monitoring
  std::unique_ptr<meet::MeetDialer> meet;                // null: no meeting point
  std::unique_ptr<relay::Publisher> publisher;           // null: for no edges
};

std::string ports_text(const Parts& parts) {
  std::string text = "port=" + std::to_string(parts.server->port()) + "\n";
  if (parts.gateway) text += "http_port=" + std::to_string(parts.gateway->port()) + "\n";
  if (parts.health) text += "health_port=" + std::to_string(parts.health->port()) + "\n";
  return text;
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
                parts.gateway->offer(chosen->offer());
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
  Result<std::unique_ptr<server::Server>> listening = server::Server::listen(parts.io, asked.server);
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
std::string problem(const Parts& parts, const access::Access& access) {
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

Result<void> open_gateway(Parts& parts, Asked& asked) {
  if (!asked.gateway) return {};
  server::Server& server = *parts.server;
  asked.gateway->access = asked.server.access;
  asked.gateway->problem = [&parts, access = asked.server.access] { return problem(parts, *access); };
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
  asked.health->problem = [&parts, access = asked.server.access] { return problem(parts, *access); };
  asked.health->metrics = [&parts, access = asked.server.access] {
    return gateway::metrics_text(parts.server->hub(), access->counts(), parts.server->datagram_counts(),
                                 {.browsers = parts.gateway ? parts.gateway->connections() : 0,
                                  .touch_is_held = access->touch().holder(std::chrono::steady_clock::now()).has_value(),
                                  .is_healthy = problem(parts, *access).empty()});
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

/// Ends a server once: on a signal, after a time, or when its source has ended.
class Ending {
 public:
  explicit Ending(Parts& parts) : parts_(parts), signals_(parts.io, SIGINT, SIGTERM), time_is_up_(parts.io) {
    signals_.async_wait([this](const boost::system::error_code& cancelled, int) {
      if (!cancelled) stop("Ctrl-C or another program stopped the server");
    });
  }

  void end_after(std::chrono::duration<double> time) {
    time_is_up_.expires_after(std::chrono::duration_cast<std::chrono::steady_clock::duration>(time));
    time_is_up_.async_wait([this](const boost::system::error_code& cancelled) {
      if (!cancelled) stop("the time of --seconds is over");
    });
  }

  void stop(const std::string& reason) {
    if (std::exchange(stopped_, true)) return;
    program::log(kProgram, "stopping: " + reason);
    boost::system::error_code ignored;
    signals_.cancel(ignored);  // not clear(): the handlers stay installed, so a second signal has no further effect
    program::end_within(program::kTimeToEnd,
                        "telepalp-server: the camera or another part did not stop within 5 s; the program ends without "
                        "closing the camera");
    time_is_up_.cancel();
    parts_.meet.reset();
    parts_.publisher.reset();
    parts_.health.reset();
    parts_.gateway.reset();
    parts_.recorder.reset();  // before the server ends, so that the recorder completes its file; it gets at most 3 s
    parts_.server->stop(reason);
  }

 private:
  Parts& parts_;
  boost::asio::signal_set signals_;
  boost::asio::steady_timer time_is_up_;
  bool stopped_ = false;
};

void begin(Parts& parts, const Asked& asked, std::function<void()> on_end) {
  parts.server->start(std::move(parts.origin), std::move(on_end));
  program::log(kProgram, "listening on " + program::to_text({asked.server.bind, parts.server->port()}) +
                             (asked.keys ? ", TLS with keys" : ""));
  asked.server.access->note_own(access::AuditEvent::Started, "port=" + std::to_string(parts.server->port()));
  if (parts.gateway) program::log(kProgram, "viewer at " + parts.gateway->url());
}

int run(Asked asked) {
  Parts parts;
  for (const auto open_part :
       {open_upstream, open_server, open_recorder, open_gateway, open_health, open_meet, open_publisher})
    if (const Result<void> opened = open_part(parts, asked); !opened) return program::fail(opened.error());
  Ending ending(parts);
  if (asked.seconds.count() > 0.0) ending.end_after(asked.seconds);
  begin(parts, asked, [&ending] { ending.stop("the source has ended"); });
  std::optional<Error> revoked;
  asked.server.access->on_revoked([&](const Error& why) {
    revoked = why;
    ending.stop(why.what);
  });
  const Result<void> written = program::write_ready_file(asked.ready_file, ports_text(parts));
  if (!written) return program::fail(written.error());
  parts.io.run();
  asked.server.access->note_own(access::AuditEvent::Stopped, {});
  program::log(kProgram, parts.server->summary());
  return revoked ? program::fail(*revoked) : program::kDone;
}

int run_asked(const program::Arguments& arguments) {
  const Result<Asked> asked = read_asked(arguments);
  if (!asked) return program::fail(asked.error(), program::kAskedWrongly);
  return run(*asked);
}

}  // namespace

int main(int argc, char** argv) {
  program::say_when_stopped("telepalp-server: stopped before it listened; nothing was sent");
  return program::run_program(usage(), argc, argv, run_asked);
}
