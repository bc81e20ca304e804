#pragma once

#include "codec/model/contexts.h"

namespace telepalp::codec {

/// The trained tables (contexts.h) with which every slice of a key frame starts. They are part of the format.
[[nodiscard]] const ContextTables& depth_tables();

/// The tables of frames with a reference frame: fewer groups of contexts, each group with kBeforeClasses models.
[[nodiscard]] const ContextTables& dependent_depth_tables();

}  // namespace telepalp::codec
