#include "tools/study/protocol/protocol_page.h"

#include "proto/wire/session_clock.h"
#include "tools/study/protocol/page_answers.h"

namespace telepalp::study {
namespace {

constexpr const char* kFiles[] = {"tools/study/protocol/page/index.html",   "tools/study/protocol/page/protocol.css",
                                  "tools/study/protocol/page/protocol.js",  "tools/study/protocol/page/bench.js",
                                  "tools/study/designer/page/designer.css", "tools/study/designer/page/icon.svg",
                                  "tools/study/designer/page/chart.js",     "tools/study/designer/page/link.js",
                                  "tools/study/designer/page/theme.js"};

class ProtocolConversation;

/// The desk, and the page that has the hand.
struct Shared {
  std::shared_ptr<Desk> desk;  // shared with the command, which reads the journal when all pages are closed
  ProtocolConversation* holder = nullptr;
};

class ProtocolConversation final : public Conversation {
 public:
  ProtocolConversation(std::shared_ptr<Shared> shared, Say say) : shared_(std::move(shared)), say_(std::move(say)) {
    if (shared_->holder != nullptr) shared_->holder->lose();
    shared_->holder = this;
  }
  ~ProtocolConversation() override {
    if (!holds()) return;
    desk().leave();
    shared_->holder = nullptr;
  }

  std::string greeting() override { return desk().state(); }

  void hear(std::string_view message) override {
    if (!holds()) return;
    const Result<PageCommand> command = parse_page_command(message);
    if (!command) return say_(page_refused_json(command.error()));
    if (!desk().obey(*command, clock_.now())) return;
    say_(desk().state());
    if (const std::optional<std::string> frame = desk().frame()) say_(*frame);
  }

  std::optional<std::string> step(double seconds) override {
    if (!holds() || !desk().moves()) return std::nullopt;
    if (!desk().step(seconds)) return desk().frame();
    if (desk().lost()) say_(page_refused_json(*desk().lost()));
    return desk().state();
  }

 private:
  [[nodiscard]] bool holds() const noexcept { return shared_->holder == this; }
  [[nodiscard]] Desk& desk() noexcept { return *shared_->desk; }
  void lose() {
    desk().leave();
    say_(taken_json());
  }

  const wire::SessionClock clock_ = wire::SessionClock::anchored_to_wall_clock();
  std::shared_ptr<Shared> shared_;  // shared: each page may be the last one that is closed
  Say say_;
};

}  // namespace

Result<Page> protocol_page(std::shared_ptr<Desk> desk) {
  Result<PageFiles> files = read_page_files(kFiles);
  if (!files) return files.error();
  auto shared = std::make_shared<Shared>(Shared{.desk = std::move(desk)});
  return Page{.files = std::move(*files),
              .open = [shared = std::move(shared)](
                          const boost::asio::any_io_executor&,
                          Say say) { return std::make_unique<ProtocolConversation>(shared, std::move(say)); },
              .most_message_bytes = kMostPageCommandBytes};
}

}  // namespace telepalp::study
