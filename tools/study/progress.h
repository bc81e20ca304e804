#pragma once

#include <functional>
#include <string>

#include "tools/study/run/parts.h"

namespace telepalp::study {

/// Tells how many of the parts were finished before, and what Ctrl-C keeps. The returned function tells how many are
/// done: in one line that changes, or on a log in eight steps. The line ends when the last part is done.
[[nodiscard]] std::function<void(int)> tell_progress(const Parts& parts);

}  // namespace telepalp::study
