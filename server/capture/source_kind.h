#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "server/capture/capture_source.h"

namespace telepalp::capture {

/// One kind of source: the word before the colon in `--source KIND:REST`, and the function that opens REST.
struct SourceKind {
  std::string_view name;
  Result<std::unique_ptr<CaptureSource>> (*open)(const std::string& rest, const SourceOptions& options);
  bool needs_rest;  ///< a file or directory must follow the colon
};

/// The entry of `kinds` that `spec` (KIND or KIND:REST) names. Error: there is none, or REST is missing. `forms`: as
/// for open_by_kind().
[[nodiscard]] Result<const SourceKind*> kind_of(std::string_view spec, std::span<const SourceKind> kinds,
                                                std::string_view forms);

/// Opens `spec` (KIND or KIND:REST) by the entry of `kinds` named KIND. `forms`: the syntax of all kinds, for errors.
[[nodiscard]] Result<std::unique_ptr<CaptureSource>> open_by_kind(std::string_view spec,
                                                                  std::span<const SourceKind> kinds,
                                                                  std::string_view forms, const SourceOptions& options);

}  // namespace telepalp::capture
