#include "haptic_station/scenes/removed_fields.h"

#include <array>
#include <string_view>

namespace telepalp::scenes {
namespace {

struct RemovedField {
  std::string_view message;
  std::string_view field;
  std::string_view instead;
};

constexpr std::string_view kAround = "leave it out: 10 mm around an object are near it";
constexpr std::string_view kPerson =
    "leave it out: the simulated person has an arm of 300 N/m and 20 N s/m, and a hand of 0.5 kg; to feel with "
    "your own hand, start deploy/demo with --hand browser";
constexpr std::string_view kRecall =
    "leave it out: the recall is 150 N/m and at most 3 N, and the patient moves at 0.05 m/s for each newton";

// Kept in the order of proto/messages/scene.proto, which reserves their numbers.
constexpr std::array kRemoved = std::to_array<RemovedField>({
    {"CylinderEffect", "around_m", kAround},
    {"SphereEffect", "around_m", kAround},
    {"OrganEffect", "around_m", kAround},
    {"SolidEffect", "around_m", kAround},
    {"Plane", "speed_m_per_s", "leave it out: the plane moves at 0.1 m/s or less"},
    {"Transitions", "from_body_within_m", "leave it out: the phases do not depend on S1's d_thr"},
    {"Transitions", "offset_fade_s", "leave it out: offsets decay with a time constant of 0.15 s"},
    {"Transitions", "hand_rose_m", "leave it out: a hand 20 mm above plane and end-effector has left the body"},
    {"Transitions", "force_fade_N_per_s", "leave it out: the force of the previous phase fades at 40 N/s"},
    {"AgeLimit", "tracker_in_contact_s", "leave it out: in contact the tracker may be silent for 3 s"},
    {"ForceLimit", "slew_N_per_s",
     "leave it out: the force changes by at most 2000 N/s; peak_N and continuous_N bound it"},
    {"HandIntention", "arm_stiffness_N_per_m", kPerson},
    {"HandIntention", "arm_damping_N_s_per_m", kPerson},
    {"HandIntention", "hand_mass_kg", kPerson},
    {"Workspace", "recall_N_per_m", kRecall},
    {"Workspace", "recall_most_N", kRecall},
    {"Workspace", "shift_m_per_s_per_N", kRecall},
    {"Scene", "position_control",
     "leave it out: a scene does not set how the free end-effector follows the hand; limits { peak_N } bounds its "
     "force"},
    {"Scene", "simulated_device",
     "leave it out: the simulated device has 0.3 kg and 1 N s/m; limits { peak_N } bounds the force of each device"},
});

}  // namespace

Error with_what_to_write_instead(Error error) {
  for (const RemovedField& removed : kRemoved) {
    const std::string told = "Message type \"telepalp.msg." + std::string(removed.message) +
                             "\" has no field named \"" + std::string(removed.field) + "\"";
    if (!error.what.starts_with(told)) continue;
    error.what = "a scene has no field " + std::string(removed.field) + " any more";
    error.fix = std::string(removed.instead);
    return error;
  }
  return error;
}

}  // namespace telepalp::scenes
