#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>

namespace telepalp::server {

/// A server's places are kept apart by role, so that no number of viewers can take a station's.
enum class PlaceKind { Station, Recorder, Viewer };
inline constexpr std::array kPlaceKinds{PlaceKind::Station, PlaceKind::Recorder, PlaceKind::Viewer};

/// The kind of place for a peer that greets with `role`; an unknown role is a viewer's.
[[nodiscard]] constexpr PlaceKind place_for(std::string_view role) noexcept {
  if (role == "doctor") return PlaceKind::Station;
  if (role == "recorder" || role == "technician" || role == "qa") return PlaceKind::Recorder;
  return PlaceKind::Viewer;
}

struct PlaceLimits {
  std::size_t stations = 8;    ///< role doctor
  std::size_t recorders = 8;   ///< roles recorder, technician, qa
  std::size_t viewers = 48;    ///< any other role
  std::size_t strangers = 32;  ///< connections that have not greeted yet, or were refused and have not closed yet

  [[nodiscard]] constexpr std::size_t of(PlaceKind kind) const noexcept {
    if (kind == PlaceKind::Station) return stations;
    return kind == PlaceKind::Recorder ? recorders : viewers;
  }
};

/// What a peer is told that finds all places of its kind taken.
[[nodiscard]] inline std::string full_house(PlaceKind kind, std::size_t places) {
  const char* const who = kind == PlaceKind::Station    ? "stations"
                          : kind == PlaceKind::Recorder ? "recorders"
                                                        : "viewers";
  return "the server is full: all " + std::to_string(places) + " places for " + who +
         " are taken. fix: end one of them, then connect again";
}

/// When a peer is let go that takes nothing and gives nothing.
struct IdleLimits {
  std::chrono::milliseconds without_topics{5'000};  ///< it neither subscribed nor advertised what it may publish
  std::chrono::milliseconds silent{60'000};         ///< it did advertise, and publishes nothing
};

}  // namespace telepalp::server
