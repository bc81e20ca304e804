#pragma once

#include <optional>
#include <span>
#include <string>

#include "codec/bytes/bytes.h"
#include "codec/levels/level_palette.h"

namespace telepalp::codec {

/// Appends a range-coded palette: first which levels of the palette `before` are kept, then the new levels. The shorter
/// of two codes writes the new levels: the offsets from a disparity law, or the second differences (a step is the
/// difference of successive levels; its change from the previous step is coded). `before` contains only 0 for a key
/// frame.
void append_coded_palette(std::string& body, const LevelPalette& palette, const LevelPalette& before);

/// nullopt: the bytes end too soon, or a level exceeds 65 535 or occurs twice.
[[nodiscard]] std::optional<LevelPalette> read_coded_palette(ByteReader& reader, const LevelPalette& before);

}  // namespace telepalp::codec
