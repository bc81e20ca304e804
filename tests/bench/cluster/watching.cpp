#include "tests/bench/cluster/watching.h"

#include <algorithm>
#include <utility>

#include "proto/wire/topics.h"

namespace telepalp::bench {

using namespace std::chrono_literals;

double Watched::longest_gap_s(Clock::time_point from, Clock::time_point to) const {
  Clock::time_point last = from;
  Clock::duration longest{0};
  std::vector<Clock::time_point> times{to};
  for (const auto& [number, time] : arrived)
    if (time > from && time < to) times.push_back(time);
  std::ranges::sort(times);
  for (const Clock::time_point time : times) longest = std::max(longest, time - std::exchange(last, time));
  return std::chrono::duration<double>(longest).count();
}

const Watched& Viewers::add(std::uint16_t port, std::size_t count) {
  const std::size_t first = viewers_.size();
  for (std::size_t i = 0; i < count; ++i) {
    auto viewer = std::make_unique<Viewer>();
    Watched* const watched = &viewer->watched;
    viewer->link = std::make_unique<wire::ClientLink>(
        io_,
        wire::ClientLink::Options{.host = options_.host,
                                  .port = port,
                                  .name = "bench",
                                  .key = options_.key,
                                  .consent = options_.key ? "a synthetic patient" : "",
                                  .subscribes = {"/camera/*"},
                                  .datagrams = false},
        wire::ClientLink::Handlers{.on_message =
                                       [watched](const wire::Message& message) {
                                         watched->bytes += message.payload->size();
                                         ++watched->messages;
                                         if (message.topic.name == wire::kCameraDepth.name)
                                           watched->arrived.emplace(message.sequence, Watched::Clock::now());
                                       },
                                   .on_state =
                                       [watched](wire::LinkState state, const std::string& detail) {
                                         watched->news = std::string(wire::name(state)) + ": " + detail;
                                       }});
    viewer->link->start();
    viewers_.push_back(std::move(viewer));
  }
  return viewers_[first]->watched;
}

void Viewers::run_for(std::chrono::duration<double> time) {
  io_.restart();
  io_.run_for(std::chrono::duration_cast<std::chrono::nanoseconds>(time));
}

bool Viewers::all_see() {
  const auto sees = [](const auto& viewer) { return !viewer->watched.arrived.empty(); };
  for (int wait = 0; wait < 150 && !std::ranges::all_of(viewers_, sees); ++wait) run_for(100ms);
  return std::ranges::all_of(viewers_, sees);
}

std::uint64_t Viewers::messages() const {
  std::uint64_t sum = 0;
  for (const auto& viewer : viewers_) sum += viewer->watched.messages;
  return sum;
}

std::uint64_t Viewers::bytes() const {
  std::uint64_t sum = 0;
  for (const auto& viewer : viewers_) sum += viewer->watched.bytes;
  return sum;
}

}  // namespace telepalp::bench
