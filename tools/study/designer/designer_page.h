#pragma once

#include "tools/study/designer/background.h"
#include "tools/study/web/page_server.h"

namespace telepalp::study {

/// The files of the designer's page. Error: one is missing.
[[nodiscard]] Result<PageFiles> designer_files();

/// The designer's page: it sends commands (command.h) and gets answers (answers.h). `workers` must outlive it. Error: a
/// file of the page is missing, or the tissue cannot be made.
[[nodiscard]] Result<Page> designer_page(Workers& workers);

}  // namespace telepalp::study
