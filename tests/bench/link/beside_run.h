#pragma once

#include <optional>
#include <vector>

#include "tests/bench/link/link_scenario.h"
#include "tests/bench/link/rival_flow.h"

namespace telepalp::bench::link {

struct Rival {
  RivalKind kind;
  Nanoseconds from{0};
  Nanoseconds until{std::chrono::hours(1)};
};

/// A session's images through a tail-drop bottleneck that other flows use, too.
struct BesideScenario {
  impaired::Impairment down{};
  Nanoseconds back{0};  ///< delay from the client to the server
  std::vector<Rival> rivals{};
  int sessions = 1;  ///< telepalp sessions that begin 1 s apart
  double seconds = 30.0;
  double measured_from_s = 5.0;
  double measured_until_s = 30.0;
  std::vector<double> image_B{94'000, 56'000, 32'000};  ///< depth and colour of a frame, by level of content
  impaired::Trace trace{};                              ///< changes of `down`
  bool planned = false;  ///< images are as large as the plan's budget allows, at most image_B[0]
};

/// What one session got within the measured time.
struct BesideOutcome {
  double images_per_s = 0.0;    ///< complete depth images, each newer than all before
  Distribution above_queue_ms;  ///< from capture until an image is complete, less the queue's delay at its capture
  Distribution age_ms;          ///< from capture until an image is complete
  Nanoseconds longest_gap{0};   ///< between two images
  double share = 0.0;           ///< of the bottleneck's rate
  double rivals_share = 0.0;    ///< of the bottleneck's rate, all rivals together
  double beside = 0.0;          ///< share of the time in which the session says that something else uses the line
  double level = 0.0;           ///< mean level of content
  double loss = 0.0;            ///< share of the session's datagrams that did not arrive
  Distribution queue_ms;        ///< of the bottleneck, each millisecond
};

/// In virtual time: one outcome for each session.
[[nodiscard]] std::vector<BesideOutcome> run_beside(const BesideScenario& scenario);

}  // namespace telepalp::bench::link
