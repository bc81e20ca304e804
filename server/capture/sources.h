#pragma once

#include <memory>
#include <string>

#include "server/capture/capture_source.h"

namespace telepalp::capture {

/// One function for each kind of source, which open_source() calls. The first argument is the part of --source after
/// the first colon: FILE of `oni:FILE`.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_camera(const std::string& uri, const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_oni(const std::string& file, const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_synthetic(const std::string& model,
                                                                    const SourceOptions& options);
/// Checks the words of MODEL.
[[nodiscard]] Result<void> check_synthetic(const std::string& model);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_images(const std::string& folder,
                                                                 const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_pcd(const std::string& file, const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_session(const std::string& file,
                                                                  const SourceOptions& options);

}  // namespace telepalp::capture
