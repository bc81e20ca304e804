#include "haptic_station/station/bill/scene_bill.h"

#include <algorithm>
#include <memory>

namespace telepalp::station {
namespace {

constexpr double kPaced_s = 2.0;

/// A scene that lacks what one line of the bill prices.
struct Without {
  std::string name;
  msg::Scene message;
};

std::string name_of(const scenes::Scene& scene, std::size_t effect) { return scene.effects.bill()[effect].name; }

/// Removes effect `i`, and with a skin also the friction on it, which cannot be without a skin.
void remove_effect(Without& from, int i) {
  auto& effects = *from.message.mutable_effects();
  const bool is_skin = effects.at(i).has_skin();
  effects.DeleteSubrange(i, 1);
  if (!is_skin) return;
  for (int other = effects.size() - 1; other >= 0; --other) {
    if (!effects.at(other).has_friction()) continue;
    effects.DeleteSubrange(other, 1);
    from.name = "skin and friction";
  }
}

std::vector<Without> scenes_without(const scenes::Scene& scene, Detail detail) {
  std::vector<Without> all;
  const bool each = detail == Detail::EachEffect;
  const int effects = each ? scene.message.effects_size() : 0;
  for (int i = 0; i < effects; ++i) {
    remove_effect(all.emplace_back(name_of(scene, static_cast<std::size_t>(i)), scene.message), i);
  }
  if (scene.probe && each) all.emplace_back("ultrasound probe", scene.message).message.clear_probe();
  Without& bare = all.emplace_back("all of these", scene.message);
  bare.message.clear_effects();
  bare.message.clear_probe();
  return all;
}

/// A file cannot name a scene without effects, but its price is needed.
Result<scenes::Scene> scene_of(msg::Scene message, const std::filesystem::path& file) {
  const bool bare = message.effects().empty();
  if (bare) message.add_effects()->mutable_skin();
  Result<scenes::Scene> scene = scenes::make_scene(message, file);
  if (scene && bare) scene->effects = {};
  return scene;
}

struct Session {
  std::unique_ptr<BilledStation> station;
  StationCost cost;
};

Result<Session> session_of(const msg::Scene& message, const std::filesystem::path& file, const SceneParts& parts,
                           const BodyStream& stream) {
  Result<scenes::Scene> scene = scene_of(message, file);
  if (!scene) return scene.error();
  return Session{std::make_unique<BilledStation>(*scene, parts, stream), {}};
}

Price price_of(const std::string& name, const StationCost& with, const StationCost& without) {
  Price price{.name = name};
  for (std::size_t i = 0; i < kPartCount; ++i)
    price.share[i] = with.share(static_cast<Part>(i)) - without.share(static_cast<Part>(i));
  price.total_share = with.share() - without.share();
  return price;
}

/// Adds what is known of each effect by itself.
void describe(const scenes::Scene& scene, const std::vector<double>& effects_us, const std::vector<MovingError>& errors,
              SceneBill& bill) {
  for (std::size_t i = 0; i < effects_us.size(); ++i) {
    bill.prices[i].tick_us = effects_us[i];
    bill.prices[i].error = errors[i];
  }
  for (const scenes::SceneLayer& layer : scene.layers) {
    bill.prices[layer.effect].shapes = layer.solid->tree->shapes;
    bill.prices[layer.effect].bytes = layer.solid->tree->bytes();
  }
}

/// The first session is the scene as it is; one for each of scenes_without() follows.
Result<std::vector<Session>> sessions_of(const scenes::Scene& scene, const std::vector<Without>& without,
                                         const std::filesystem::path& file, const SceneParts& parts,
                                         const BodyStream& stream) {
  std::vector<Session> all;
  Result<Session> whole = session_of(scene.message, file, parts, stream);
  if (!whole) return whole.error();
  all.push_back(std::move(whole).value());
  for (const Without& one : without) {
    Result<Session> session = session_of(one.message, file, parts, stream);
    if (!session) return session.error();
    all.push_back(std::move(session).value());
  }
  return all;
}

}  // namespace

double SceneBill::share() const noexcept { return whole.share() - whole.share(Part::Loop) + paced.share(Part::Loop); }

Result<SceneBill> bill_of(const scenes::Scene& scene, const std::filesystem::path& file, double seconds, Detail detail,
                          const std::function<void(int done, int all)>& begun) {
  const Result<SceneParts> parts = read_parts(scene, file, true);
  if (!parts) return parts.error();
  static const SeenBody body;  // takes half a second to make
  const BodyStream stream(body, seconds + 2.0 + kPaced_s);
  const std::vector<Without> without = scenes_without(scene, detail);
  Result<std::vector<Session>> sessions = sessions_of(scene, without, file, *parts, stream);
  if (!sessions) return sessions.error();
  const int turns = static_cast<int>(seconds) + 1;
  for (int turn = 0; turn < turns; ++turn) {
    if (begun) begun(turn, turns);
    for (Session& session : *sessions) {
      StationCost warm_up;
      session.station->run(1.0, turn == 0 ? warm_up : session.cost);
    }
  }
  const Session& whole = sessions->front();
  SceneBill bill{.whole = whole.cost, .paced = {}, .start_ms = whole.station->start_ms(), .prices = {}};
  for (std::size_t i = 0; i < without.size(); ++i)
    bill.prices.push_back(price_of(without[i].name, whole.cost, (*sessions)[i + 1].cost));
  if (detail == Detail::EachEffect) {
    Result<std::vector<MovingError>> errors = errors_in_motion(scene, *parts, file, body, seconds);
    if (!errors) return errors.error();
    describe(scene, whole.station->effects_us(), *errors, bill);
  }
  TickTimer timer(TickTimer::Clock::now() + kTickPeriod, kTickPeriod);
  whole.station->run(kPaced_s, bill.paced, &timer);
  return bill;
}

}  // namespace telepalp::station
