#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "proto/words/result.h"

namespace telepalp::study {

/// Where the page is served, and the secret in its address. Whoever knows the address may use the program.
struct Door {
  std::string listen = "127.0.0.1";  ///< an IP address of this machine
  std::uint16_t port = 0;
  std::string token;  ///< kTokenLetters letters and digits
};
inline constexpr std::size_t kTokenLetters = 32;

/// A token from the system's random bytes.
[[nodiscard]] std::string new_token();

/// The door that --listen and --port ask for, with a new token. Error: `listen` is no IP
/// address. `port` is a port, or 0 for any free one.
[[nodiscard]] Result<Door> new_door(const std::string& listen, std::int64_t port);

/// The address to open in a browser.
[[nodiscard]] std::string page_address(const Door& door);

/// True if `host`, a request's Host header, is the address of this page by a number or as localhost. Another name may
/// be that of a foreign page whose DNS name was made to resolve to this machine (DNS rebinding).
[[nodiscard]] bool host_is_ours(const Door& door, std::string_view host);

/// True if a page from `origin` may talk to the program: it is a page of `host`, which is ours. A program that sends no
/// origin is no browser, and needs the token alone.
[[nodiscard]] bool origin_is_ours(const Door& door, std::string_view origin, std::string_view host);

/// True if `target`, such as "/live?token=0123", has the door's token. Every token of this length takes
/// equally long, so the time does not help to guess it.
[[nodiscard]] bool has_token(const Door& door, std::string_view target);

}  // namespace telepalp::study
