#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace telepalp::wire {

/// The program that publishes a topic. A server disconnects a peer that advertises a topic of another program.
enum class Publisher : std::uint8_t {
  Server,   ///< the server itself
  Station,  ///< a peer whose role may touch; the server passes its messages on (server/hub/upstream.h)
  Gateway,  ///< the server's gateway, for its viewers
};

/// How long the newest message of a topic is valid. A latched topic is one whose newest message stays valid: a new
/// subscriber gets it at once, and each file of a recording begins with it.
enum class Validity : std::uint8_t {
  Instant,       ///< it describes one instant: not latched
  UntilNext,     ///< latched; published again at least every ten seconds
  UntilChanged,  ///< latched; published only when it changes, so that it may be of any age
};

/// Which messages of a topic wait for a slow peer.
enum class Backlog : std::uint8_t {
  Newest,   ///< two: a newer message makes older ones worthless
  History,  ///< 256, or 1 MiB: each counts
};

/// Which messages are sent first over TCP. While both lanes wait, Others gets one byte for each four of First.
enum class Lane : std::uint8_t { First, Others };

/// Limits on what one peer publishes of a topic.
struct PublishingRate {
  std::uint16_t messages_per_s = 0;
  std::uint16_t KiB_per_s = 0;
};

/// A named stream of messages of one Protobuf type, with all that the programs need to know of it to transport, record
/// and play it. Everybody who may watch may subscribe to each topic but
/// the spoken ones.
struct Topic {
  std::string_view name;
  std::string_view schema;  ///< full name of the Protobuf type
  Publisher publisher = Publisher::Server;
  Validity validity = Validity::Instant;
  Lane lane = Lane::Others;
  Backlog backlog = Backlog::History;
  /// Number of the topic in sealed datagrams (WIRE.md), 0 to 15. Only topics whose messages are worthless when they are
  /// late have one. nullopt: TCP alone carries the topic.
  std::optional<std::uint8_t> datagram_channel = std::nullopt;
  bool predicted = false;        ///< its messages may need the one before: Message::key_frame says which ones do not
  bool kept_while_away = false;  ///< a client without a connection keeps its messages for the next connection
  bool only_by_name = false;     ///< a subscriber must name it: no prefix subscribes to it
  /// What a person says. Only those who may listen get it, a recording has it only with the patient's consent to that,
  /// and a de-identified copy leaves it out.
  bool spoken = false;
  PublishingRate most_from_peer{};  ///< of a topic whose publisher is Station

  [[nodiscard]] constexpr bool latched() const noexcept { return validity != Validity::Instant; }
  [[nodiscard]] constexpr bool has_deadline() const noexcept { return datagram_channel.has_value(); }
};

// The table of telepalp's topics. What is left out has the value that Topic gives it.

inline constexpr Topic kCameraColor{.name = "/camera/color",
                                    .schema = "foxglove.CompressedImage",
                                    .lane = Lane::First,
                                    .backlog = Backlog::Newest,
                                    .datagram_channel = 1};
inline constexpr Topic kCameraColorVideo{.name = "/camera/color/video",
                                         .schema = "foxglove.CompressedVideo",
                                         .lane = Lane::First,
                                         .backlog = Backlog::Newest,
                                         .datagram_channel = 4,
                                         .predicted = true,
                                         .only_by_name = true};
inline constexpr Topic kCameraDepth{.name = "/camera/depth",
                                    .schema = "telepalp.msg.DepthImage",
                                    .lane = Lane::First,
                                    .backlog = Backlog::Newest,
                                    .datagram_channel = 0,
                                    .predicted = true};
inline constexpr Topic kCameraDepthWindow{.name = "/camera/depth/window",
                                          .schema = "telepalp.msg.DepthImage",
                                          .lane = Lane::First,
                                          .backlog = Backlog::Newest,
                                          .datagram_channel = 5,
                                          .predicted = true,
                                          .only_by_name = true};
inline constexpr Topic kCameraInfo{.name = "/camera/info",
                                   .schema = "foxglove.CameraCalibration",
                                   .validity = Validity::UntilNext,
                                   .lane = Lane::First};
inline constexpr Topic kCameraColorInfo{.name = "/camera/color/info",
                                        .schema = "foxglove.CameraCalibration",
                                        .validity = Validity::UntilNext,
                                        .lane = Lane::First};
inline constexpr Topic kCameraStatus{.name = "/camera/status",
                                     .schema = "telepalp.msg.CaptureStatus",
                                     .validity = Validity::UntilNext,
                                     .lane = Lane::First};
inline constexpr Topic kClock{.name = "/clock", .schema = "telepalp.msg.Clock"};
inline constexpr Topic kServerStats{.name = "/server/stats", .schema = "telepalp.msg.ServerStats"};

