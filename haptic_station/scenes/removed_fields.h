#pragma once

#include "proto/words/result.h"

namespace telepalp::scenes {

/// The parser's error about a field that scenes once had, with what to write instead as its fix; any other error as it
/// is.
[[nodiscard]] Error with_what_to_write_instead(Error error);

}  // namespace telepalp::scenes
