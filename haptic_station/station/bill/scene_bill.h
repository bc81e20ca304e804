#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "haptic_station/station/bill/billed_station.h"
#include "haptic_station/station/bill/error_in_motion.h"

namespace telepalp::station {

/// What one part of a scene adds to a station: the station as it is, less the station without that part. Measured
/// between sessions in virtual time, and enlarged by what each part of the station takes more in real time.
struct Price {
  std::string name;                        ///< the effect's; "ultrasound probe"; "all of these"
  std::array<double, kPartCount> share{};  ///< of each part of the station, of one core [%]
  double total_share = 0.0;                ///< of the whole station [%]
  double tick_us = 0.0;                    ///< an effect: its mean time in a tick with contact, measured by itself [us]
  std::size_t shapes = 0;                  ///< a layer: number of shapes; 0: not a layer
  std::size_t bytes = 0;                   ///< a layer: memory of its SolidTree [B]
  std::optional<MovingError> error{};      ///< an effect: of its force
};

struct SceneBill {
  StationCost whole;  ///< the station with the scene as it is, each step as soon as the one before it is done
  StationCost live;   ///< the same seconds, with each tick and each image at its own time, as a station has them
  double receiving_us = 0.0;  ///< processor time of the network thread to receive one image; 0: no images are used
  double start_ms = 0.0;      ///< processor time of the layers' surfaces for viewers, once at the start
  std::vector<Price> prices;  ///< of each effect in the scene's order; of the probe, if any; of all of them together

  [[nodiscard]] double receiving_share() const noexcept;  ///< of one core [%], at the camera's rate
  [[nodiscard]] double share() const noexcept;            ///< of one core [%]: that of `live`, and of receiving
};

/// What bill_of() prices: each effect, with its error, and all of them together; or only these.
enum class Detail { EachEffect, Together };

/// One session in virtual time for each line of the bill, in turns of half a second, so that other programs disturb all
/// of them alike; then the scene as it is in real time. The first second of each is not measured. `seconds`: measured
/// time; a trial lasts 11 to 15 s. `file`: the scene's file. `begun`: called with the number of seconds done and of all
/// seconds. Error: as for read_parts() and errors_in_motion().
[[nodiscard]] Result<SceneBill> bill_of(const scenes::Scene& scene, const std::filesystem::path& file, double seconds,
                                        Detail detail = Detail::EachEffect,
                                        const std::function<void(int done, int all)>& begun = {});

/// The bill as two tables.
[[nodiscard]] std::string in_words(const SceneBill& bill);

}  // namespace telepalp::station
