#pragma once

#include <string>
#include <string_view>

#include "clients/report/session/session.h"

namespace telepalp::report {

/// The notice that every report has.
inline constexpr std::string_view kNotAMedicalDevice =
    "telepalp is not a medical device. It has not been assessed as one, and must not be used to decide on a diagnosis "
    "or a treatment.";

/// Where a session comes from. A text is empty where the session does not state it.
struct Provenance {
  std::string date;      ///< of the first message: "2026-03-01 12:00:05 UTC"; empty in virtual time
  std::string scene;     ///< its name
  std::string software;  ///< that wrote the file: "telepalp-record 0.1.0, commit 1a2b3c4d"
  std::string recorder;  ///< person or account that recorded
  std::string consent;   ///< of the patient, as stated to the recorder
  std::string server;    ///< program, version and commit, as the server published them
  std::string station;   ///< the same of the station
};

[[nodiscard]] Provenance provenance_of(const Session& session);

/// "telepalp-record 0.1.0, commit 1a2b3c4d"
[[nodiscard]] std::string software_of(const wire::SessionInfo& info);

/// The line `name: "…"` of a scene file, or its number of lines; empty for an empty text.
[[nodiscard]] std::string scene_name(const std::string& scene);

}  // namespace telepalp::report
