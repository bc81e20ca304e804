#include "tests/bench/session/recording_cost.h"

#include <boost/asio/io_context.hpp>
#include <chrono>
#include <csignal>

#include "messages/station.pb.h"
#include "proto/wire/client/client_link.h"
#include "support/program/files/shipped.h"
#include "tests/bench/distribution.h"
#include "tests/bench/process_load.h"
#include "tests/support/child_process.h"

namespace telepalp::bench {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr const char* kBuild = "; to build all programs: ninja telepalp_programs";

Error server_not_started() {
  return {.what = "telepalp-server did not start within 20 s",
          .where = "telepalp-bench session",
          .fix = std::string("see the message of telepalp-server above") + kBuild};
}

/// The error of a program that writes its messages to a file, which ends with the benchmark.
Error not_heard(const std::string& program, const std::string& what) {
  return {.what = program + what,
          .where = "telepalp-bench session",
          .fix = "run " + program + " beside a telepalp-server, and see its message" + kBuild};
}

/// Hears the ticks of the station, as any subscriber does.
class TickListener {
 public:
  explicit TickListener(std::uint16_t port)
      : link_(io_, {.port = port, .name = "telepalp-bench", .subscribes = {"/station/ticks"}, .publishes = {}},
              {.on_message = [this](const wire::Message& message) { hear(message); }}) {
    link_.start();
  }
  ~TickListener() {
    link_.stop();
    io_.run_for(200ms);
  }
  TickListener(const TickListener&) = delete;
  TickListener& operator=(const TickListener&) = delete;

  bool await_ticks(std::chrono::seconds patience) {
    const auto until = Clock::now() + patience;
    while (work_us_.count() == 0 && Clock::now() < until) io_.run_for(50ms);
    return work_us_.count() > 0;
  }
  /// Receives ticks for `seconds`. Returns the computing time of each [us].
  Distribution ticks_of(double seconds) {
    work_us_ = {};
    io_.run_for(std::chrono::duration_cast<Nanoseconds>(std::chrono::duration<double>(seconds)));
    return work_us_;
  }

 private:
  void hear(const wire::Message& message) {
    msg::StationTicks batch;
    if (message.topic.name != wire::kStationTicks.name || !batch.ParseFromString(*message.payload)) return;
    for (const float work_us : batch.work_us()) work_us_.add(double{work_us});
  }
  boost::asio::io_context io_;
  wire::ClientLink link_;
  Distribution work_us_;
};

/// Sums over the turns with a recorder, or over those without. `p999_us`: the 99.9th percentile of each turn's ticks.
struct Turns {
  double seconds = 0.0;
  double server_s = 0.0;
  double recorder_s = 0.0;
  Distribution p999_us;
};

void take_turn(Turns& turns, TickListener& ticks, double seconds, pid_t server, pid_t recorder) {
  const double server_before = cpu_s(server), recorder_before = recorder > 0 ? cpu_s(recorder) : 0.0;
  const auto began = Clock::now();
  turns.p999_us.add(ticks.ticks_of(seconds).p999());
  turns.seconds += std::chrono::duration<double>(Clock::now() - began).count();
  turns.server_s += cpu_s(server) - server_before;
  if (recorder > 0) turns.recorder_s += cpu_s(recorder) - recorder_before;
}

}  // namespace

Result<RecordingCost> recording_cost(const fs::path& folder, double seconds) {
  support::ChildProcess server(program::sibling_program("telepalp-server"),
                               {"--port", "0", "--ready-file", (folder / "server").string()});
  const std::optional<std::string> port = support::await_ready(folder / "server", "port");
  if (!port) return server_not_started();
  const std::string address = "127.0.0.1:" + *port;
  support::ChildProcess station(program::sibling_program("telepalp-station"), {"--connect", address},
                                folder / "station.log");
  TickListener ticks(static_cast<std::uint16_t>(std::stoi(*port)));
  if (!ticks.await_ticks(60s)) return not_heard("telepalp-station", " sent no tick within 60 s");
  Turns alone, recorded;
  const double turn_s = seconds / (2.0 * kRecordingTurns);
  for (int turn = 0; turn < kRecordingTurns; ++turn) {
    take_turn(alone, ticks, turn_s, server.pid(), -1);
    const std::string name = "recorded" + std::to_string(turn);
    support::ChildProcess recorder(
        program::sibling_program("telepalp-record"),
        {"--connect", address, "--out", (folder / (name + ".mcap")).string(), "--ready-file", (folder / name).string()},
        folder / "recorder.log");
    if (!support::await_ready(folder / name, "recording"))
      return not_heard("telepalp-record", " did not begin to record within 20 s");
    take_turn(recorded, ticks, turn_s, server.pid(), recorder.pid());
    recorder.signal(SIGINT);
    (void)recorder.wait(20s);
  }
  return RecordingCost{.recorder_share = recorded.recorder_s / recorded.seconds,
                       .server_share = recorded.server_s / recorded.seconds - alone.server_s / alone.seconds,
                       .alone_us = alone.p999_us.p50(),
                       .recorded_us = recorded.p999_us.p50()};
}

}  // namespace telepalp::bench
