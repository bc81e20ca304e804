#include "proto/keys/role.h"

#include <algorithm>

namespace telepalp::keys {
namespace {

struct Permission {
  Role role;
  Operation operation;
};

constexpr std::array kPermissions{
    Permission{Role::Technician, Operation::Watch},
    Permission{Role::Technician, Operation::Record},
    Permission{Role::Technician, Operation::Metrics},
    Permission{Role::Technician, Operation::Play},
    Permission{Role::Technician, Operation::SetUp},
    Permission{Role::Technician, Operation::Listen},
    Permission{Role::Technician, Operation::SpeakAtPatient},

    Permission{Role::Doctor, Operation::Watch},
    Permission{Role::Doctor, Operation::Touch},
    Permission{Role::Doctor, Operation::HandOver},
    Permission{Role::Doctor, Operation::Record},
    Permission{Role::Doctor, Operation::Listen},
    Permission{Role::Doctor, Operation::SpeakAsDoctor},

    Permission{Role::Viewer, Operation::Watch},

    Permission{Role::Qa, Operation::Watch},
    Permission{Role::Qa, Operation::Record},
    Permission{Role::Qa, Operation::Metrics},
    Permission{Role::Qa, Operation::Play},
    Permission{Role::Qa, Operation::Listen},

    Permission{Role::Local, Operation::Watch},
    Permission{Role::Local, Operation::Touch},
    Permission{Role::Local, Operation::HandOver},
    Permission{Role::Local, Operation::Record},
    Permission{Role::Local, Operation::Metrics},
    Permission{Role::Local, Operation::Play},
    Permission{Role::Local, Operation::SetUp},
    Permission{Role::Local, Operation::Listen},
    Permission{Role::Local, Operation::SpeakAtPatient},
    Permission{Role::Local, Operation::SpeakAsDoctor},
};

}  // namespace

bool allows(Role role, Operation operation) noexcept {
  return std::any_of(kPermissions.begin(), kPermissions.end(),
                     [&](const Permission& row) { return row.role == role && row.operation == operation; });
}

std::string_view name(Role role) noexcept {
  switch (role) {
    case Role::Technician:
      return "technician";
    case Role::Doctor:
      return "doctor";
    case Role::Viewer:
      return "viewer";
    case Role::Qa:
      return "qa";
    case Role::Local:
      return "local";
  }
  return "?";
}

std::string_view name(Operation operation) noexcept {
  switch (operation) {
    case Operation::Watch:
      return "watch";
    case Operation::Touch:
      return "touch";
    case Operation::HandOver:
      return "hand over";
    case Operation::Record:
      return "record";
    case Operation::Metrics:
      return "metrics";
    case Operation::Play:
      return "play";
    case Operation::SetUp:
      return "set up";
    case Operation::Listen:
      return "listen";
    case Operation::SpeakAtPatient:
      return "speak at the patient's side";
    case Operation::SpeakAsDoctor:
      return "speak as the doctor";
  }
  return "?";
}

std::optional<Role> role_named(std::string_view text) noexcept {
  for (const Role role : kRoles)
    if (role != Role::Local && name(role) == text) return role;
  return std::nullopt;
}

std::string permissions(Role role) {
  std::string text;
  for (const Operation operation : kOperations)
    if (allows(role, operation)) text += (text.empty() ? "" : ", ") + std::string(name(operation));
  return text;
}

}  // namespace telepalp::keys
