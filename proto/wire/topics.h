#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace telepalp::wire {

/// A named stream of messages of one Protobuf type.
struct Topic {
  std::string_view name;
  std::string_view schema;  ///< full name of the Protobuf type
};

inline constexpr Topic kCameraColor{"/camera/color", "foxglove.CompressedImage"};
inline constexpr Topic kCameraDepth{"/camera/depth", "telepalp.msg.DepthImage"};
inline constexpr Topic kCameraInfo{"/camera/info", "foxglove.CameraCalibration"};
inline constexpr Topic kCameraStatus{"/camera/status", "telepalp.msg.CaptureStatus"};
inline constexpr Topic kClock{"/clock", "telepalp.msg.Clock"};
inline constexpr Topic kServerStats{"/server/stats", "telepalp.msg.ServerStats"};
inline constexpr Topic kStationState{"/station/state", "telepalp.msg.StationState"};
inline constexpr Topic kStationTicks{"/station/ticks", "telepalp.msg.StationTicks"};
inline constexpr Topic kStationSurface{"/station/surface", "telepalp.msg.SurfaceReport"};
inline constexpr Topic kStationCompensation{"/station/compensation", "telepalp.msg.StationCompensation"};
inline constexpr Topic kStationEvents{"/station/events", "telepalp.msg.StationEvent"};
inline constexpr Topic kStationStats{"/station/stats", "telepalp.msg.StationStats"};
inline constexpr Topic kStationUltrasound{"/station/ultrasound", "telepalp.msg.UltrasoundImage"};
inline constexpr Topic kStationInside{"/station/inside", "telepalp.msg.InnerStructures"};
inline constexpr Topic kViewerHand{"/viewer/hand", "telepalp.msg.ViewerHand"};
inline constexpr Topic kHandHolder{"/viewer/hand_holder", "telepalp.msg.HandHolder"};
inline constexpr Topic kCameraColorInfo{"/camera/color/info", "foxglove.CameraCalibration"};

inline constexpr std::array kTopics{
    kCameraColor,  kCameraDepth,  kCameraInfo,      kCameraStatus,      kClock,        kServerStats,
    kStationState, kStationTicks, kStationSurface,  kStationEvents,     kStationStats, kStationCompensation,
    kViewerHand,   kHandHolder,   kCameraColorInfo, kStationUltrasound, kStationInside};

/// The topic of this name; nullopt if telepalp has no such topic.
[[nodiscard]] std::optional<Topic> find_topic(std::string_view name) noexcept;

/// True if the newest message of the topic stays valid until the next one, however late that comes: a new subscriber
/// gets it at once, and each file of a recording begins with it.
[[nodiscard]] bool is_latched(std::string_view topic) noexcept;

}  // namespace telepalp::wire
