#pragma once

#include <optional>
#include <span>
#include <string>

#include "codec/bytes/bytes.h"
#include "codec/levels/level_palette.h"

namespace telepalp::codec {

/// Appends a palette, range-coded: which levels of the palette before are kept, then those that are new, as
/// neighbouring levels lie nearly as far apart as the two before them. `before` has only 0 where there is none.
void append_coded_palette(std::string& body, const LevelPalette& palette, const LevelPalette& before);

/// nullopt when the bytes end too soon, or are damaged so that a level passes 65 535 or comes twice.
[[nodiscard]] std::optional<LevelPalette> read_coded_palette(ByteReader& reader, const LevelPalette& before);

}  // namespace telepalp::codec
