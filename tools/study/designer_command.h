#pragma once

namespace telepalp::study {

/// `telepalp-study designer`: serves the page until Ctrl-C. Returns the process's exit code.
int run_designer(int argc, const char* const* argv);

}  // namespace telepalp::study
