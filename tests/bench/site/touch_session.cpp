#include "tests/bench/site/touch_session.h"

#include <csignal>
#include <fstream>
#include <optional>
#include <sstream>
#include <thread>

#include "messages/station.pb.h"
#include "proto/wire/mcap/reader.h"
#include "proto/wire/topics.h"
#include "tests/bench/site/queue_watch.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using Side = TwoNetworks::Side;

constexpr std::uint16_t kFirstPort = 7400;
constexpr auto kPatience = 20s;

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Error said(const std::string& program, const std::filesystem::path& log) {
  return {.what = program + " did not start: " + text_of(log), .where = log.string(), .fix = "see its message"};
}

bool await_words(const std::filesystem::path& log, const std::string& words) {
  for (const auto until = std::chrono::steady_clock::now() + kPatience; std::chrono::steady_clock::now() < until;
       std::this_thread::sleep_for(20ms))
    if (text_of(log).find(words) != std::string::npos) return true;
  return false;
}

/// The keys of one patient's site: server.key, doc.key (a doctor's) and rec.key (a technician's).
Result<void> make_keys(const std::filesystem::path& programs, const std::filesystem::path& folder) {
  const std::string keys = (folder / "keys").string();
  const std::filesystem::path log = folder / "keys.log";
  for (const std::vector<std::string>& command :
       std::vector<std::vector<std::string>>{{"authority", "--dir", keys, "--host", TwoNetworks::kPatient},
                                             {"server", "--dir", keys, "--host", TwoNetworks::kPatient},
                                             {"client", "--dir", keys, "--name", "doc", "--role", "doctor"},
                                             {"client", "--dir", keys, "--name", "rec", "--role", "technician"}})
    if (support::ChildProcess(programs / "telepalp-keys", command, log).wait(10s) != 0)
      return said("telepalp-keys", log);
  return {};
}

Nanoseconds from_stamp(std::uint64_t ns) { return Nanoseconds(static_cast<std::int64_t>(ns)); }

void add(TouchRecord& record, const wire::Message& message) {
  if (message.topic.name == wire::kStationSurface.name) {
    msg::SurfaceReport report;
    if (report.ParseFromString(*message.payload))
      record.images.push_back({from_stamp(report.captured_ns()), from_stamp(report.touchable_ns())});
  } else if (message.topic.name == wire::kStationState.name) {
    msg::StationState state;
    if (state.ParseFromString(*message.payload))
      record.states.push_back(
          {from_stamp(state.stamp_ns()), state.phase() == msg::PHASE_RELEASED || state.phase() == msg::PHASE_FAULTED});
  } else if (message.topic.name == wire::kServerStats.name) {
    msg::ServerStats stats;
    if (!stats.ParseFromString(*message.payload)) return;
    for (const auto& subscriber : stats.subscribers()) {
      if (subscriber.name() != "telepalp-station") continue;
      TouchRecord::Sent sent{.at = from_stamp(stats.stamp_ns()), .told = subscriber.has_share_b_per_s()};
      for (const auto& topic : subscriber.topics()) sent.bytes += static_cast<double>(topic.bytes());
      record.sent.push_back(sent);
    }
  }
}

/// A line of the log begins with the time of day, HH:MM:SS.mmm in UTC.
std::optional<Nanoseconds> time_of_day(const std::string& line) {
  int hours = 0, minutes = 0;
  double seconds = 0.0;
  if (std::sscanf(line.c_str(), "%d:%d:%lf", &hours, &minutes, &seconds) != 3) return std::nullopt;
  return std::chrono::hours(hours) + std::chrono::minutes(minutes) + from_seconds(seconds);
}

std::vector<Nanoseconds> times_of(const std::filesystem::path& log, const std::string& words) {
  constexpr Nanoseconds kDay = 24h;
  std::vector<Nanoseconds> times;
  std::istringstream lines(text_of(log));
  for (std::string line; std::getline(lines, line);) {
    const std::optional<Nanoseconds> at = time_of_day(line);
    if (!at || line.find(words) == std::string::npos) continue;
    const Nanoseconds now = wall_clock();
    Nanoseconds when = now - now % kDay + *at;
    times.push_back(when > now ? when - kDay : when);
  }
  return times;
}

}  // namespace

Result<std::unique_ptr<TouchSession>> TouchSession::begin(const TwoNetworks& networks,
                                                          const std::filesystem::path& programs,
                                                          const std::filesystem::path& folder, int number) {
  std::unique_ptr<TouchSession> session(new TouchSession());
  session->folder_ = folder / ("session_" + std::to_string(number));
  std::filesystem::remove_all(session->folder_);
  std::filesystem::create_directories(session->folder_);
  if (Result<void> made = make_keys(programs, session->folder_); !made) return made.error();
  if (Result<void> started = session->start(networks, programs, number); !started) return started.error();
  return session;
}

Result<void> TouchSession::start(const TwoNetworks& networks, const std::filesystem::path& programs, int number) {
  const std::string port = std::to_string(kFirstPort + number);
  const std::string to = std::string(TwoNetworks::kPatient) + ":" + port;
  const auto key = [this](const char* name) { return (folder_ / "keys" / name).string(); };
  server_ = networks.start(Side::Patient, programs / "telepalp-server",
                           {"--source", "synthetic", "--bind", TwoNetworks::kPatient, "--key", key("server.key"),
                            "--port", port, "--ready-file", (folder_ / "ready").string()},
                           folder_ / "server.log");
  if (!support::await_ready(folder_ / "ready", "port", kPatience))
    return said("telepalp-server", folder_ / "server.log");
  recorder_ = networks.start(Side::Patient, programs / "telepalp-record",
                             {"--connect", to, "--key", key("rec.key"), "--consent", "a synthetic patient", "--out",
                              (folder_ / "site.mcap").string(), "--topics", "/station/s*,/server/stats", "--ready-file",
                              (folder_ / "recording").string()},
                             folder_ / "record.log");
  for (int i = 0; i < 500 && !std::filesystem::exists(folder_ / "recording"); ++i) std::this_thread::sleep_for(20ms);
  if (!std::filesystem::exists(folder_ / "recording")) return said("telepalp-record", folder_ / "record.log");
  station_ = networks.start(
      Side::Doctor, programs / "telepalp-station",
      {"--connect", to, "--key", key("doc.key"), "--control", "none", "--state-dir", (folder_ / "state").string()},
      folder_ / "station.log");
  if (!await_words(folder_ / "station.log", "the surface is touchable"))
    return said("telepalp-station", folder_ / "station.log");
  return {};
}

Result<TouchRecord> TouchSession::end() {
  for (auto* program : {&station_, &recorder_, &server_}) {
    (*program)->signal(SIGINT);
    (void)(*program)->wait(6s);
    program->reset();
  }
  Result<wire::McapReader> reader = wire::McapReader::open(folder_ / "site.mcap");
  if (!reader) return reader.error();
  TouchRecord record;
  for (;;) {
    Result<std::optional<wire::Message>> message = reader->next();
    if (!message) return message.error();
    if (!message.value()) break;
    add(record, **message);
  }
  record.full_again = times_of(folder_ / "server.log", "images are again as large as before");
  return record;
}

}  // namespace telepalp::bench
