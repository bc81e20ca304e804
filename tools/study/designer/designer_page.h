#pragma once

#include "tools/study/designer/background.h"
#include "tools/study/device/device_thread.h"
#include "tools/study/web/page_server.h"

namespace telepalp::study {

/// The files of the designer's page. Error: one is missing.
[[nodiscard]] Result<PageFiles> designer_files();

/// The designer's page: it sends commands (command.h) and gets answers (answers.h). `workers` and
/// `device` must outlive it. `device`: moves the linkage of the page that opened last; nullptr: each page's mouse and
/// keys move its own. Error: a
/// file of the page is missing, or the tissue cannot be made.
[[nodiscard]] Result<Page> designer_page(Workers& workers, DeviceThread* device);

}  // namespace telepalp::study
