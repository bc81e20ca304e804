#pragma once

#include <google/protobuf/descriptor.h>

#include <array>

#include "proto/wire/topics.h"

namespace telepalp::server {

// What tools such as Foxglove and Lichtblick show by themselves. Each is made from our own topics, while somebody at
// the gateway subscribes to it; recorders and stations are not offered any.

inline constexpr wire::Topic kDepthView{"/camera/depth/image", "foxglove.RawImage"};
inline constexpr wire::Topic kCloudView{"/camera/points", "foxglove.PointCloud"};
inline constexpr wire::Topic kTransformsView{"/transforms", "foxglove.FrameTransforms"};
inline constexpr wire::Topic kSceneView{"/station/scene", "foxglove.SceneUpdate"};

inline constexpr std::array kViewTopics{kDepthView, kCloudView, kTransformsView, kSceneView};

/// The Protobuf type of one of kViewTopics.
[[nodiscard]] const google::protobuf::Descriptor* descriptor_of_view(const wire::Topic& topic);

}  // namespace telepalp::server
