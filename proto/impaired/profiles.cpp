#include "proto/impaired/profiles.h"

#include <algorithm>
#include <string>

namespace telepalp::impaired {
namespace {

using namespace std::chrono_literals;

constexpr double kMbit_B_per_s = 125'000.0;

Profile symmetric(std::string_view name, const Impairment& either_way) {
  return {.name = name, .down = either_way, .up = either_way};
}

/// A quiet wired network.
Profile lan() {
  return symmetric("lan", {.delay = 200us, .jitter = 50us, .rate_B_per_s = 1000 * kMbit_B_per_s, .queue_B = 1 << 20});
}

/// A mobile phone's network.
Profile lte() {
  const Impairment down{.delay = 25ms,
                        .jitter = 8ms,
                        .loss = 0.005,
                        .burst_packets = 3.0,
                        .rate_B_per_s = 40 * kMbit_B_per_s,
                        .queue_B = 1 << 20};
  Impairment up = down;
  up.rate_B_per_s = 12 * kMbit_B_per_s;
  return {.name = "lte", .down = down, .up = up};
}

/// A geostationary satellite.
Profile satellite() {
  const Impairment down{.delay = 300ms,
                        .jitter = 10ms,
                        .loss = 0.01,
                        .burst_packets = 4.0,
                        .rate_B_per_s = 50 * kMbit_B_per_s,
                        .queue_B = 2 << 20};
  Impairment up = down;
  up.rate_B_per_s = 5 * kMbit_B_per_s;
  return {.name = "satellite", .down = down, .up = up};
}

/// A very bad network: bursts of loss, damaged packets, outages.
Profile hostile() {
  return symmetric("hostile", {.delay = 60ms,
                               .jitter = 30ms,
                               .loss = 0.1,
                               .burst_packets = 4.0,
                               .reorder = 0.05,
                               .reorder_by = 20ms,
                               .duplicate = 0.02,
                               .corrupt = 0.01,
                               .rate_B_per_s = 60 * kMbit_B_per_s,
                               .queue_B = 1 << 20,
                               .outage_every = 20s,
                               .outage_for = 1s});
}

}  // namespace

const std::vector<Profile>& profiles() {
  static const std::vector<Profile> all{lan(), lte(), satellite(), hostile()};
  return all;
}

Result<Profile> profile_named(std::string_view name) {
  std::string names;
  for (const Profile& profile : profiles()) {
    if (profile.name == name) return profile;
    names += (names.empty() ? "" : ", ") + std::string(profile.name);
  }
  return Error{.what = "'" + std::string(name) + "' is not a network profile",
               .where = "--profile",
               .fix = "use one of: " + names};
}

}  // namespace telepalp::impaired
