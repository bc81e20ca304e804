#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace telepalp::report {

/// What a network path allows. The names are those of telepalp-link's profiles; docs/report.md has the same table.
struct PathLimits {
  std::string_view name;
  double network_ms;      ///< a path with at most this median time from encoded to received resembles this one
  double latency_p50_ms;  ///< from a depth image's capture until it is touchable
  double latency_p99_ms;
  double received_pct;    ///< of the depth images that the server sent, at least
  double clock_error_ms;  ///< p99 of the error bound of the station's clock: at best half of a round trip
};

/// In the order of their delay. The first has the doctor's limits: a frame must be touchable before the next one comes
/// (33.3 ms at 30 Hz), and 99 of 100 frames within 100 ms, in which breathing moves the skin by less than 1 mm.
inline constexpr std::array kPaths{
    PathLimits{"lan", 10.0, 33.3, 100.0, 99.0, 5.0},
    PathLimits{"lte", 45.0, 75.0, 150.0, 95.0, 45.0},
    PathLimits{"hostile", 150.0, 150.0, 400.0, 80.0, 150.0},
    PathLimits{"satellite", 1e9, 450.0, 700.0, 95.0, 350.0},
};

/// nullopt: no path has this name.
[[nodiscard]] constexpr std::optional<PathLimits> path_named(std::string_view name) noexcept {
  for (const PathLimits& path : kPaths)
    if (path.name == name) return path;
  return std::nullopt;
}

/// The path that a median time in the network resembles; the first if the time is NaN.
[[nodiscard]] constexpr const PathLimits& path_like(double network_ms) noexcept {
  for (const PathLimits& path : kPaths)
    if (!(network_ms > path.network_ms)) return path;
  return kPaths.back();
}

}  // namespace telepalp::report
