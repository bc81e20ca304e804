#include "support/program/version.h"

namespace telepalp::program {

const char* version() noexcept { return TELEPALP_VERSION; }
const char* commit() noexcept { return TELEPALP_COMMIT; }

}  // namespace telepalp::program
