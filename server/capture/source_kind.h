#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "server/capture/capture_source.h"

namespace telepalp::server {

/// One kind of source: what stands before the colon of --source, and how the rest is opened.
struct SourceKind {
  std::string_view name;
  Result<std::unique_ptr<CaptureSource>> (*open)(const std::string& rest, const SourceOptions& options);
  bool needs_rest;  ///< a file or directory must follow the colon
};

/// Opens `spec` by the kind that it names. `forms`: how to write a source, for errors.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_by_kind(std::string_view spec,
                                                                  std::span<const SourceKind> kinds,
                                                                  std::string_view forms, const SourceOptions& options);

}  // namespace telepalp::server
