#pragma once

#include <filesystem>
#include <functional>

#include "haptic_station/solids/polish.h"
#include "messages/solid.pb.h"

namespace telepalp::scenes {

/// Returns the position of `part`, a part of the scene's message, in the scene file, for errors. If `number` is not
/// empty: the position of the number in `part` that has this name and value.
using WherePart =
    std::function<std::string(const google::protobuf::Message& part, std::string_view number, double value)>;

/// Converts a tree of the scene's text format to a solid. The text format has the words and numbers of the Polish
/// notation, so each can be converted to the other; a union of more than two solids becomes a chain of unions of two.
/// Errors have the place that `where_part` returns, or, if `where_part` is empty, the place `where`.
/// Error: a solid without a kind, a missing number, one out of its range, the wrong number of operands, or a mesh that
/// cannot be read. The error names the path from the root, as in `union.of[2].translate`.
[[nodiscard]] Result<solids::Solid> solid_of(const msg::Solid& message, const std::string& where,
                                             const solids::MeshReader& meshes, const WherePart& where_part = {});

/// Converts a solid to a tree of the scene's text format.
[[nodiscard]] msg::Solid message_of(const solids::Solid& solid);

}  // namespace telepalp::scenes
