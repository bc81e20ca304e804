#pragma once

#include <string>
#include <string_view>

namespace telepalp::export_tool {

/// `jpeg` without comments, application data (Exif, thumbnails) and bytes behind its end; the picture itself is the
/// same to the byte. Empty: not a JPEG picture that begins and ends as one.
[[nodiscard]] std::string plain_jpeg(std::string_view jpeg);

}  // namespace telepalp::export_tool
