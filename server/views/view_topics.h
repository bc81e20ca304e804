#pragma once

#include <google/protobuf/descriptor.h>

#include <array>

#include "proto/wire/topics.h"

namespace telepalp::views {

// Topics in formats that tools such as Foxglove and Lichtblick display without extensions. Each is derived from
// telepalp's topics while a client of the gateway subscribes to it. Recorders and stations cannot subscribe to them.

inline constexpr wire::Topic kDepthView{
    .name = "/camera/depth/image", .schema = "foxglove.RawImage", .lane = wire::Lane::First};
inline constexpr wire::Topic kCloudView{
    .name = "/camera/points", .schema = "foxglove.PointCloud", .lane = wire::Lane::First};
inline constexpr wire::Topic kTransformsView{"/transforms", "foxglove.FrameTransforms"};
inline constexpr wire::Topic kSceneView{"/station/scene", "foxglove.SceneUpdate"};
inline constexpr wire::Topic kHandView{"/station/hand", "foxglove.PoseInFrame"};
inline constexpr wire::Topic kPhaseView{"/station/phase", "foxglove.KeyValuePair"};

inline constexpr wire::Topic kUltrasoundView{"/station/ultrasound/image", "foxglove.CompressedImage"};
inline constexpr wire::Topic kInsideView{
    .name = "/station/inside/scene", .schema = "foxglove.SceneUpdate", .validity = wire::Validity::UntilChanged};

inline constexpr std::array kViewTopics{kDepthView, kCloudView, kTransformsView, kSceneView,
                                        kHandView,  kPhaseView, kUltrasoundView, kInsideView};

/// The Protobuf type of one of kViewTopics.
[[nodiscard]] const google::protobuf::Descriptor* descriptor_of_view(const wire::Topic& topic);

}  // namespace telepalp::views
