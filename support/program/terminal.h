#pragma once

#include <cstdio>

namespace telepalp::program {

/// Whether a line may be drawn over on `stream`: it is a terminal, and one that can do it (TERM is not "dumb").
[[nodiscard]] bool takes_progress(std::FILE* stream);

/// Whether text on `stream` may be coloured: as takes_progress(), and NO_COLOR is unset or empty.
[[nodiscard]] bool takes_colour(std::FILE* stream);

}  // namespace telepalp::program
