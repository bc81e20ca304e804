#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "proto/link/datagram_link.h"
#include "proto/wire/message.h"
#include "server/hub/hub.h"
#include "server/hub/peer_listener.h"
#include "server/plan/rate_plan.h"

namespace telepalp::server {

/// Chooses how the camera's images are made, from what the hub and the peers' paths show of each subscriber's line.
/// Owner: the server's network thread.
class ContentChoice {
 public:
  /// An image is published.
  void published(const wire::Message& message, plan::Grade grade);

  struct Site {
    const hub::Hub& hub;
    std::vector<hub::PeerListener::PeerLine> peers;
    std::optional<std::uint32_t> followed;  ///< the station whose window of exact depth the server follows
    std::uint64_t images = 0;               ///< of the camera so far
    bool chooses_content = true;            ///< false: images are as they were recorded
    SessionTime now{};
  };
  /// Plans anew; call it about five times a second. Returns a line for the log, if there is something to say.
  std::optional<std::string> step(const Site& site);

  [[nodiscard]] const plan::RatePlan& plan() const noexcept { return planner_.plan(); }

 private:
  std::optional<std::string> choose_level(const Site& site, double span_s);
  void plan_rates(const Site& site, double span_s);

  link::ContentLevel level_;  // for stations that take whole depth images
  plan::RatePlanner planner_;
  plan::PlanInput made_;  // since the last step
  SessionTime stepped_at_{};
  std::uint64_t images_ = 0;         // of the camera at the last step
  double bytes_ = 0.0;               // of images since the last step
  double image_rate_B_per_s_ = 0.0;  // smoothed
};

}  // namespace telepalp::server
