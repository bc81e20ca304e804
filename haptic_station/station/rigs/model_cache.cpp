#include "haptic_station/station/rigs/model_cache.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "proto/keys/audit_chain.h"
#include "support/program/files/whole_file.h"
#include "support/program/version.h"

namespace telepalp::station {
namespace {

namespace fs = std::filesystem;
using surface::CloudPoint;
using surface::StaticModel;

constexpr std::string_view kMagic = "telepalp model samples 2\n";
constexpr std::size_t kHashBytes = 64;  // of its hexadecimal text
constexpr std::size_t kMostKept = 20;
static_assert(std::is_trivially_copyable_v<Eigen::Vector3f::Scalar> && sizeof(CloudPoint) == 7 * sizeof(float));

std::optional<std::string> content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(in), {}};
  return in ? std::optional{std::move(bytes)} : std::nullopt;
}

template <class Value>
void put(std::string& bytes, const Value& value) {
  static_assert(std::is_arithmetic_v<Value>);
  const auto raw = std::bit_cast<std::array<char, sizeof(Value)>>(value);
  bytes.append(raw.begin(), raw.end());
}

void put(std::string& bytes, const std::string& text) {
  put(bytes, static_cast<std::uint64_t>(text.size()));
  bytes += text;
}

/// Takes values from the front of `rest`; once a value is not there, ok() is false and the values are zero.
class Take {
 public:
  explicit Take(std::string_view rest) : rest_(rest) {}

  std::string_view bytes(std::uint64_t count) {
    ok_ = ok_ && count <= rest_.size();
    const std::string_view taken = ok_ ? rest_.substr(0, count) : std::string_view{};
    rest_.remove_prefix(taken.size());
    return taken;
  }
  template <class Value>
  Value number() {
    Value value{};
    if (const std::string_view raw = bytes(sizeof value); ok_) std::memcpy(&value, raw.data(), sizeof value);
    return value;
  }
  std::string text() { return std::string(bytes(number<std::uint64_t>())); }
  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] bool at_end() const noexcept { return rest_.empty(); }

 private:
  std::string_view rest_;
  bool ok_ = true;
};

std::string body_of(const StaticModel& model) {
  const surface::CloudShape& shape = model.snapshot->shape();
  std::string body;
  for (const double value :
       {shape.origin_m.x(), shape.origin_m.y(), shape.origin_m.z(), shape.support_m, shape.seed_radius_m})
    put(body, value);
  put(body, static_cast<std::uint64_t>(shape.neighbors));
  put(body, model.remarks);
  put(body, model.sampling);
  put(body, model.thin_share);
  put(body, static_cast<std::uint64_t>(model.snapshot->cloud().size()));
  put(body, static_cast<std::uint8_t>(shape.graded ? 1 : 0));
  for (const CloudPoint& point : model.snapshot->cloud()) {
    for (const Eigen::Vector3f& vector : {point.at_m, point.normal})
      for (const float value : vector) put(body, value);
    put(body, point.support_m);
  }
  return body;
}

std::optional<StaticModel> model_in(std::string_view body) {
  Take take(body);
  surface::CloudShape shape;
  for (double& value : shape.origin_m) value = take.number<double>();
  shape.support_m = take.number<double>();
  shape.seed_radius_m = take.number<double>();
  shape.neighbors = take.number<std::uint64_t>();
  StaticModel model;
  model.remarks = take.text();
  model.sampling = take.text();
  model.thin_share = take.number<double>();
  const auto count = take.number<std::uint64_t>();
  shape.graded = take.number<std::uint8_t>() != 0;
  if (!take.ok() || count == 0 || count > body.size() / sizeof(CloudPoint)) return std::nullopt;
  std::vector<CloudPoint> points(count);
  for (CloudPoint& point : points) {
    for (Eigen::Vector3f* vector : {&point.at_m, &point.normal})
      for (float& value : *vector) value = take.number<float>();
    point.support_m = take.number<float>();
  }
  if (!take.ok() || !take.at_end()) return std::nullopt;
  model.snapshot = std::make_shared<const surface::CloudSnapshot>(std::move(points), shape, surface::Index::Nanoflann);
  return model;
}

