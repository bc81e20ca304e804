#pragma once

#include <functional>
#include <string>

#include "tools/study/run/parts.h"

namespace telepalp::study {

/// Logs how many parts were finished before, and makes Ctrl-C print which parts are kept. The returned function, called
/// with the number of parts that are done, shows it: on a terminal in one line, which goes away at the end; otherwise
/// as about eight log lines.
[[nodiscard]] std::function<void(int)> tell_progress(const Parts& parts);

}  // namespace telepalp::study
