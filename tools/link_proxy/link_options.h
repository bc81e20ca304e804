#pragma once

#include "support/program/options.h"
#include "tools/link_proxy/link_proxy.h"

namespace telepalp::link_proxy {

[[nodiscard]] program::Usage usage();

/// The proxy's options from the command line. Options such as `--loss-percent` replace values of the named network
/// profile (`--profile`). A trace (`--trace`) replaces delay, jitter, loss and rate, whatever the options say.
[[nodiscard]] Result<ProxyOptions> proxy_options(const program::Arguments& arguments);

}  // namespace telepalp::link_proxy
