#pragma once

namespace telepalp::study {

/// `telepalp-study protocol`: serves the page at which a person follows the protocol, until it is done or Ctrl-C.
/// Returns the process's exit code.
int run_protocol(int argc, const char* const* argv);

}  // namespace telepalp::study
