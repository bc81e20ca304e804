#pragma once

#include "tools/link_proxy/impaired_line.h"

namespace telepalp::link_proxy {

/// Both directions of the proxy, and the numbering of its flows. A flow is a TCP connection or a UDP client.
struct Lines {
  ImpairedLine to_server;
  ImpairedLine to_client;
  std::uint64_t flows = 0;

  [[nodiscard]] std::uint64_t new_flow() noexcept { return ++flows; }
};

}  // namespace telepalp::link_proxy
