#include "tools/study/designer/designer_page.h"

#include <algorithm>
#include <optional>
#include <variant>

#include "tools/study/designer/answers.h"
#include "tools/study/designer/command.h"
#include "tools/study/designer/device_design.h"
#include "tools/study/designer/live_design.h"
#include "tools/study/task/tools.h"

namespace telepalp::study {
namespace {

constexpr double kLongestStep_s = 0.05;  // a program that was late makes the tissue slow, not the hand fast
constexpr const char* kFiles[] = {"tools/study/designer/page/index.html",    "tools/study/designer/page/designer.css",
                                  "tools/study/designer/page/icon.svg",      "tools/study/designer/page/chart.js",
                                  "tools/study/designer/page/compare.js",    "tools/study/designer/page/designer.js",
                                  "tools/study/designer/page/drawing.js",    "tools/study/designer/page/link.js",
                                  "tools/study/designer/page/parameters.js", "tools/study/designer/page/search.js",
                                  "tools/study/designer/page/theme.js"};

class DesignerConversation final : public Conversation {
 public:
  DesignerConversation(LiveDesign live, Workers& workers, DeviceThread* device,
                       const boost::asio::any_io_executor& network, const Say& say)
      : live_(std::move(live)), say_(say), background_(workers, network, say) {
    if (device != nullptr) device_.emplace(*device);
  }

  std::string greeting() override { return given(live_.renew()); }

  void hear(std::string_view message) override {
    Result<Command> command = parse_command(message);
    if (!command)
      return say_(refused_json(message.starts_with("design")   ? "design"
                               : message.starts_with("search") ? "search"
                                                               : "message",
                               command.error()));
    std::visit([this](auto&& asked) { obey(std::forward<decltype(asked)>(asked)); }, std::move(*command));
  }

  std::optional<std::string> step(double seconds) override {
    return device_ ? device_->step() : live_.step(std::min(seconds, kLongestStep_s));
  }

 private:
  /// `answer`, after the device has got the linkage as it is now.
  std::string given(std::string answer) {
    if (device_) device_->give(live_.tool());
    return answer;
  }
  void obey(const ChooseDesign& asked) {
    background_.forget_prediction();
    const std::optional<LiveFrame> held = device_ ? device_->held() : std::nullopt;
    if (!held) return say_(given(live_.choose(asked.design)));
    say_(live_.change(asked.design, *held));
    device_->change(bar_of(live_.design(), Plant{}));
  }
  void obey(TakePart asked) { live_.take(asked.part, asked.at_m); }
  void obey(AimHand asked) { live_.aim(asked.at_m); }
  void obey(PressButton asked) {
    if (device_) device_->press(asked.pressed);
  }
  void obey(TurnHandle asked) { live_.turn(asked.by_rad); }
  void obey(RenewTissue) { say_(given(live_.renew())); }
  void obey(AskPrediction) { background_.predict(live_.design()); }
  void obey(const BeginSearch& asked) { background_.search(asked.box, asked.evaluations); }
  void obey(EndSearch) { background_.end_search(); }

  LiveDesign live_;
  Say say_;
  Background background_;
  std::optional<DeviceDesign> device_;
};

}  // namespace

Result<PageFiles> designer_files() { return read_page_files(kFiles); }

Result<Page> designer_page(Workers& workers, DeviceThread* device) {
  Result<PageFiles> files = designer_files();
  if (!files) return files.error();
  const Result<LiveDesign> first = LiveDesign::make();  // its tissue takes long to make
  if (!first) return first.error();
  return Page{.files = std::move(*files),
              .open =
                  [first = *first, &workers, device](const boost::asio::any_io_executor& network, const Say& say) {
                    return std::make_unique<DesignerConversation>(first, workers, device, network, say);
                  },
              .most_message_bytes = kMostCommandBytes};
}

}  // namespace telepalp::study
