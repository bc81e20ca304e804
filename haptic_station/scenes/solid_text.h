#pragma once

#include <filesystem>
#include <functional>

#include "haptic_station/solids/polish.h"
#include "messages/solid.pb.h"

namespace telepalp::scenes {

/// Gives the place of `part`, a part of the message, in its file, for errors; if `number` is not empty, the place of
/// the number of this name and value in `part`.
using WherePart =
    std::function<std::string(const google::protobuf::Message& part, std::string_view number, double value)>;

/// A tree of the scene's text format as a solid. Its words and numbers are those of the Polish notation, so the two
/// can be turned into each other; a union of several solids is a chain of unions. `where_part` and, if it is empty,
/// `where` give the place of an error.
/// Error: a solid without a kind, a missing number, one out of its range, the wrong number of operands, or a mesh that
/// cannot be read. The error names the path from the root, as in `union.of[2].translate`.
[[nodiscard]] Result<solids::Solid> solid_of(const msg::Solid& message, const std::string& where,
                                             const solids::MeshReader& meshes, const WherePart& where_part = {});

/// Converts a solid to a tree of the scene's text format.
[[nodiscard]] msg::Solid message_of(const solids::Solid& solid);

}  // namespace telepalp::scenes
