#pragma once

#include <netinet/in.h>

namespace telepalp::bench::link {

inline const sockaddr* plain(const sockaddr_in& address) { return reinterpret_cast<const sockaddr*>(&address); }

}  // namespace telepalp::bench::link
