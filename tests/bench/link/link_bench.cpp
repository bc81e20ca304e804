#include "tests/bench/link/link_bench.h"

#include <array>
#include <ctime>

#include "proto/link/datagram_link.h"
#include "support/program/files/shipped.h"
#include "tests/bench/link/clock_run.h"
#include "tests/bench/link/link_scenario.h"
#include "tests/bench/link/real_time_priority.h"
#include "tests/bench/link/subscribers_bench.h"
#include "tests/bench/link/tcp_run.h"
#include "tests/bench/pipeline_bench.h"
#ifdef TELEPALP_HAVE_SRT
#include "tests/bench/link/srt_run.h"
#endif

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;
using link::Outcome;
using link::Scenario;

constexpr double kVirtualSeconds = 120.0;

/// A path, and the share of frames that must be complete within 100 ms of their capture.
struct PathRow {
  Nanoseconds round_trip;
  double loss_percent;
  double burst_packets;
  double reach_percent;
};

constexpr std::array kPaths{
    PathRow{50ms, 1, 1, 99.9},  PathRow{50ms, 5, 1, 99.5},  PathRow{50ms, 10, 1, 97},
    PathRow{50ms, 1, 4, 99.5},  PathRow{50ms, 5, 4, 98},    PathRow{50ms, 10, 4, 95},
    PathRow{100ms, 1, 1, 99.9}, PathRow{100ms, 5, 1, 99.5}, PathRow{100ms, 10, 1, 97},
};

std::string name_of(const PathRow& path) {
  char text[80];
  std::snprintf(text, sizeof text, "round-trip time %.0f ms, loss %.0f %%%s", to_milliseconds(path.round_trip),
                path.loss_percent, path.burst_packets > 1.0 ? " in bursts of 4" : "");
  return text;
}

/// Adds the peers that run in real time. Returns the share of frames that SRT has in time; 0 without SRT.
double add_real_peers(Report& report, const std::string& name, Scenario scenario, double seconds) {
  scenario.seconds = seconds;
  if (const std::optional<Outcome> tcp = link::run_kernel_tcp(scenario))
    report.rows.push_back(measured(name + ": frames in time, the kernel's TCP", tcp->in_time_percent(), "%"));
#ifdef TELEPALP_HAVE_SRT
  const Outcome srt = link::run_srt(scenario);
  report.rows.push_back(measured(name + ": frames in time, SRT", srt.in_time_percent(), "%"));
  report.rows.push_back(measured(name + ": overhead, SRT", srt.overhead_percent(), "%"));
  return srt.in_time_percent();
#else
  return 0.0;
#endif
}

void add_path(Report& report, const PathRow& path, double real_seconds) {
  const std::string name = name_of(path);
  Scenario scenario = link::over(path.round_trip, path.loss_percent * 1e-2, path.burst_packets);
  scenario.seconds = kVirtualSeconds;
  const Outcome ours = run_telepalp(scenario);
  const double udp = run_plain_udp(scenario).in_time_percent();
  const double tcp = run_plain_tcp(scenario).in_time_percent();  // a model, kinder than any real TCP
  report.rows.push_back(measured(name + ": frames in time, plain UDP", udp, "%"));
  report.rows.push_back(measured(name + ": frames in time, TCP without congestion control", tcp, "%"));
  const double srt = add_real_peers(report, name, scenario, real_seconds);
  report.rows.push_back(
      at_least(name + ": frames in time, telepalp", ours.in_time_percent(), "%", std::max(path.reach_percent, srt)));
  report.rows.push_back(at_most(name + ": overhead, telepalp", ours.overhead_percent(), "%", 45.0));
  report.rows.push_back(
      at_most(name + ": frames with wrong bytes, telepalp", static_cast<double>(ours.wrong), "frames", 0.0));
}

/// Processor time of this thread.
Nanoseconds processor_time() {
  timespec spent{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &spent);
  return std::chrono::seconds(spent.tv_sec) + Nanoseconds(spent.tv_nsec);
}

