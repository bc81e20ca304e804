// Only the effects of a scene cost time. The test counts every function that the real-time part enters over a whole
// trial, by the effect's class. The sources are compiled with -finstrument-functions, which also counts inlined
// functions.

#include <cxxabi.h>
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <ostream>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "haptic_station/core/built_effects.h"
#include "haptic_station/device/breathing_plane.h"
#include "haptic_station/scenes/scene.h"
#include "haptic_station/trials/virtual_station.h"
#include "where.h"

namespace {

/// Number of entries by function, with open addressing. The hooks write it and must not call instrumented functions.
struct Entered {
  void* function = nullptr;
  std::uint64_t times = 0;
};
constexpr std::size_t kMostFunctions = 4096;
std::array<Entered, kMostFunctions> entered;
bool counting = false;
bool overflowed = false;

}  // namespace

extern "C" {
__attribute__((no_instrument_function)) void __cyg_profile_func_enter(void* function, void*) {
  if (!counting) return;
  const std::size_t first = (reinterpret_cast<std::uintptr_t>(function) >> 4) % kMostFunctions;
  for (std::size_t i = 0; i < kMostFunctions; ++i) {
    Entered& one = entered[(first + i) % kMostFunctions];
    if (one.function != nullptr && one.function != function) continue;
    one.function = function;
    ++one.times;
    return;
  }
  overflowed = true;
}
__attribute__((no_instrument_function)) void __cyg_profile_func_exit(void*, void*) {}
}

namespace telepalp {
namespace {

std::string demangled(const char* name) {
  int status = 0;
  const std::unique_ptr<char, decltype(&std::free)> text(abi::__cxa_demangle(name, nullptr, nullptr, &status),
                                                         &std::free);
  return status == 0 ? text.get() : name;
}

/// "Skin" of `telepalp::effects::Skin::step(…)`; empty for a function that is no member of a class in that namespace.
std::string class_in_effects(const std::string& function) {
  static const std::string kNamespace = "telepalp::effects::";
  if (!function.starts_with(kNamespace)) return "";
  const std::size_t end = function.find_first_of(":(<", kNamespace.size());
  return end != std::string::npos && function[end] == ':' ? function.substr(kNamespace.size(), end - kNamespace.size())
                                                          : "";
}

/// Number of entries into functions of each class in telepalp::effects.
std::map<std::string, std::uint64_t> entries_by_class() {
  std::map<std::string, std::uint64_t> counts;
  for (const Entered& one : entered) {
    Dl_info info{};
    if (one.function == nullptr || dladdr(one.function, &info) == 0 || info.dli_sname == nullptr) continue;
    if (const std::string name = class_in_effects(demangled(info.dli_sname)); !name.empty()) counts[name] += one.times;
  }
  return counts;
}

/// The effects' classes, as the bank knows them.
template <class... Effects>
std::set<std::string> classes_of(const std::variant<Effects...>&) {
  return {class_in_effects(demangled(typeid(Effects).name()) + "::")...};
}

/// The classes of the effects in the order of effects::Recipe.
template <class... Effects>
std::vector<std::string> classes_in_order(const std::variant<Effects...>&) {
  return {class_in_effects(demangled(typeid(Effects).name()) + "::")...};
}

/// A shipped scene and the classes of the effects that it names.
struct Named {
  std::string scene;
  std::set<std::string> classes;
};
std::ostream& operator<<(std::ostream& out, const Named& one) { return out << one.scene; }

std::filesystem::path file_of(const std::string& scene) {
  return TELEPALP_SOURCE_DIR "/haptic_station/scenes/" + scene + ".scene.textproto";
}

/// All shipped scenes with a streamed patient, those with the fewest kinds of effects first.
std::vector<Named> shipped_scenes() {
  const std::vector<std::string> classes = classes_in_order(effects::Effect());
  std::vector<Named> all;
  for (const auto& entry : std::filesystem::directory_iterator(file_of("").parent_path())) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".scene.textproto")) continue;
    const Result<scenes::Scene> scene = scenes::read_scene(entry.path());
    if (!scene || scene->model) continue;
    Named one{name.substr(0, name.find('.')), {}};
    for (const effects::Recipe& recipe : scene->effects) one.classes.insert(classes.at(recipe.index()));
    all.push_back(std::move(one));
  }
  std::ranges::sort(all, {}, [](const Named& one) { return std::pair(one.classes.size(), one.scene); });
  return all;
}

/// For each kind of effect, the shipped scene with the fewest other kinds.
std::vector<Named> one_scene_for_each_effect() {
  std::vector<Named> chosen;
  std::set<std::string> seen;
  for (Named& one : shipped_scenes()) {
    if (std::ranges::includes(seen, one.classes)) continue;
    seen.insert(one.classes.begin(), one.classes.end());
    chosen.push_back(std::move(one));
  }
  return chosen;
}

class NamedEffects : public ::testing::TestWithParam<Named> {};

TEST_P(NamedEffects, AreTheOnlyOnesWhoseCodeIsEntered) {
  const auto scene = scenes::read_scene(file_of(GetParam().scene));
  ASSERT_TRUE(scene.ok()) << to_string(scene.error());
  trials::VirtualStationSettings settings;
  settings.effects = core::bank_of(scene->effects);
  settings.control = scene->control;
  trials::VirtualStation station(settings);
  station.place({{0.0, 0.03, 0.0}}, {{0.0, 0.07, 0.0}});
  device::ScriptedIntention person(device::waypoints(device::Trial::FindCylinder), {});
  const device::BreathingPlane skin{.amplitude_m = 0.005};
  entered = {};
  int touching = 0;
  counting = true;
  for (int tick = 0; tick < 20'000; ++tick) {
    const auto out = station.step(skin, [&](const device::TrialView& view) { return person.step(view, 0.0005); });
    if (control::is_inside(out.phase)) ++touching;
  }
  counting = false;
  ASSERT_GT(touching, 1000);
  ASSERT_FALSE(overflowed) << "kMostFunctions is too small";
  const auto counts = entries_by_class();
  for (const std::string& name : classes_of(effects::Effect())) {
    const std::uint64_t times = counts.contains(name) ? counts.at(name) : 0;
    if (GetParam().classes.contains(name))
      EXPECT_GE(times, static_cast<std::uint64_t>(touching)) << name << " is stepped at each tick of a contact";
    else
      EXPECT_EQ(times, 0U) << name << " is not named, and " << times << " of its functions were entered";
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, NamedEffects, ::testing::ValuesIn(one_scene_for_each_effect()), [](const auto& one) {
  std::string name = one.param.scene;
  std::ranges::replace(name, '-', '_');
  return name;
});

TEST(NamedEffects, EveryEffectHasAShippedScene) {
  std::set<std::string> seen;
  for (const Named& one : one_scene_for_each_effect()) seen.insert(one.classes.begin(), one.classes.end());
  EXPECT_EQ(seen, classes_of(effects::Effect()));
}

}  // namespace
}  // namespace telepalp
