#include "tests/bench/pipeline_bench.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <fstream>

#include "messages/station.pb.h"
#include "proto/keys/authority.h"
#include "proto/wire/client/client_link.h"
#include "support/program/files/shipped.h"
#include "tests/bench/distribution.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
namespace fs = std::filesystem;

/// The messages that a subscriber gets in a run.
struct Heard {
  Distribution encode_ms;
  Distribution transfer_ms;
  Distribution decode_ms;
  Distribution build_ms;
  Distribution touchable_ms;
  Distribution late_us;
  Distribution work_us;
  msg::StationStats stats;
  std::uint64_t seconds_by_datagram = 0;  ///< seconds in which the station's images came by datagram
  std::uint64_t seconds_by_tcp = 0;

  void surface(const msg::SurfaceReport& report) {
    const auto ms = [](std::uint64_t from, std::uint64_t to) {
      return (static_cast<double>(to) - static_cast<double>(from)) * 1e-6;
    };
    encode_ms.add(ms(report.captured_ns(), report.encoded_ns()));
    transfer_ms.add(ms(report.encoded_ns(), report.received_ns()));
    decode_ms.add(ms(report.received_ns(), report.decoded_ns()));
    build_ms.add(ms(report.decoded_ns(), report.touchable_ns()));
    touchable_ms.add(ms(report.captured_ns(), report.touchable_ns()));
  }
  void server(const msg::ServerStats& server) {
    for (const auto& subscriber : server.subscribers())
      if (subscriber.name() == "telepalp-station") ++(subscriber.by_datagram() ? seconds_by_datagram : seconds_by_tcp);
  }
  void ticks(const msg::StationTicks& ticks) {
    for (const std::uint32_t late_ns : ticks.late_ns()) late_us.add(late_ns * 1e-3);
    for (const float us : ticks.work_us()) work_us.add(us);
  }
};

template <class Proto, class Then>
void parsed(const wire::Message& message, const wire::Topic& topic, Then then) {
  Proto proto;
  if (message.topic.name == topic.name && proto.ParseFromString(*message.payload)) then(proto);
}

/// Keys for the server, the station and the listener, made for one run.
struct RunKeys {
  fs::path server;
  fs::path station;
  std::shared_ptr<const keys::KeyFile> listener;
};

Result<RunKeys> make_keys(const fs::path& folder) {
  const keys::WallTime now = std::chrono::system_clock::now();
  const auto authority = keys::Authority::create("bench", now, std::chrono::days(1));
  if (!authority) return authority.error();
  const auto server = authority->server_key({.name = "server", .now = now}, {"127.0.0.1"});
  const auto station = authority->client_key({.name = "station", .role = keys::Role::Doctor, .now = now});
  const auto listener = authority->client_key({.name = "listener", .role = keys::Role::Viewer, .now = now});
  const auto revoked = authority->revocation_list({}, now);
  for (const Result<std::string>* key : {&server, &station, &listener, &revoked})
    if (!*key) return key->error();
  const Result<keys::KeyFile> read = keys::read_key(*listener, "listener.key");
  if (!read) return read.error();
  RunKeys made{folder / "server.key", folder / "station.key", std::make_shared<const keys::KeyFile>(*read)};
  for (const auto& [file, text] :
       {std::pair{made.server, *server}, {made.station, *station}, {folder / "revoked.crl", *revoked}}) {
    std::ofstream(file) << text;
    fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  }
  return made;
}

/// Listens at `port` until `station` has ended.
Heard listen(std::uint16_t port, std::shared_ptr<const keys::KeyFile> key, support::ChildProcess& station,
             std::chrono::milliseconds patience) {
  Heard heard;
  boost::asio::io_context io(1);
  wire::ClientLink link(
      io,
      {.port = port,
       .name = "telepalp-bench",
       .key = std::move(key),
       .subscribes = {"/station/*", "/server/stats"},
       .publishes = {}},
      {.on_message =
           [&](const wire::Message& message) {
             parsed<msg::SurfaceReport>(message, wire::kStationSurface, [&](const auto& m) { heard.surface(m); });
             parsed<msg::StationTicks>(message, wire::kStationTicks, [&](const auto& m) { heard.ticks(m); });
             parsed<msg::ServerStats>(message, wire::kServerStats, [&](const auto& m) { heard.server(m); });
             parsed<msg::StationStats>(message, wire::kStationStats, [&](const auto& m) { heard.stats = m; });
           },
       .on_state = [](wire::LinkState, const std::string&) {}});
  link.start();
  const auto until = std::chrono::steady_clock::now() + patience;
  while (!station.wait(0ms) && std::chrono::steady_clock::now() < until) io.run_for(100ms);
  io.run_for(200ms);  // the last messages of a station that has just ended
  link.stop();
  io.run_for(600ms);
  return heard;
}

