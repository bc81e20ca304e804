#pragma once

#include <memory>
#include <utility>

namespace telepalp::program {

/// Guards handlers that name an object and may run after its end. Cancelling a timer, or closing an acceptor, does not
/// take back a handler that already waits in the io_context, so a handler must not rely on its error code alone. A
/// member of the object, the last one. Owner: the thread of the io_context.
class WhileAlive {
 public:
  /// `handler`, which does nothing once this object has been destroyed.
  template <class Handler>
  [[nodiscard]] auto guard(Handler handler) const {
    return [alive = std::weak_ptr<const char>(token_), handler = std::move(handler)](auto&&... arguments) mutable {
      if (!alive.expired()) handler(std::forward<decltype(arguments)>(arguments)...);
    };
  }

 private:
  std::shared_ptr<const char> token_ = std::make_shared<const char>('\0');  // shared_ptr: handlers ask whether it lives
};

}  // namespace telepalp::program
