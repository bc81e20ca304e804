#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "proto/words/depth/depth_window.h"
#include "proto/words/time.h"

namespace telepalp::pipeline {

/// Decides which station's window of exact depth the server follows. With keys only the station that holds the touch
/// can ask, so the newest request counts. Without keys, the server follows the station that asked first, until that
/// station is silent for kValid. Pure; owner: the server's network thread.
class WindowChoice {
 public:
  /// How long a request is followed; a station sends several a second.
  static constexpr std::chrono::seconds kValid{1};

  /// `one_asks`: only one station at a time can ask, as with keys.
  explicit WindowChoice(bool one_asks) noexcept : one_asks_(one_asks) {}

  /// Station number `sender` asks for `window`. False: another station's window is followed.
  bool ask(std::uint32_t sender, const DepthWindow& window, SessionTime now) noexcept;

  /// The station whose window the server follows at `now`; nullopt: none.
  [[nodiscard]] std::optional<std::uint32_t> followed(SessionTime now) const noexcept;

  /// The window that the server follows at `now`; nullopt: no request is valid, so images are exact everywhere.
  [[nodiscard]] std::optional<DepthWindow> at(SessionTime now) const noexcept;

 private:
  struct Asked {
    std::uint32_t sender = 0;
    DepthWindow window;
    SessionTime at{};
  };
  bool one_asks_;
  std::optional<Asked> asked_;
};

}  // namespace telepalp::pipeline
