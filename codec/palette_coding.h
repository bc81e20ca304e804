#pragma once

#include <optional>
#include <span>
#include <string>

#include "codec/bytes.h"
#include "codec/level_palette.h"

namespace telepalp::codec {

/// Appends a palette, range-coded: neighbouring levels lie nearly as far apart as the two before them.
void append_coded_palette(std::string& body, const LevelPalette& palette);

/// nullopt when the bytes are damaged so that a level passes 65 535, or end too soon.
[[nodiscard]] std::optional<LevelPalette> read_coded_palette(ByteReader& reader);

}  // namespace telepalp::codec
