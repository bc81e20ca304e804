#pragma once

#include "support/program/json.h"

namespace telepalp::report {

using program::Json;

}  // namespace telepalp::report
