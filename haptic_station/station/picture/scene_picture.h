#pragma once

#include <optional>
#include <span>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/static_patient.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// The side from which a scene is seen, when the patient lies on the back. Side: the patient's left.
enum class PictureSide : std::uint8_t { Above, Feet, Side };

/// A picture of a scene, to scale: the objects inside the body below a translucent skin, with the scene's name, a grid,
/// its scale, the directions of the body, and a legend. `skin`: points of a model's skin; without any, the skin is the
/// plane y = 0 of the haptic base's frame H, as where `center_on_surface` puts a streamed patient. `width_m`: of the
/// part that is seen; nullopt: all objects and points fit.
[[nodiscard]] ColorImage picture_of_scene(const scenes::Scene& scene, std::span<const SkinPoint> skin, PictureSide side,
                                          std::optional<double> width_m);

}  // namespace telepalp::station
