#include "tests/bench/cluster/nodes/station_watch.h"

#include <algorithm>
#include <chrono>
#include <functional>

#include "messages/station.pb.h"
#include "proto/wire/topics.h"
#include "where.h"

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;

/// Runs `io` until `is_done`, for at most `time`.
bool run_until(boost::asio::io_context& io, std::chrono::seconds time, const std::function<bool()>& is_done) {
  for (const auto end = std::chrono::steady_clock::now() + time; !is_done();) {
    if (std::chrono::steady_clock::now() > end) return false;
    io.restart();
    io.run_for(50ms);
  }
  return true;
}

}  // namespace

StationWatch::StationWatch(boost::asio::io_context& io, const std::string& host, std::uint16_t port)
    : link_(std::make_unique<wire::ClientLink>(
          io,
          wire::ClientLink::Options{
              .host = host,
              .port = port,
              .name = "bench",
              .subscribes = {std::string(wire::kStationSurface.name), std::string(wire::kStationEvents.name)},
              .datagrams = false},
          wire::ClientLink::Handlers{
              .on_message = [this](const wire::Message& message) { hear(message); },
              .on_state = [this](wire::LinkState state,
                                 const std::string&) { connected_ = state == wire::LinkState::Connected; }})) {
  link_->start();
}

Result<std::unique_ptr<StationWatch>> StationWatch::start(boost::asio::io_context& io, const std::string& host,
                                                          std::uint16_t port, const std::filesystem::path& scratch,
                                                          const std::string& name) {
  const std::filesystem::path log = scratch / (name + ".log");
  std::unique_ptr<StationWatch> watch(new StationWatch(io, host, port));
  const auto failed = [&](const char* what) {
    return Error{.what = what, .where = log.string(), .fix = "read this file"};
  };
  if (!run_until(io, 10s, [&] { return watch->connected_; })) return failed("the server of the station is not reached");
  watch->process_ = std::make_unique<support::ChildProcess>(
      TELEPALP_BINARY_DIR "/bin/telepalp-station",
      std::vector<std::string>{"--connect", host + ":" + std::to_string(port), "--control", "none", "--state-dir",
                               (scratch / (name + "_state")).string()},
      log);
  if (!run_until(io, 40s, [&] { return watch->touches_ && watch->surfaces_.size() > 1; }))
    return failed("telepalp-station does not touch");
  return watch;
}

void StationWatch::hear(const wire::Message& message) {
  if (message.topic.name == wire::kStationSurface.name) {
    msg::SurfaceReport report;
    if (report.ParseFromString(*message.payload))
      surfaces_.push_back({.image = report.sequence(), .touchable_ns = report.touchable_ns()});
    return;
  }
  msg::StationEvent event;
  if (message.topic.name != wire::kStationEvents.name || !event.ParseFromString(*message.payload)) return;
  const bool changes = event.kind() == msg::EVENT_KIND_PHASE;
  touches_ = touches_ || (changes && event.to() == msg::PHASE_IN_BODY);
  if (event.kind() == msg::EVENT_KIND_FAULT || (changes && event.to() == msg::PHASE_RELEASED)) ++releases_;
}

StationWatch::Facts StationWatch::between(const Moment& from, const Moment& to) const {
  Facts facts{.images = to.surfaces - from.surfaces,
              .missed = 0,
              .longest_gap_ms = 0.0,
              .releases = to.releases - from.releases};
  for (std::size_t i = std::max<std::size_t>(from.surfaces, 1); i < to.surfaces; ++i) {
    const Surface& before = surfaces_[i - 1];
    const Surface& now = surfaces_[i];
    if (now.image > before.image + 1) facts.missed += now.image - before.image - 1;
    facts.longest_gap_ms = std::max(facts.longest_gap_ms, 1e-6 * (static_cast<double>(now.touchable_ns) -
                                                                  static_cast<double>(before.touchable_ns)));
  }
  return facts;
}

void add_station_rows(const std::string& what, const StationWatch::Facts& before, const StationWatch::Facts& while_lost,
                      std::vector<Row>& rows) {
  rows.push_back(at_most(what + "images that did not become touchable at the doctor's station meanwhile",
                         static_cast<double>(while_lost.missed), "", 0.0));
  rows.push_back(at_most(what + "releases and faults of the doctor's station meanwhile",
                         static_cast<double>(while_lost.releases), "", 0.0));
  rows.push_back(measured(what + "longest time between two touchable images at the doctor's station",
                          while_lost.longest_gap_ms, "ms"));
  rows.push_back(measured(what + "the same, as long before", before.longest_gap_ms, "ms"));
  rows.push_back(at_least(
      what + "images touchable at the doctor's station meanwhile / before",
      static_cast<double>(while_lost.images) / std::max<double>(1.0, static_cast<double>(before.images)), "x", 0.9));
}

}  // namespace telepalp::bench
