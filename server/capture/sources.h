#pragma once

#include <memory>
#include <string>

#include "server/capture/capture_source.h"

namespace telepalp::capture {

/// Openers of the kinds of source for open_source(). The first argument is the text after the colon.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_camera(const std::string& uri, const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_oni(const std::string& file, const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_synthetic(const std::string& model,
                                                                    const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_images(const std::string& folder,
                                                                 const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_pcd(const std::string& file, const SourceOptions& options);
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_session(const std::string& file,
                                                                  const SourceOptions& options);

}  // namespace telepalp::capture
