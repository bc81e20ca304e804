#pragma once

#include <filesystem>
#include <functional>

#include "haptic_station/solids/polish.h"
#include "messages/solid.pb.h"

namespace telepalp::scenes {

using WhereNumber = std::function<std::string(std::string_view name, double value)>;

/// A tree of the scene's text format as a solid. Its words and numbers are those of the Polish notation, so the two
/// can be turned into each other; a union of several solids is a chain of unions. `where` and `where_number`, the place
/// of a number by its name and value, are for errors.
/// Error: a solid without a kind, a missing number, one out of its range, or the wrong number of operands. The error
/// names the path from the root, as in `union.of[2].translate`.
[[nodiscard]] Result<solids::Solid> solid_of(const msg::Solid& message, const std::string& where,
                                             const solids::MeshReader& meshes, const WhereNumber& where_number = {});

/// Converts a solid to a tree of the scene's text format.
[[nodiscard]] msg::Solid message_of(const solids::Solid& solid);

}  // namespace telepalp::scenes
