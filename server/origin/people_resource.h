#pragma once

#include "server/access/access.h"
#include "server/origin/resources.h"

namespace telepalp::origin {

/// Who sees the patient now (msg::PeopleState). By msg::PeopleCommand a technician sends a person out, lets one in
/// again, or takes the touch away. `access` must outlive the resource.
[[nodiscard]] Resource people_resource(access::Access& access);

}  // namespace telepalp::origin
