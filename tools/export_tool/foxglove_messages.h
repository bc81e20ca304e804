#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "proto/wire/mcap/reader.h"
#include "proto/words/rgbd_frame.h"
#include "tools/export_tool/frames.h"

namespace telepalp::export_tool {

/// What of a session is written in Foxglove's types.
struct FoxgloveParts {
  bool color = true;          ///< colour images and their camera's model, as recorded
  bool depth = true;          ///< depth as images, 2 bytes a pixel before the file's own compression
  bool points = true;         ///< depth as coloured clouds, 16 bytes a point
  bool station = true;        ///< state and its numbers, hand, force, transforms, layers inside the body, ultrasound
  double images_per_s = 0.0;  ///< at most; 0: each image
};

using TakeMessage = std::function<Result<void>(const wire::Message&)>;

/// Chooses images of a session, at most so many a second. Images of one exposure are chosen together.
class Thinning {
 public:
  Thinning(SessionTime begin, double images_per_s) : begin_(begin), images_per_s_(images_per_s) {}
  [[nodiscard]] bool takes(SessionTime captured);

 private:
  SessionTime begin_;
  double images_per_s_;
  std::int64_t last_ = INT64_MIN;  // number of the period, 1 / images_per_s long, of the newest chosen image
};

/// Gives the messages of station and colour camera to `take`, in order of time. Damaged ones are left out; returns the
/// number of damaged chunks and messages. Error: the error of `take`.
[[nodiscard]] Result<std::uint64_t> give_station_and_color(wire::McapReader& session, const FoxgloveParts& parts,
                                                           const TakeMessage& take);

/// The messages of one frame: depth image and cloud, each if it is among the `parts`.
[[nodiscard]] std::vector<wire::Message> frame_messages(const RgbdFrame& frame, const FoxgloveParts& parts);

}  // namespace telepalp::export_tool
