#pragma once

#include <memory>

#include "tools/study/protocol/desk.h"
#include "tools/study/web/page_server.h"

namespace telepalp::study {

/// The page at which a participant works. Only one page at a time has the hand: a page that is opened later takes over.
/// Error: a file of the page is missing.
[[nodiscard]] Result<Page> protocol_page(std::shared_ptr<Desk> desk);

}  // namespace telepalp::study
