#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace telepalp::keys {

/// The role of a person, which decides the allowed operations. A key or token states one role. A program on the
/// server's own machine has the role `Local`, if the server has no keys and listens only on the loopback interface; no
/// key states the role `Local`.
enum class Role { Technician, Doctor, Viewer, Qa, Local };

/// An operation that a peer requests from a server. The server checks the peer's role when the request arrives.
enum class Operation {
  Watch,           ///< subscribe to topics: see the patient, the hand and the statistics
  Touch,           ///< publish /station/..., or move the hand in the web viewer
  HandOver,        ///< offer the permission to touch, or to move the hand, to another person
  Record,          ///< join as a recorder
  Metrics,         ///< read /metrics
  Play,            ///< control the playback of a session: pause, seek, speed
  SetUp,           ///< choose the source that the server shows, and set the camera's exposure
  Listen,          ///< hear what doctor, patient and technician say, live and in recorded sessions
  SpeakAtPatient,  ///< speak at the patient's side (/patient/voice)
  SpeakAsDoctor,   ///< speak as the doctor (/doctor/voice)
};

inline constexpr std::array kRoles{Role::Technician, Role::Doctor, Role::Viewer, Role::Qa, Role::Local};
inline constexpr std::array kOperations{
    Operation::Watch, Operation::Touch, Operation::HandOver, Operation::Record,         Operation::Metrics,
    Operation::Play,  Operation::SetUp, Operation::Listen,   Operation::SpeakAtPatient, Operation::SpeakAsDoctor};

/// True if the table of permissions lists the pair; every other pair is denied.
[[nodiscard]] bool allows(Role role, Operation operation) noexcept;

[[nodiscard]] std::string_view name(Role role) noexcept;
[[nodiscard]] std::string_view name(Operation operation) noexcept;

/// The role with this name; nullopt: there is no role of this name, or a key cannot state it (`local`).
[[nodiscard]] std::optional<Role> role_named(std::string_view name) noexcept;

/// The names of the operations that `role` allows: "watch, record, listen" for a role that allows these three.
[[nodiscard]] std::string permissions(Role role);

}  // namespace telepalp::keys
