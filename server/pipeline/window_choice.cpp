#include "server/pipeline/window_choice.h"

namespace telepalp::pipeline {

bool WindowChoice::ask(std::uint32_t sender, const DepthWindow& window, SessionTime now) noexcept {
  if (!one_asks_ && at(now) && asked_->sender != sender) return false;
  asked_ = {.sender = sender, .window = window, .at = now};
  return true;
}

std::optional<std::uint32_t> WindowChoice::followed(SessionTime now) const noexcept {
  return at(now) ? std::optional(asked_->sender) : std::nullopt;
}

std::optional<DepthWindow> WindowChoice::at(SessionTime now) const noexcept {
  return asked_ && now - asked_->at < kValid ? std::optional(asked_->window) : std::nullopt;
}

}  // namespace telepalp::pipeline
