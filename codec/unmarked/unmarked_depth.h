#pragma once

#include <string_view>

namespace telepalp::codec {

/// Whether a message of a topic with predicted messages is a key frame, for a message that does not say it: it comes
/// from a peer that speaks version 1 of the wire protocol, or from a session file of a release with that version. Those
/// predict depth alone. `depth_image`: a serialised msg::DepthImage. False if it is damaged.
[[nodiscard]] bool is_unmarked_key_frame(std::string_view depth_image);

}  // namespace telepalp::codec