void stage(Report& report, const std::string& name, const Distribution& of) {
  report.rows.push_back(measured(name + "_ms.p50", of.p50(), "ms"));
  report.rows.push_back(measured(name + "_ms.p99", of.p99(), "ms"));
}

/// The reach is that of a recording, which costs no drawing: the synthetic patient is drawn on the same processor.
void stages(Report& report, const Heard& heard, bool of_a_recording) {
  stage(report, "capture_to_encoded", heard.encode_ms);
  stage(report, "encoded_to_received", heard.transfer_ms);
  stage(report, "received_to_decoded", heard.decode_ms);
  stage(report, "decoded_to_touchable", heard.build_ms);
  if (!of_a_recording) return stage(report, "capture_to_touchable", heard.touchable_ms);
  report.rows.push_back(at_most("capture_to_touchable_ms.p50", heard.touchable_ms.p50(), "ms", 8.0));
  report.rows.push_back(at_most("capture_to_touchable_ms.p99", heard.touchable_ms.p99(), "ms", 15.0));
}

Report report_of(const Heard& heard, bool of_a_recording) {
  Report report{.bench = "pipeline", .rows = {}, .notes = {}};
  stages(report, heard, of_a_recording);
  const double seconds = static_cast<double>(heard.seconds_by_datagram + heard.seconds_by_tcp);
  report.rows.push_back(at_least("images_by_sealed_datagram",
                                 100.0 * static_cast<double>(heard.seconds_by_datagram) / std::max(seconds, 1.0),
                                 "% of seconds", 75.0));
  for (const auto& [name, of] :
       {std::pair{"tick_work_us", &heard.work_us}, std::pair{"tick_late_us", &heard.late_us}}) {
    report.rows.push_back(measured(std::string(name) + ".p50", of->p50(), "us"));
    report.rows.push_back(measured(std::string(name) + ".p99", of->p99(), "us"));
    report.rows.push_back(measured(std::string(name) + ".p999", of->p999(), "us"));
  }
  report.rows.push_back(measured("surfaces", static_cast<double>(heard.touchable_ms.count()), "frames"));
  report.rows.push_back(measured("ticks", static_cast<double>(heard.work_us.count()), "ticks"));
  report.rows.push_back(measured("deadlines_missed", static_cast<double>(heard.stats.deadlines_missed()), "ticks"));
  report.notes.push_back(heard.stats.realtime() ? "the station had real-time priority and locked memory"
                                                : "the station had no real-time priority or no locked memory");
  report.notes.push_back("time available: 33.3 ms for each frame at 30 Hz, 500 us for each tick at 2 kHz");
  return report;
}

Error not_started(const char* program) {
  return {.what = std::string(program) + " did not start, or ended with an error",
          .where = "telepalp-bench pipeline",
          .fix = std::string("see the message of ") + program + " above"};
}

Error not_built(const char* name) {
  return {.what = "the file does not exist",
          .where = program::sibling_program(name).string(),
          .fix = "build all programs: ninja telepalp_programs"};
}

}  // namespace

Result<Report> measure_pipeline(const PipelineRun& run) {
  for (const char* const name : {"telepalp-server", "telepalp-station"})
    if (!fs::exists(program::sibling_program(name))) return not_built(name);

  const support::TemporaryFolder folder;
  const fs::path ready = folder.path() / "server";
  const Result<RunKeys> keys = make_keys(folder.path());
  if (!keys) return keys.error();
  support::ChildProcess server(program::sibling_program("telepalp-server"),
                               {"--source", run.source, "--depth-mode", run.depth_mode, "--port", "0", "--key",
                                keys->server.string(), "--ready-file", ready.string()});
  const std::optional<std::string> port = support::await_ready(ready, "port");
  if (!port) return not_started("telepalp-server");
  support::ChildProcess station(
      program::sibling_program("telepalp-station"),
      {"--connect", "127.0.0.1:" + *port, "--key", keys->station.string(), "--seconds", std::to_string(run.seconds)});
  const Heard heard = listen(static_cast<std::uint16_t>(std::stoi(*port)), keys->listener, station,
                             std::chrono::milliseconds(static_cast<std::int64_t>(run.seconds * 1000)) + 30s);
  if (station.wait(0ms) != 0) return not_started("telepalp-station");
  return report_of(heard, run.source.starts_with("oni:"));
}

Result<Report> run_pipeline(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 1.0, 600.0);
  if (!seconds) return seconds.error();
  return measure_pipeline({.source = arguments.has("input") ? arguments.text("input") : "synthetic",
                           .depth_mode = arguments.text("depth-mode"),
                           .seconds = *seconds});
}

}  // namespace telepalp::bench
