#pragma once

#include "codec/model/contexts.h"

namespace telepalp::codec {

/// The tables that every slice of a key frame starts with. They are part of the format.
[[nodiscard]] const ContextTables& depth_tables();

/// The tables of frames with a reference frame: fewer groups, each with kBeforeClasses models.
[[nodiscard]] const ContextTables& dependent_depth_tables();

}  // namespace telepalp::codec
