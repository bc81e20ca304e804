#pragma once

#include <chrono>
#include <string>

#include "proto/keys/role.h"

namespace telepalp::keys {

using WallTime = std::chrono::system_clock::time_point;

/// The person whom a verified certificate or token names.
struct Identity {
  std::string name;  ///< "anna"
  Role role = Role::Viewer;
  /// Serial number of the certificate or token, in hexadecimal. A revocation list names revoked keys by it.
  std::string serial;
  WallTime expires{};
};

/// "doctor anna"
[[nodiscard]] inline std::string describe(const Identity& identity) {
  return std::string(name(identity.role)) + " " + identity.name;
}

}  // namespace telepalp::keys
