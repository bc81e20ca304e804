#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace telepalp::station {

/// Decides which topics of depth the station subscribes to, and from which of them the surface is made. Some servers
/// publish no depth with a window (/camera/depth/window): those that play a session, and those older than the window.
/// So a station that asks for windows also subscribes to whole images (/camera/depth) when no image with a window has
/// come for kPatience, and uses them until such an image comes. Pure; owner: the network thread.
class DepthChoice {
 public:
  using TimePoint = std::chrono::steady_clock::time_point;
  static constexpr std::chrono::seconds kPatience{3};

  explicit DepthChoice(bool asks_window) noexcept : takes_(asks_window ? Takes::Window : Takes::Whole) {}

  [[nodiscard]] std::vector<std::string> topics() const;
  /// True while the server is asked for windows.
  [[nodiscard]] bool asks_window() const noexcept { return takes_ == Takes::Window; }

  /// The link is connected: kPatience begins.
  void connected(TimePoint now) noexcept { waiting_since_ = now; }
  /// Call it each second while the link is connected. True: topics() has changed.
  [[nodiscard]] bool look(TimePoint now) noexcept;

  struct Came {
    bool is_used = false;             ///< the surface is made from this message
    bool topics_changed = false;      ///< topics() has changed
    std::optional<std::string> said;  ///< for people: from which depth the surface is made from now on
  };
  /// A message of `topic` came.
  [[nodiscard]] Came came(std::string_view topic, TimePoint now);

 private:
  enum class Takes {
    Whole,   ///< no windows are asked for
    Window,  ///< images with a window
    Either,  ///< no image with a window has come for kPatience
  };
  Takes takes_;
  TimePoint waiting_since_{};  // connected, or when the newest image with a window came
  bool uses_whole_ = false;    // people know that the surface is made from whole images, although windows are asked for
};

}  // namespace telepalp::station
