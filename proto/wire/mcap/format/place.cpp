#include "proto/wire/mcap/format/place.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace telepalp::wire::mcap {
namespace {

std::vector<Place>& places() {
  static std::vector<Place> all;
  return all;
}

}  // namespace

void add_place(Place place) {
  std::erase_if(places(), [&](const Place& other) { return other.beginning == place.beginning; });
  places().push_back(std::move(place));
}

const Place* place_of(const std::filesystem::path& name) {
  const auto found =
      std::ranges::find_if(places(), [&](const Place& place) { return name.string().starts_with(place.beginning); });
  return found == places().end() ? nullptr : &*found;
}

}  // namespace telepalp::wire::mcap
