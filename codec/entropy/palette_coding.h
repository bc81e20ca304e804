#pragma once

#include <optional>
#include <span>
#include <string>

#include "codec/bytes/bytes.h"
#include "codec/levels/level_palette.h"

namespace telepalp::codec {

/// Appends a range-coded palette (a frame's distinct depths, its levels): first which levels of the palette `before`
/// are kept, then the new levels. The new levels are coded in two ways, of which the shorter is kept: as offsets from a
/// DisparityLaw, or as second differences of successive levels. `before` contains only 0 for a key frame.
void append_coded_palette(std::string& body, const LevelPalette& palette, const LevelPalette& before);

/// nullopt: the bytes end too soon, or a level exceeds 65 535 or occurs twice.
[[nodiscard]] std::optional<LevelPalette> read_coded_palette(ByteReader& reader, const LevelPalette& before);

}  // namespace telepalp::codec
