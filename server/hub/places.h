#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace telepalp::hub {

/// The server limits the number of connections of each kind, so that many viewers cannot keep a station out. A place is
/// one connection that counts against this limit.
enum class PlaceKind { Station, Recorder, Viewer };
inline constexpr std::array kPlaceKinds{PlaceKind::Station, PlaceKind::Recorder, PlaceKind::Viewer};

/// The kind of place for a peer with this `role` in its Hello; an unknown role counts as a viewer.
[[nodiscard]] constexpr PlaceKind place_for(std::string_view role) noexcept {
  if (role == "doctor") return PlaceKind::Station;
  if (role == "recorder" || role == "technician" || role == "qa") return PlaceKind::Recorder;
  return PlaceKind::Viewer;
}

struct PlaceLimits {
  static constexpr std::size_t kStations = 8;   ///< role doctor
  static constexpr std::size_t kRecorders = 8;  ///< roles recorder, technician, qa
  std::size_t viewers = 48;                     ///< any other role
  std::size_t strangers = 128;                  ///< connections without a Hello yet, or refused and not closed yet

  [[nodiscard]] constexpr std::size_t of(PlaceKind kind) const noexcept {
    if (kind == PlaceKind::Station) return kStations;
    return kind == PlaceKind::Recorder ? kRecorders : viewers;
  }
};

/// The error text for a peer when all places of its kind are taken.
[[nodiscard]] inline std::string full_house(PlaceKind kind, std::size_t places) {
  const char* const who = kind == PlaceKind::Station    ? "stations"
                          : kind == PlaceKind::Recorder ? "recorders"
                                                        : "viewers";
  return "the server is full: all " + std::to_string(places) + " places for " + who +
         " are taken. fix: stop one of these programs, then connect again";
}

/// Time limits after which a peer that neither receives nor publishes is disconnected.
struct IdleLimits {
  std::chrono::milliseconds without_topics{5'000};  ///< for a peer with neither a subscription nor an advertised topic
  std::chrono::milliseconds silent{60'000};         ///< for a peer that has advertised a topic and publishes nothing
};

}  // namespace telepalp::hub
