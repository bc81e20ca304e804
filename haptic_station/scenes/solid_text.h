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

/// Converts a tree of the scene's text format to a solid. The text format has the words and numbers of the Polish
/// notation, so each can be converted to the other; a union of more than two solids becomes a chain of unions of two.
/// `where_part` gives the place of an error; if it is empty, `where` does.
/// Error: a solid without a kind, a missing number, one out of its range, the wrong number of operands, or a mesh that
/// cannot be read. The error names the path from the root, as in `union.of[2].translate`.
[[nodiscard]] Result<solids::Solid> solid_of(const msg::Solid& message, const std::string& where,
                                             const solids::MeshReader& meshes, const WherePart& where_part = {});

/// Converts a solid to a tree of the scene's text format.
[[nodiscard]] msg::Solid message_of(const solids::Solid& solid);

}  // namespace telepalp::scenes
