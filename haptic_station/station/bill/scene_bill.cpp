#include "haptic_station/station/bill/scene_bill.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/station/bill/receiving.h"

namespace telepalp::station {
namespace {

constexpr double kTurn_s = 0.5;
constexpr double kWarmUp_s = 1.0;
constexpr std::size_t kReceived = 30;  // images whose receiving is measured

/// A scene that lacks what one line of the bill prices. A file cannot name a scene without effects, but its price is
/// needed.
struct Without {
  std::string name;
  scenes::Scene scene;
};

/// Removes effect `i`, and with a skin also the friction on it, which cannot be without a skin.
void remove_effect(Without& from, std::size_t i) {
  std::vector<effects::Recipe>& effects = from.scene.effects;
  const bool is_skin = std::holds_alternative<effects::SkinSettings>(effects[i]);
  effects.erase(effects.begin() + static_cast<std::ptrdiff_t>(i));
  if (is_skin && std::erase_if(effects, [](const effects::Recipe& recipe) {
                   return std::holds_alternative<effects::FrictionSettings>(recipe);
                 }) > 0)
    from.name = "skin and friction";
}

std::vector<Without> scenes_without(const scenes::Scene& scene, Detail detail) {
  std::vector<Without> all;
  const bool each = detail == Detail::EachEffect;
  const effects::EffectBank bank = core::bank_of(scene.effects);
  for (std::size_t i = 0; each && i < scene.effects.size(); ++i)
    remove_effect(all.emplace_back(bank.bill()[i].name, scene), i);
  if (scene.probe && each) all.emplace_back("ultrasound probe", scene).scene.probe.reset();
  scenes::Scene& bare = all.emplace_back("all of these", scene).scene;
  bare.effects.clear();
  bare.probe.reset();
  return all;
}

struct Session {
  std::unique_ptr<BilledStation> station;
  StationCost cost;
};

Session session_of(const scenes::Scene& scene, const SceneParts& parts, const BodyStream& stream) {
  return {std::make_unique<BilledStation>(scene, parts, stream), {}};
}

/// How much more processor time a part takes when its steps come at their own times, because its data have left the
/// caches. 1 for the control loop: what its ticks cost more is their waking, which no effect causes.
double slowed_when_live(const SceneBill& bill, Part part) {
  constexpr double kLeastShare = 0.05;  // of a core [%]; of less than this the ratio says nothing
  const double in_turn = bill.whole.share(part);
  return part == Part::Loop || in_turn < kLeastShare ? 1.0 : bill.live.share(part) / in_turn;
}

Price price_of(const std::string& name, const SceneBill& bill, const StationCost& without) {
  Price price{.name = name};
  for (std::size_t i = 0; i < kPartCount; ++i) {
    const auto part = static_cast<Part>(i);
    price.share[i] = slowed_when_live(bill, part) * (bill.whole.share(part) - without.share(part));
    price.total_share += price.share[i];
  }
  return price;
}

/// Adds what is known of each effect by itself.
void describe(const scenes::Scene& scene, const std::vector<double>& effects_us, const std::vector<MovingError>& errors,
              SceneBill& bill) {
  for (std::size_t i = 0; i < effects_us.size(); ++i) {
    bill.prices[i].tick_us = effects_us[i];
    bill.prices[i].error = errors[i];
  }
  for (const scenes::SceneLayer& layer : scene.layers()) {
    bill.prices[layer.effect].shapes = layer.solid->tree->shapes;
    bill.prices[layer.effect].bytes = layer.solid->tree->bytes();
  }
}

/// The first session is the scene as it is; one for each of scenes_without() follows.
std::vector<Session> sessions_of(const scenes::Scene& scene, const std::vector<Without>& without,
                                 const SceneParts& parts, const BodyStream& stream) {
  std::vector<Session> all;
  all.push_back(session_of(scene, parts, stream));
  for (const Without& one : without) all.push_back(session_of(one.scene, parts, stream));
  return all;
}

/// Calls `run` for each turn of a warm-up of a second and of `seconds`, with true if the turn is measured.
void in_turns(double seconds, const std::function<void(double done_s)>& begun, const std::function<void(bool)>& run) {
  const int turns = static_cast<int>(std::ceil((seconds + kWarmUp_s) / kTurn_s));
  for (int turn = 0; turn < turns; ++turn) {
    begun(kTurn_s * turn);
    run(kTurn_s * turn >= kWarmUp_s);
  }
}

/// Runs the sessions in turn, forwards and backwards, so that what disturbs the computer disturbs all of them alike.
void run_in_turn(std::vector<Session>& sessions, double seconds, const std::function<void(double done_s)>& begun) {
  in_turns(seconds, begun, [&sessions](bool is_measured) {
    StationCost warm_up;
    const auto run = [&](Session& session) {
      session.station->run(0.5 * kTurn_s, is_measured ? session.cost : warm_up);
    };
    std::ranges::for_each(sessions, run);
    std::for_each(sessions.rbegin(), sessions.rend(), run);
  });
}

/// Runs one session as live: each tick and each image at its own time.
void run_live(Session& session, double seconds, const std::function<void(double done_s)>& begun) {
  TickTimer timer(TickTimer::Clock::now() + loop::kTickPeriod, loop::kTickPeriod);
  in_turns(seconds, begun, [&](bool is_measured) {
    StationCost warm_up;
    session.station->run(kTurn_s, is_measured ? session.cost : warm_up, &timer);
  });
}

}  // namespace

double SceneBill::receiving_share() const noexcept { return 1e-4 * receiving_us * SeenBody::kFrames_per_s; }

double SceneBill::share() const noexcept { return live.share() + receiving_share(); }

Result<SceneBill> bill_of(const scenes::Scene& scene, const std::filesystem::path& file, double seconds, Detail detail,
                          const std::function<void(int done, int all)>& begun) {
  const Result<SceneParts> parts = read_parts(scene, file, true);
  if (!parts) return parts.error();
  static const SeenBody body;  // takes half a second to make
  const BodyStream stream(body, seconds + kWarmUp_s + 2.0 * kTurn_s);
  const std::vector<Without> without = scenes_without(scene, detail);
  std::vector<Session> sessions = sessions_of(scene, without, *parts, stream);
  Session live = session_of(scene, *parts, stream);
  const auto tell = [&](double done_s) {
    if (begun) begun(static_cast<int>(done_s), static_cast<int>(2.0 * (seconds + kWarmUp_s)));
  };
  run_in_turn(sessions, seconds, tell);
  run_live(live, seconds, [&](double done_s) { tell(seconds + kWarmUp_s + done_s); });
  const Session& whole = sessions.front();
  SceneBill bill{.whole = whole.cost,
                 .live = live.cost,
                 .receiving_us = parts->model ? 0.0 : receiving_us(std::span(stream.images).first(kReceived)),
                 .start_ms = whole.station->start_ms(),
                 .prices = {}};
  for (std::size_t i = 0; i < without.size(); ++i)
    bill.prices.push_back(price_of(without[i].name, bill, sessions[i + 1].cost));
  if (detail == Detail::EachEffect) {
    Result<std::vector<MovingError>> errors = errors_in_motion(scene, *parts, file, body, seconds);
    if (!errors) return errors.error();
    describe(scene, whole.station->effects_us(), *errors, bill);
  }
  return bill;
}

}  // namespace telepalp::station
