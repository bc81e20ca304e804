#pragma once

#include <vector>

#include "haptic_station/station/bill/seen_body.h"
#include "proto/wire/message.h"

namespace telepalp::station {

/// The messages of /camera/depth in which a server would send a SeenBody, losslessly, from `begin` on.
struct BodyStream {
  static constexpr SessionTime kBegin{std::chrono::seconds(100)};

  BodyStream(const SeenBody& body, double seconds);

  Intrinsics camera;
  std::vector<wire::Message> images;  ///< `published`: the exposure's session time
};

}  // namespace telepalp::station
