#include "tests/bench/site/flow_outcome.h"

#include <algorithm>

namespace telepalp::bench {
namespace {

using namespace std::chrono_literals;

constexpr double kFullRate_per_s = 27.0;  ///< 0.9 of the camera's rate
constexpr Nanoseconds kWindow = 1s;

std::size_t images_between(const TouchRecord& record, Nanoseconds from, Nanoseconds until) {
  return static_cast<std::size_t>(std::ranges::count_if(
      record.images, [&](const auto& image) { return image.touchable >= from && image.touchable < until; }));
}

double released_share(const TouchRecord& record, Nanoseconds from, Nanoseconds until) {
  double all = 0.0, released = 0.0;
  for (const TouchRecord::State& state : record.states) {
    if (state.at < from || state.at >= until) continue;
    all += 1.0;
    released += state.released ? 1.0 : 0.0;
  }
  return all > 0.0 ? released / all : 1.0;
}

/// From the first to the last count of the server in this time.
double sent_B_per_s(const TouchRecord& record, Nanoseconds from, Nanoseconds until) {
  const TouchRecord::Sent *first = nullptr, *last = nullptr;
  for (const TouchRecord::Sent& sent : record.sent) {
    if (sent.at < from || sent.at >= until) continue;
    if (first == nullptr) first = &sent;
    last = &sent;
  }
  return first == last ? 0.0 : (last->bytes - first->bytes) / to_seconds(last->at - first->at);
}

/// The last window of 1 s with fewer images, and the last change back to large images, end the time.
double back_after_s(const TouchRecord& record, const FlowTimes& times) {
  Nanoseconds back = 0ns;
  for (Nanoseconds at = times.ended; at + kWindow <= times.ended + times.after; at += 100ms)
    if (static_cast<double>(images_between(record, at, at + kWindow)) < kFullRate_per_s * to_seconds(kWindow))
      back = at + kWindow - times.ended;
  for (const Nanoseconds full : record.full_again)
    if (full >= times.ended) back = std::max(back, full - times.ended);
  return to_seconds(back);
}

}  // namespace

FlowOutcome outcome_of(const TouchRecord& record, const FlowTimes& times,
                       const std::function<Nanoseconds(Nanoseconds)>& queue_at) {
  FlowOutcome outcome;
  outcome.images_per_s =
      static_cast<double>(images_between(record, times.began, times.ended)) / to_seconds(times.ended - times.began);
  for (const TouchRecord::Image& image : record.images) {
    if (image.touchable < times.began || image.touchable >= times.ended) continue;
    const Nanoseconds age = image.touchable - image.captured;
    outcome.touchable_ms.add(to_milliseconds(age));
    outcome.above_queue_ms.add(to_milliseconds(age - queue_at(image.captured)));
  }
  outcome.released = released_share(record, times.began, times.ended);
  outcome.alone_B_per_s = sent_B_per_s(record, times.began - times.alone, times.began);
  outcome.beside_B_per_s = sent_B_per_s(record, times.began, times.ended);
  outcome.back_after_s = back_after_s(record, times);
  return outcome;
}

}  // namespace telepalp::bench