/// Removes the files that were used least recently until kMostKept are left. Errors are left to the next start.
void prune(const fs::path& folder) {
  std::error_code ignored;
  std::vector<std::pair<fs::file_time_type, fs::path>> kept;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".samples") kept.emplace_back(entry.last_write_time(ignored), entry.path());
  if (kept.size() <= kMostKept) return;
  std::sort(kept.begin(), kept.end());
  for (std::size_t i = 0; i + kMostKept < kept.size(); ++i) fs::remove(kept[i].second, ignored);
}

}  // namespace

fs::path default_model_cache() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache == '/')
    return fs::path(cache) / "telepalp/models";
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/')
    return fs::path(home) / ".cache/telepalp/models";
  return {};
}

std::optional<std::string> ModelCache::key_of(const fs::path& model,
                                              const surface::StaticModelSettings& settings) const {
  if (folder_.empty()) return std::nullopt;
  const std::optional<std::string> bytes = content_of(model);
  if (!bytes) return std::nullopt;
  std::error_code ignored;
  const auto built = fs::last_write_time("/proc/self/exe", ignored).time_since_epoch().count();
  std::string text = std::string(program::version()) + " " + program::commit() + " " + std::to_string(built) + " " +
                     model.extension().string() + " " + keys::sha256_hex(*bytes);
  const Eigen::Vector3d& from = settings.viewpoint_m;
  for (const double value : {settings.unit_m, settings.spacing_m, settings.support_m, from.x(), from.y(), from.z()})
    put(text, value);
  put(text, static_cast<std::uint64_t>(settings.samples));
  put(text, settings.seed);
  put(text, settings.normal_neighbors);
  put(text, settings.anyway);
  put(text, settings.flip_normals);
  return keys::sha256_hex(text);
}

Result<std::optional<StaticModel>> ModelCache::find(const std::string& key) const {
  const fs::path file = file_of(key);
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return std::optional<StaticModel>{};
  const std::string bytes = content_of(file).value_or("");
  const std::string_view rest = std::string_view(bytes).substr(std::min(kMagic.size(), bytes.size()));
  const std::string_view body = rest.substr(std::min(kHashBytes, rest.size()));
  std::optional<StaticModel> model;
  if (bytes.starts_with(kMagic) && keys::sha256_hex(body) == rest.substr(0, kHashBytes)) model = model_in(body);
  if (!model) return Error{.what = "the cached sampling is damaged", .where = file.string(), .fix = "it is made again"};
  fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);  // prune() keeps what was used last
  return model;
}

Result<void> ModelCache::keep(const std::string& key, const StaticModel& model) const {
  const std::string body = body_of(model);
  if (const Result<void> made = program::make_folder(folder_, program::Readers::Group); !made) return made;
  const Result<void> written = program::write_whole_file(
      file_of(key), std::string(kMagic) + keys::sha256_hex(body) + body, program::Readers::Group);
  if (written) prune(folder_);
  return written;
}

Result<StaticModel> sampled_once(const fs::path& file, const surface::StaticModelSettings& settings,
                                 const ModelCache& cache) {
  const auto say = [&](const std::string& text) {
    if (settings.on_progress) settings.on_progress(text);
  };
  const std::optional<std::string> key = cache.key_of(file, settings);
  if (key) {
    Result<std::optional<StaticModel>> found = cache.find(*key);
    if (!found) say(to_string(found.error()));
    if (found && *found) {
      say("the sampling of " + file.string() + " is read from the cache (" + cache.file_of(*key).string() + ")");
      return std::move(**found);
    }
  }
  say("reading " + file.string() + "; its surface is sampled now, which can take half a minute");
  const Result<models::PointModel> read = models::read_point_model(file);
  if (!read) return read.error();
  Result<StaticModel> made = surface::make_static_model(*read, settings);
  if (!made || !key) return made;
  const Result<void> kept = cache.keep(*key, *made);
  say(kept ? "the sampling is kept for the next start in " + cache.file_of(*key).string()
           : "the next start samples the model again, because its sampling cannot be kept: " + to_string(kept.error()));
  return made;
}

}  // namespace telepalp::station
