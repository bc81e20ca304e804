#pragma once

#include <functional>
#include <string>

#include "tools/study/run/parts.h"

namespace telepalp::study {

/// Logs how many parts were finished by an earlier run, and makes Ctrl-C print which parts are kept. Returns a function
/// that shows the number of parts that are done: in one line of the terminal, which is erased at the end, or in about
/// eight log lines if there is no terminal.
[[nodiscard]] std::function<void(int)> tell_progress(const Parts& parts);

}  // namespace telepalp::study
