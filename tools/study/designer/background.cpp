#include "tools/study/designer/background.h"

#include <boost/asio/post.hpp>
#include <utility>

#include "tools/study/designer/answers.h"

namespace telepalp::study {
namespace {

constexpr int kPenetrations = 5;
constexpr int kSearchPenetrations = 3;
// The operators who judge the front again. `telepalp-study search` has 36 of them, but here somebody waits for the
// answer.
constexpr int kHeldOut = 12;

/// The judgement of all operators, made one operator at a time, so that the page can show how far it is, and can give
/// it up. `tell` gets the progress. nullopt: it was given up.
std::optional<Result<Judgement>> judge(const Configuration& design, Workers& workers, const std::stop_token& stop,
                                       const std::function<void(std::string)>& tell) {
  const JudgeSettings& settings = workers.settings;
  Judgement all;
  double noticed = 0.0;
  int punctured = 0;
  for (int i = 0; i < settings.operators; ++i) {
    tell(predicting_json(i, settings.operators));
    const auto number = static_cast<std::size_t>(i);
    if (number == workers.panels.size()) {  // a tissue takes much longer to make than to use
      Result<Panel> one = Panel::of(settings.seed, number, 1, 1);
      if (!one) return Result<Judgement>(one.error());
      workers.panels.push_back(std::move(*one));
    }
    if (stop.stop_requested()) return std::nullopt;
    const Judgement own = workers.panels[number].judge(design, kPenetrations, 1);
    if (stop.stop_requested()) return std::nullopt;
    if (!own.refused.empty())
      return Result<Judgement>(Error{.what = own.refused, .where = "prediction", .fix = "change a length or an angle"});
    const int through = kPenetrations - own.failed;
    noticed += own.noticed_share * through;
    punctured += through;
    all.failed += own.failed;
    all.never += own.never;
    all.overshoots_mm.push_back(own.overshoots_mm.front());
    all.hands_N.push_back(own.hands_N.front());
  }
  all.noticed_share = punctured > 0 ? noticed / punctured : 0.0;
  summarise(all);
  return Result<Judgement>(std::move(all));
}

}  // namespace

Background::Background(Workers& workers, boost::asio::any_io_executor network, Tell tell)
    : workers_(workers), network_(std::move(network)), tell_(std::make_shared<const Tell>(std::move(tell))) {}

Background::~Background() {
  prediction_.request_stop();
  search_.request_stop();
}

/// Posts each answer to the network thread. It is dropped there if the page has left, or `stop` was requested.
std::function<void(std::string)> Background::from_worker(std::stop_token stop) const {
  return [network = network_, tell = std::weak_ptr<const Tell>(tell_), stop = std::move(stop)](std::string text) {
    boost::asio::post(network, [tell, stop, text = std::move(text)]() mutable {
      const std::shared_ptr<const Tell> page = tell.lock();
      if (page && !stop.stop_requested()) (*page)(std::move(text));
    });
  };
}

void Background::predict(const Configuration& design) {
  prediction_.request_stop();
  prediction_ = {};
  const std::stop_token stop = prediction_.get_token();
  boost::asio::post(workers_.predictions, [design, stop, &workers = workers_, tell = from_worker(stop)] {
    if (stop.stop_requested()) return;
    const auto judged = judge(design, workers, stop, tell);
    if (judged) tell(*judged ? prediction_json(**judged) : refused_json("prediction", judged->error()));
  });
}

void Background::search(const SearchBox& box, int evaluations) {
  search_.request_stop();
  search_ = {};
  const SearchSettings settings{.operators = workers_.settings.operators,
                                .penetrations = kSearchPenetrations,
                                .held_out = kHeldOut,
                                .seed = workers_.settings.seed,
                                .evaluations = evaluations,
                                .threads = workers_.settings.threads};
  // A search that was stopped answers, too, with the front that it has found so far.
  boost::asio::post(workers_.searches, [box, settings, stop = search_.get_token(), tell = from_worker({})] {
    const SearchProgress progress = [&tell](const SearchState& state) { tell(searching_json(state)); };
    const Result<SearchResult> found = search_designs(box, settings, progress, stop);
    tell(found ? found_json(*found) : refused_json("search", found.error()));
  });
}

}  // namespace telepalp::study
