#include "server/command_line.h"

#include <utility>

#include "server/capture/capture_source.h"
#include "server/hub/peer_listener.h"
#include "server/pipeline/depth_options.h"
#include "support/program/address.h"
#include "support/program/default_ports.h"
#include "support/program/files/shipped.h"
#include "support/program/log.h"
#include "support/program/version.h"

namespace telepalp::server {

void log_line(const std::string& text) { program::log(kProgram, text); }

program::Usage usage() {
  return {.program = kProgram,
          .purpose = "streams a patient to stations, recorders and browsers",
          .positional = {},
          .options = {{"source", "SOURCE",
                       "openni2[:URI], oni:, pcd: or session:FILE, images:DIR, another server's nats://HOST/SITE, or "
                       "synthetic[:MODEL]",
                       "synthetic"},
                      {"check", "", "look at keys, ports, files and disks; start nothing"},
                      {"loop", "yes|no", "repeat a recording when it ends", "yes"},
                      {"seconds", "S", "stop after S seconds; 0: never", "0"},
                      {"bind", "ADDRESS", "listen here; a network address needs --key", "127.0.0.1"},
                      {"key", "FILE", "this server's key; clients then need one each"},
                      {"web-cert", "FILE", "certificate that browsers see; default: that of --key"},
                      {"web-key", "FILE", "private key of --web-cert"},
                      {"sign-in", "FILE", "log-in of a hospital (OpenID Connect) for browsers"},
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
                      {"voice", "DEVICE", "the room's sound: alsa[:NAME], muted; open:alsa[:NAME]"},
                      {"compare-dir", "DIR", "folder of sessions to compare; default: none"},
                      {"record-key", "FILE", "recorder's key file for --record-dir; needed with --key"},
                      {"ready-file", "FILE", "write the ports to FILE once it listens; default: none"},
                      {"depth-mode", "MODE", "fast, intra, temporal; to view alone: bounded", "fast"},
                      {"depth-bound", "A,B", "error at z m: max(A, B z²) mm; default: 1,2.85"},
                      {"key-every", "N", "temporal, bounded: every Nth frame is a key frame", "12"},
                      {"jpeg-quality", "1..100", "quality of colour images", "85"},
                      {"video-rate", "KBIT/S", "rate of colour as video", "800"},
                      {"name", "NAME", "server name that clients show", kProgram}},
          .example = "telepalp-server --source synthetic --seconds 60"};
}

namespace {

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
  for (const auto& [one, other] : {std::pair{"web-cert", "web-key"}, std::pair{"web-key", "web-cert"},
                                   std::pair{"web-cert", "http-port"}, std::pair{"sign-in", "http-port"}})
    if (arguments.has(one) && !arguments.has(other)) return no_effect_without(other, one);
  if (arguments.has("key"))
    return std::optional(access::Access::Options{.key = arguments.text("key"),
                                                 .revoked = arguments.text("revoked"),
                                                 .audit = arguments.text("audit"),
                                                 .web_certificate = arguments.text("web-cert"),
                                                 .web_key = arguments.text("web-key"),
                                                 .say = log_line});
  for (const char* option : {"revoked", "audit", "web-cert", "web-key", "sign-in"})
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

Result<std::optional<voice::RoomDevice>> voice_option(const program::Arguments& arguments) {
  if (!arguments.has("voice")) return std::optional<voice::RoomDevice>{};
  const Result<voice::RoomDevice> device = voice::room_device(arguments.text("voice"));
  if (!device) return device.error();
  return std::optional(*device);
}

}  // namespace

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
  const Result<std::optional<voice::RoomDevice>> room_voice = voice_option(arguments);
  if (!room_voice) return room_voice.error();
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
               .sign_in = arguments.text("sign-in"),
               .health = *health,
               .meet = *meet,
               .recorder = *recorder,
               .room_voice = *room_voice,
               .compare_folder = *compare_folder};
}

}  // namespace telepalp::server
