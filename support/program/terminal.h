#pragma once

#include <cstdio>

namespace telepalp::program {

/// True if a program may redraw a progress line on `stream`: it is a terminal and TERM is not "dumb".
[[nodiscard]] bool takes_progress(std::FILE* stream);

/// True if text on `stream` may be coloured: it is a terminal, TERM is not "dumb", and NO_COLOR is unset or empty.
[[nodiscard]] bool takes_colour(std::FILE* stream);

}  // namespace telepalp::program
