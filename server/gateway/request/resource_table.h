#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "proto/keys/role.h"
#include "server/access/access.h"

namespace telepalp::gateway {

/// A resource of the server: where browsers POST its commands, who may, and what the others are told. Its state is a
/// latched topic, and GET answers it as well.
struct ResourceRow {
  std::string_view path;       ///< also the topic's name
  keys::Operation read;        ///< right to subscribe to the state, and to GET it
  keys::Operation change;      ///< right to POST a command, which changes something for all visitors
  keys::Operation change_own;  ///< right to POST a command in a reading, which nobody else sees
  std::string_view people;     ///< "only … may …": reply to a visitor without the right
  std::string_view pages;      ///< reply to a page of a foreign origin
  std::string_view absent;     ///< reply if the server does not have this resource
  bool empty_if_absent;        ///< GET then gets an empty state: a browser logs each 404 as an error of the page
  std::optional<access::AuditEvent> audited_as;  ///< each command is written to the audit log as this
};

/// Refusals of a command for a played session, over HTTP and over the WebSocket.
inline constexpr std::string_view kNoSession =
    "this server plays no session. fix: start telepalp-server with --source session:FILE.mcap";
inline constexpr std::string_view kOnlyForPlayers = "only technicians and QA may control a played session";

[[nodiscard]] std::span<const ResourceRow> all_resources() noexcept;

/// The resource at `path`; nullptr: there is none.
[[nodiscard]] const ResourceRow* resource_at(std::string_view path) noexcept;

}  // namespace telepalp::gateway
