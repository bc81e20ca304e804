#pragma once

#include <array>
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

/// Chooses how the camera's images are made, from what the hub and the peers' paths show of each subscriber's line. Two
/// decisions: link::ContentLevel makes whole depth images and colour smaller for stations that take whole depth images;
/// plan::RatePlanner decides everything for the hand and for viewers. The plan carries both out, because all stations
/// get one grade. Owner: the server's network thread.
class ContentChoice {
 public:
  /// Counts a published message, if it is an image.
  void published(const wire::Message& message, plan::Grade grade);

  struct Site {
    const hub::Hub& hub;
    std::vector<hub::PeerListener::PeerLine> peers;
    std::optional<std::uint32_t> followed;  ///< the station whose window of exact depth the server follows
    std::uint64_t images = 0;               ///< number of the camera's images so far
    bool chooses_content = true;            ///< origin::Origin::chooses_content()
    SessionTime now{};
  };
  /// Makes the next plan. Call it about five times a second. Returns a line for the log when whole depth images become
  /// smaller, or as large as before.
  std::optional<std::string> step(const Site& site);

  [[nodiscard]] const plan::RatePlan& plan() const noexcept { return planner_.plan(); }
  /// For people: what is given up for lines that are too thin; empty: nothing.
  [[nodiscard]] const std::string& given_up() const noexcept { return notice_.text(); }

 private:
  std::optional<std::string> choose_level(const Site& site, double span_s);
  void plan_rates(const Site& site, double span_s);

  link::ContentLevel level_;  // for stations that take whole depth images
  plan::RatePlanner planner_;
  plan::SacrificeNotice notice_;
  std::array<plan::Made, plan::kGrades.size()> made_{};  // by grade, since the last step
  SessionTime stepped_at_{};
  std::uint64_t images_ = 0;         // Site::images at the last step
  double images_per_s_ = 30.0;       // of the camera, smoothed
  double bytes_ = 0.0;               // of the stations' images, since the last step
  double image_rate_B_per_s_ = 0.0;  // of the stations' images, smoothed
};

}  // namespace telepalp::server
