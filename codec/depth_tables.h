#pragma once

#include "codec/depth_contexts.h"

namespace telepalp::codec {

/// The tables that every Contexts packet begins with; part of the format.
[[nodiscard]] const ContextTables& depth_tables();

}  // namespace telepalp::codec