/// Processor time that the two ends take for an image, on a path without delay and loss.
Distribution processing_ms() {
  const telepalp::link::DatagramLinkSettings settings{
      .seal = {.number = 1, .cipher = telepalp::link::preferred_cipher()}};
  telepalp::link::DatagramLink server(settings, telepalp::link::End::Server);
  telepalp::link::DatagramLink client(settings, telepalp::link::End::Client);
  Distribution took_ms;
  for (std::uint32_t number = 0; number < 1000; ++number) {
    const SessionTime now{number * 33ms};
    telepalp::link::Frame frame{.number = number, .captured = now, .bytes = std::vector<std::byte>(91'000)};
    const Nanoseconds began = processor_time();
    server.offer(std::move(frame));
    while (const auto datagram = server.next(now)) (void)client.received(datagram->bytes(), now);
    const bool complete = client.take(now).has_value();
    if (complete) took_ms.add(to_milliseconds(processor_time() - began));
    while (const auto answer = client.next(now + 10ms)) (void)server.received(answer->bytes(), now + 10ms);
  }
  return took_ms;
}

void add_no_loss(Report& report) {
  const Outcome ours = run_telepalp(link::over(20ms, 0.0, 1.0));
  const Distribution took_ms = processing_ms();
  report.rows.push_back(at_most("no loss: overhead, telepalp", ours.overhead_percent(), "%", 5.0));
  report.rows.push_back(at_least("no loss: frames in time, telepalp", ours.in_time_percent(), "%", 100.0));
  report.rows.push_back(measured("no loss: time to encrypt, split, decrypt and join 91 kB, p50", took_ms.p50(), "ms"));
  report.rows.push_back(
      at_most("no loss: time to encrypt, split, decrypt and join 91 kB, p99", took_ms.p99(), "ms", 1.0));
}

void add_thin_pipe(Report& report, double real_seconds) {
  Scenario scenario{.down = {.delay = 25ms, .rate_B_per_s = 2e6, .queue_B = std::size_t{2} << 20U},
                    .up = {.delay = 25ms}};
  scenario.seconds = kVirtualSeconds;
  const Outcome ours = run_telepalp(scenario);
  const Outcome tcp = run_plain_tcp(scenario);
  report.rows.push_back(
      measured("2 MB/s, round-trip time 50 ms, queue of 2 MiB: age of the newest depth image, TCP without congestion "
               "control, p50",
               tcp.depth_age_ms.p50(), "ms"));
  scenario.seconds = real_seconds;
  if (const std::optional<Outcome> kernel = link::run_kernel_tcp(scenario))
    report.rows.push_back(
        measured("2 MB/s, round-trip time 50 ms, queue of 2 MiB: age of the newest depth image, the kernel's TCP, p50",
                 kernel->depth_age_ms.p50(), "ms"));
  report.rows.push_back(
      measured("2 MB/s, round-trip time 50 ms, queue of 2 MiB: age of the newest depth image, telepalp, p50",
               ours.depth_age_ms.p50(), "ms"));
  report.rows.push_back(
      at_most("2 MB/s, round-trip time 50 ms, queue of 2 MiB: age of the newest depth image, telepalp, p95",
              ours.depth_age_ms.quantile(0.95), "ms", 200.0));
}

void add_clock(Report& report) {
  const link::ClockOutcome clock = link::run_clock(50ms, 20ms, 100);
  report.rows.push_back(at_most("session clock, jitter of 20 ms: largest error after 10 s, worst of 100 runs",
                                to_milliseconds(clock.worst_error), "ms", 1.0));
  report.rows.push_back(at_most("session clock, jitter of 20 ms: number of steps backwards",
                                static_cast<double>(clock.backwards), "times", 0.0));
}

/// From the capture of a recording's frame until it can be touched, between the real programs.
void add_camera_to_hand(Report& report, const program::Arguments& arguments, double seconds) {
  const auto recording = program::shipped_file("deploy/demo_data/oni/3dj_test.oni");
  const std::string source = arguments.has("input") ? arguments.text("input")
                             : recording            ? "oni:" + recording->string()
                                                    : "synthetic";
  const Result<Report> pipeline = measure_pipeline({.source = source, .seconds = seconds});
  if (!pipeline)
    return report.notes.push_back("the latency from camera to hand is not measured: " + to_string(pipeline.error()));
  for (Row row : pipeline->rows) {
    if (!row.name.ends_with("_ms.p50") && !row.name.ends_with("_ms.p99")) continue;
    row.name = "camera to hand over sealed datagrams: " + row.name;
    report.rows.push_back(std::move(row));
  }
}

}  // namespace

Result<Report> run_link(const program::Arguments& arguments) {
  const Result<double> seconds = arguments.number("seconds", 1.0, 600.0);
  if (!seconds) return seconds.error();
  Report report{.bench = "link", .rows = {}, .notes = {}};
  for (const PathRow& path : kPaths) add_path(report, path, *seconds);
  add_no_loss(report);
  add_thin_pipe(report, *seconds);
  add_camera_to_hand(report, arguments, *seconds);
  add_clock(report);
  add_subscribers(report, *seconds);
  report.notes.push_back(
      "frames in time: depth (91 kB) and colour (32 kB) complete within 100 ms of their capture, at 30 Hz");
  report.notes.push_back("telepalp, plain UDP and TCP without congestion control: 120 s of virtual time");
  report.notes.push_back(
      "the kernel's TCP (" + link::kernel_congestion_control() +
      "): --seconds of real time between two network namespaces, its packets over the same simulated path");
  report.notes.push_back("the kernel's TCP has no rows if network namespaces or /dev/net/tun are not permitted");
#ifdef TELEPALP_HAVE_SRT
  report.notes.push_back(
      "SRT: --seconds of real time through telepalp-link, encrypted; its latency is set to 100 ms less the times of "
      "encoding and path");
#else
  report.notes.push_back("SRT is not measured: Debian's libsrt-openssl-dev was not installed at build time");
#endif
  report.notes.push_back(link::RealTimePriority().granted() ? "the runs in real time had real-time priority"
                                                            : "the runs in real time had no real-time priority");
  report.notes.push_back("overhead: bytes sent beyond the bytes of the images, without IP and UDP headers");
  return report;
}

}  // namespace telepalp::bench
