#pragma once

#include <string>
#include <string_view>

namespace telepalp::export_tool {

/// `jpeg` without comments, application data (Exif, thumbnails) and bytes after its end. All other bytes are unchanged.
/// Empty: `jpeg` does not have the form of a JPEG picture.
[[nodiscard]] std::string plain_jpeg(std::string_view jpeg);

}  // namespace telepalp::export_tool
