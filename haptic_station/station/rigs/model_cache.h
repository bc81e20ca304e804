#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "haptic_station/surface/cloud/static_model.h"

namespace telepalp::station {

/// Folder of the user's cache: $XDG_CACHE_HOME/telepalp/models, else ~/.cache/telepalp/models; empty if neither
/// variable is set.
[[nodiscard]] std::filesystem::path default_model_cache();

/// Surfaces that were sampled from model files, so that the next start with the same file and settings takes less than
/// a second. A file of the cache is named by its key, and holds a checksum. With an empty folder, nothing is kept.
class ModelCache {
 public:
  explicit ModelCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The key of a sampling: a hash over the bytes of `model`, its ending, the settings and this program's build.
  /// nullopt without a folder, or if the file cannot be read.
  [[nodiscard]] std::optional<std::string> key_of(const std::filesystem::path& model,
                                                  const surface::StaticModelSettings& settings) const;
  /// The sampling of this key; nullopt if the cache has none. Error: the cached file is damaged.
  [[nodiscard]] Result<std::optional<surface::StaticModel>> find(const std::string& key) const;
  /// Keeps the sampling, and removes the samplings that were used least recently until 20 are left. Error: the file
  /// cannot be written.
  [[nodiscard]] Result<void> keep(const std::string& key, const surface::StaticModel& model) const;
  [[nodiscard]] std::filesystem::path file_of(const std::string& key) const { return folder_ / (key + ".samples"); }

 private:
  std::filesystem::path folder_;
};

/// make_static_model() of the model in `file`, through `cache`. A damaged cached file is made again. Each step that
/// takes seconds is told to settings.on_progress first.
[[nodiscard]] Result<surface::StaticModel> sampled_once(const std::filesystem::path& file,
                                                        const surface::StaticModelSettings& settings,
                                                        const ModelCache& cache);

}  // namespace telepalp::station
