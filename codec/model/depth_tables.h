#pragma once

#include "codec/model/contexts.h"

namespace telepalp::codec {

/// What every slice of a Contexts packet begins with; part of the format.
[[nodiscard]] const ContextTables& depth_tables();

/// The same for a Dependent packet: fewer clusters, each with kBeforeClasses models.
[[nodiscard]] const ContextTables& dependent_depth_tables();

}  // namespace telepalp::codec
