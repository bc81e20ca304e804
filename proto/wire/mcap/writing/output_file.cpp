#include "proto/wire/mcap/writing/output_file.h"

#include <utility>

#include "proto/wire/mcap/format/place.h"

namespace telepalp::wire::mcap {

Result<OutputFile> OutputFile::create(const std::filesystem::path& name, Protection protection) {
  std::optional<Sealer> sealer;
  if (protection == Protection::OfSite) {
    Result<std::optional<Sealer>> of_site = sealer_of_site();
    if (!of_site) return of_site.error();
    sealer = *std::move(of_site);
  }
  const Place* const place = place_of(name);
  Result<std::unique_ptr<ByteSink>> sink = place != nullptr ? place->create(name.string()) : new_file(name);
  if (!sink) return sink.error();
  OutputFile file(name, *std::move(sink));
  file.sealer_ = std::move(sealer);
  if (!file.sealer_) return file;
  if (const Result<void> begun = file.sealer_->begin(*file.sink_); !begun) {
    file.discard();
    return begun.error();
  }
  return file;
}

Result<void> OutputFile::append(std::string_view bytes) {
  if (sealer_) return sealer_->append(*sink_, bytes);
  Result<void> written = sink_->write(size_, bytes);
  if (written)
    size_ += bytes.size();
  else
    sink_->cut(size_);
  return written;
}

void OutputFile::discard() noexcept {
  if (sink_) std::exchange(sink_, nullptr)->discard();
}

Result<void> OutputFile::publish() { return std::exchange(sink_, nullptr)->publish(); }

}  // namespace telepalp::wire::mcap
