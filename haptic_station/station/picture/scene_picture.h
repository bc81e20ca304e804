#pragma once

#include <optional>
#include <span>
#include <string>

#include "haptic_station/scenes/scene.h"
#include "haptic_station/station/rigs/static_patient.h"
#include "proto/words/rgbd_frame.h"

namespace telepalp::station {

/// The direction from which a scene is seen; the patient lies on the back. Side: from the patient's left.
enum class PictureSide : std::uint8_t { Above, Feet, Side };

/// A picture of a scene, to scale: the objects inside the body below a translucent skin, with the scene's name, a grid
/// and its step, the directions of the body, and a legend. `skin`: points of a model's skin in H; if empty, the skin is
/// the plane y = 0 of H (Scene::center_on_surface moves H's origin to a streamed patient's skin). `width_m`: width of
/// the part that is seen; nullopt: all objects and points fit.
[[nodiscard]] ColorImage picture_of_scene(const scenes::Scene& scene, std::span<const SkinPoint> skin, PictureSide side,
                                          std::optional<double> width_m);

}  // namespace telepalp::station
