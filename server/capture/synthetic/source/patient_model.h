#pragma once

#include <string>

#include "server/capture/synthetic/shape/mesh.h"
#include "server/capture/synthetic/synthetic_patient.h"

namespace telepalp::capture {

inline constexpr Nanoseconds kSyntheticPeriod{33'333'333};  ///< between two frames of the synthetic patient: 30 Hz

/// The synthetic patient that `synthetic:SPEC` names.
struct NamedPatient {
  SyntheticPatient patient;
  std::string model;  ///< file name of the mesh, without folders
};

/// Opens the patient of MODEL[,key=value…]; both parts are optional. Error: an unknown key, a value out of range, or a
/// model that cannot be read or laid on the table.
[[nodiscard]] Result<NamedPatient> open_patient(const std::string& spec);

/// The mesh of the torso that telepalp ships. Error: its file is missing, or cannot be read.
[[nodiscard]] Result<TriangleMesh> shipped_torso();

}  // namespace telepalp::capture
