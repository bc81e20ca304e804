#pragma once

#include <optional>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/solids/solid_mesh.h"
#include "support/program/options.h"

namespace telepalp::station {

/// Option --cell-mm in metres; nullopt: not given. Error: not a number from 0.001 to 100.
[[nodiscard]] Result<std::optional<double>> smallest_cell_m(const program::Arguments& arguments);

/// Meshes the layer that --layer names, and prints on one line what was checked on the mesh. Long work is reported on
/// stderr. Error: no such layer, or no right mesh of it (solids::checked_mesh_of()).
[[nodiscard]] Result<solids::CheckedMesh> mesh_of_layer(const scenes::Scene& scene,
                                                        const program::Arguments& arguments);

}  // namespace telepalp::station
