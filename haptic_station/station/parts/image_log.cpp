#include "haptic_station/station/parts/image_log.h"

#include <utility>

#include "codec/depth.h"
#include "proto/wire/depth_loss.h"

namespace telepalp::station {

std::optional<ImageLog::Fidelity> ImageLog::add(const msg::SurfaceReport& report, double clock_error_s) {
  ages_.add(report, clock_error_s);
  const wire::DepthFidelity fidelity = wire::depth_fidelity(report);
  const std::string words = wire::in_words(fidelity);
  if (std::exchange(depth_, words) == words) return std::nullopt;
  if (!fidelity.moved) return Fidelity{.text = "depth is lossless (depth mode " + fidelity.mode + ")"};
  return Fidelity{.text = "the touched depth is near-lossless: " + words +
                          "; such depth is for pictures, not for touch. fix: " +
                          (fidelity.mode == codec::name(codec::DepthMode::Bounded)
                               ? "start telepalp-server with --depth-mode fast, intra or temporal"
                               : "give the server a source with lossless depth"),
                  .is_warning = true};
}

}  // namespace telepalp::station