// The rates are more than twice those of a station.
inline constexpr Topic kStationState{.name = "/station/state",
                                     .schema = "telepalp.msg.StationState",
                                     .publisher = Publisher::Station,
                                     .datagram_channel = 2,
                                     .most_from_peer = {.messages_per_s = 250, .KiB_per_s = 256}};
inline constexpr Topic kStationTicks{.name = "/station/ticks",
                                     .schema = "telepalp.msg.StationTicks",
                                     .publisher = Publisher::Station,
                                     .most_from_peer = {.messages_per_s = 250, .KiB_per_s = 1024}};
inline constexpr Topic kStationSurface{.name = "/station/surface",
                                       .schema = "telepalp.msg.SurfaceReport",
                                       .publisher = Publisher::Station,
                                       .most_from_peer = {.messages_per_s = 150, .KiB_per_s = 128}};
inline constexpr Topic kStationCompensation{.name = "/station/compensation",
                                            .schema = "telepalp.msg.StationCompensation",
                                            .publisher = Publisher::Station,
                                            .most_from_peer = {.messages_per_s = 250, .KiB_per_s = 128}};
inline constexpr Topic kStationEvents{.name = "/station/events",
                                      .schema = "telepalp.msg.StationEvent",
                                      .publisher = Publisher::Station,
                                      .kept_while_away = true,
                                      .most_from_peer = {.messages_per_s = 50, .KiB_per_s = 64}};
inline constexpr Topic kStationStats{.name = "/station/stats",
                                     .schema = "telepalp.msg.StationStats",
                                     .publisher = Publisher::Station,
                                     .most_from_peer = {.messages_per_s = 10, .KiB_per_s = 64}};
inline constexpr Topic kStationUltrasound{.name = "/station/ultrasound",
                                          .schema = "telepalp.msg.UltrasoundImage",
                                          .publisher = Publisher::Station,
                                          .most_from_peer = {.messages_per_s = 60, .KiB_per_s = 1024}};
inline constexpr Topic kStationInside{.name = "/station/inside",
                                      .schema = "telepalp.msg.InnerStructures",
                                      .publisher = Publisher::Station,
                                      .validity = Validity::UntilChanged,
                                      .most_from_peer = {.messages_per_s = 1, .KiB_per_s = 512}};
inline constexpr Topic kStationWindow{.name = "/station/window",
                                      .schema = "telepalp.msg.WindowRequest",
                                      .publisher = Publisher::Station,
                                      .most_from_peer = {.messages_per_s = 100, .KiB_per_s = 32}};

inline constexpr Topic kViewerHand{.name = "/viewer/hand",
                                   .schema = "telepalp.msg.ViewerHand",
                                   .publisher = Publisher::Gateway,
                                   .datagram_channel = 3};
inline constexpr Topic kHandHolder{.name = "/viewer/hand_holder",
                                   .schema = "telepalp.msg.HandHolder",
                                   .publisher = Publisher::Gateway,
                                   .validity = Validity::UntilChanged};

/// Moments that people marked while the session took place.
inline constexpr Topic kSessionNotes{
    .name = "/session/notes", .schema = "telepalp.msg.LiveNote", .publisher = Publisher::Gateway};

/// What is said at the patient's side, and what the doctor says.
inline constexpr Topic kPatientVoice{.name = "/patient/voice",
                                     .schema = "telepalp.msg.VoiceFrame",
                                     .publisher = Publisher::Gateway,
                                     .lane = Lane::First,
                                     .backlog = Backlog::Newest,
                                     .datagram_channel = 6,
                                     .only_by_name = true,
                                     .spoken = true};
inline constexpr Topic kDoctorVoice{.name = "/doctor/voice",
                                    .schema = "telepalp.msg.VoiceFrame",
                                    .publisher = Publisher::Gateway,
                                    .lane = Lane::First,
                                    .backlog = Backlog::Newest,
                                    .datagram_channel = 7,
                                    .only_by_name = true,
                                    .spoken = true};

inline constexpr std::array kTopics{
    kCameraColor,       kCameraDepth,   kCameraInfo,      kCameraStatus,      kClock,         kServerStats,
    kStationState,      kStationTicks,  kStationSurface,  kStationEvents,     kStationStats,  kStationCompensation,
    kViewerHand,        kHandHolder,    kCameraColorInfo, kStationUltrasound, kStationInside, kCameraColorVideo,
    kCameraDepthWindow, kStationWindow, kSessionNotes,    kPatientVoice,      kDoctorVoice};

/// The topic of this name; nullopt if telepalp has no such topic.
[[nodiscard]] std::optional<Topic> find_topic(std::string_view name) noexcept;

/// The topic of this number in sealed datagrams; nullopt if no topic has it.
[[nodiscard]] std::optional<Topic> topic_of_datagram_channel(std::uint8_t channel) noexcept;

}  // namespace telepalp::wire
