#pragma once

#include "foxglove/FrameTransforms.pb.h"
#include "foxglove/SceneUpdate.pb.h"
#include "messages/inside.pb.h"
#include "messages/station.pb.h"
#include "proto/words/time.h"

namespace telepalp::views {

/// The layers inside the body as triangles [m]. Each layer lies in a frame of its own, "inside/NAME/EFFECT", with which
/// it moves; it stays until the next message. `inside` is valid (inside_message.h).
[[nodiscard]] foxglove::SceneUpdate inside_view(const msg::InnerStructures& inside);

/// Appends the frames of inside_view() to `all`, each where the station displays its layer at `now`: `moved` tells how
/// far each layer has moved since the station published `inside`.
void add_inside_transforms(foxglove::FrameTransforms& all, const msg::InnerStructures& inside,
                           const msg::StationCompensation& moved, SessionTime now);

}  // namespace telepalp::views
