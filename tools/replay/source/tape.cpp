#include "tools/replay/source/tape.h"

#include <span>
#include <utility>

#include "server/capture/open_recording.h"
#include "server/capture/synthetic/source/patient_model.h"
#include "server/pipeline/camera_messages.h"

namespace telepalp::replay {
namespace {

using namespace std::chrono_literals;

constexpr std::string_view kSynthetic = "synthetic";

bool is_synthetic(std::string_view spec) {
  return spec == kSynthetic || spec.starts_with(std::string(kSynthetic) + ":");
}

void count(ImageFacts& facts, const RgbdFrame& frame) {
  if (facts.frames++ == 0) facts.camera = frame.camera.depth;
  std::uint64_t steps = 0;
  for (const std::uint16_t sample : frame.depth.samples) {
    steps += sample;
    facts.measured += sample > 0 ? 1U : 0U;
  }
  facts.depth_sum_m += frame.depth.unit_m * static_cast<double>(steps);
  facts.depth.add(std::as_bytes(std::span(frame.depth.samples)));
}

}  // namespace

std::string with_kind(const std::string& source) {
  if (source.find(':') != std::string::npos) return source;
  if (source.ends_with(".mcap")) return "session:" + source;
  if (source.ends_with(".oni")) return "oni:" + source;
  if (source.ends_with(".pcd")) return "pcd:" + source;
  return source;
}

std::string session_file_of(const std::string& source) {
  constexpr std::string_view kSession = "session:";
  const std::string spec = with_kind(source);
  return spec.starts_with(kSession) ? spec.substr(kSession.size()) : "";
}

struct Tape::State {
  explicit State(const TapeSettings& asked) : settings(asked), encoder(asked.depth), watch(asked.clock) {}

  /// The next frame in session time; nullopt: the source has ended.
  std::optional<RgbdFrame> next() {
    return watch.time(Part::Source, [this] { return patient ? next_of_patient() : next_of_recording(); });
  }
  std::optional<RgbdFrame> next_of_patient() {
    return patient->frame_at(kBegin + capture::kSyntheticPeriod * static_cast<std::int64_t>(frames), frames);
  }
  std::optional<RgbdFrame> next_of_recording() {
    std::optional<RgbdFrame> frame = recording->next(0ms);
    if (!frame) return std::nullopt;
    if (!shift) shift = kBegin - frame->captured;
    frame->captured += *shift;
    return frame;
  }
  Result<std::shared_ptr<const TapeFrame>> taped(RgbdFrame frame);
  Result<void> encode(const RgbdFrame& frame, TapeFrame& taped);
  void keep(const RgbdFrame& frame, codec::EncodedDepth encoded, TapeFrame& taped) const;
  void take_color(const RgbdFrame& frame, TapeFrame& taped);
  [[nodiscard]] const capture::CompressedFrame* recorded() const {
    return recording ? recording->compressed() : nullptr;
  }

  TapeSettings settings;
  std::shared_ptr<const capture::SyntheticPatient> patient;  // shared with truth_at
  std::unique_ptr<capture::CaptureSource> recording;
  TruthAt truth_at;
  std::optional<Nanoseconds> shift;  // from the recording's time to the replay's
  codec::DepthEncoder encoder;
  codec::DepthReader decoder;
  Stopwatch watch;
  std::optional<RgbdFrame> ahead;  // read, but of a later window
  std::uint32_t frames = 0;
  ImageFacts images;
  bool ended = false;
};

/// Encodes the depth and checks that it decodes to itself, so that a run may use the source's depth in place of its own
/// decoding of equal bytes.
Result<void> Tape::State::encode(const RgbdFrame& frame, TapeFrame& taped) {
  codec::EncodedDepth encoded = watch.time(Part::Encode, [&] { return encoder.encode(frame.depth); });
  const Result<codec::DecodedDepth> decoded =
      watch.time(Part::Decode, [&] { return decoder.read(std::as_bytes(std::span(encoded.bytes))); });
  if (!decoded) return decoded.error();
  if (decoded->image.samples != frame.depth.samples)
    return Error{.what = "the depth differs after encoding and decoding, although the depth mode is lossless",
                 .where = "frame " + std::to_string(taped.number),
                 .fix = "report this: it is a defect of telepalp"};
  keep(frame, std::move(encoded), taped);
  return {};
}

/// Keeps the depth as a message with time stamps in the replay's session time.
void Tape::State::keep(const RgbdFrame& frame, codec::EncodedDepth encoded, TapeFrame& taped) const {
  msg::DepthImage message = pipeline::depth_message(frame, std::move(encoded));
  message.set_encoded_ns(static_cast<std::uint64_t>(to_nanoseconds(frame.captured + settings.encode_time)));
  taped.depth = message.SerializeAsString();
}

/// A session's colour crosses the network as it was recorded.
void Tape::State::take_color(const RgbdFrame& frame, TapeFrame& taped) {
  if (!settings.color) return;
  if (const capture::CompressedFrame* as_recorded = recorded(); as_recorded != nullptr && !as_recorded->color.empty())
    taped.color = pipeline::color_message(frame, as_recorded->color_format, as_recorded->color).SerializeAsString();
  else if (!frame.color.rgb.empty())
    taped.color = watch.time(Part::Encode,
                             [&] { return pipeline::color_message(frame, settings.jpeg_quality).SerializeAsString(); });
}

Result<std::shared_ptr<const TapeFrame>> Tape::State::taped(RgbdFrame frame) {
  auto taped = std::make_shared<TapeFrame>();
  taped->number = frames++;
  frame.sequence = taped->number;
  const bool predicted =
      settings.depth.mode == codec::DepthMode::Temporal || settings.depth.mode == codec::DepthMode::Bounded;
  const capture::CompressedFrame* as_recorded = recorded();
  if (!predicted && as_recorded != nullptr && as_recorded->depth_format == codec::name(settings.depth.mode)) {
    codec::EncodedDepth encoded;
    encoded.bytes = as_recorded->depth;
    encoded.mode = settings.depth.mode;
    keep(frame, std::move(encoded), *taped);
  } else if (!predicted) {
    if (const Result<void> encoded = encode(frame, *taped); !encoded) return encoded.error();
  }
  take_color(frame, *taped);
  frame.color = {};
  taped->frame = std::move(frame);
  return std::shared_ptr<const TapeFrame>(std::move(taped));
}

Tape::Tape(std::unique_ptr<State> state) : state_(std::move(state)) {}
Tape::~Tape() = default;
Tape::Tape(Tape&&) noexcept = default;
Tape& Tape::operator=(Tape&&) noexcept = default;

Result<Tape> Tape::open(const std::string& source, const TapeSettings& settings) {
  auto state = std::make_unique<State>(settings);
  const std::string spec = with_kind(source);
  if (is_synthetic(spec)) {
    Result<capture::NamedPatient> named =
        capture::open_patient(spec == kSynthetic ? "" : spec.substr(kSynthetic.size() + 1));
    if (!named) return named.error();
    const auto patient = std::make_shared<const capture::SyntheticPatient>(std::move(named->patient));
    state->patient = patient;
    state->truth_at = [patient](SessionTime at) { return patient->true_surface(at); };
  } else {
    Result<std::unique_ptr<capture::CaptureSource>> recording =
        capture::open_recording(spec, {.clock = wire::SessionClock(Nanoseconds{0}),
                                       .loop = settings.repeat,
                                       .paced = false,
                                       .keep_compressed = true});
    if (!recording) return recording.error();
    state->recording = std::move(*recording);
  }
  return Tape(std::move(state));
}

Result<TapeFrames> Tape::read_until(SessionTime until) {
  TapeFrames frames;
  State& state = *state_;
  while (!state.ended) {
    if (!state.ahead) state.ahead = state.next();
    if (!state.ahead) state.ended = true;
    if (!state.ahead || state.ahead->captured >= until) break;
    if (!is_well_formed(*state.ahead)) {
      state.ahead.reset();
      continue;
    }
    count(state.images, *state.ahead);
    Result<std::shared_ptr<const TapeFrame>> taped = state.taped(std::move(*std::exchange(state.ahead, std::nullopt)));
    if (!taped) return taped.error();
    frames.push_back(std::move(*taped));
  }
  if (state.recording) state.images.damage = state.recording->complaint();
  return frames;
}

bool Tape::ended() const noexcept { return state_->ended; }
const TruthAt& Tape::truth() const noexcept { return state_->truth_at; }
bool Tape::is_encoded() const noexcept {
  return state_->settings.depth.mode == codec::DepthMode::Fast ||
         state_->settings.depth.mode == codec::DepthMode::Intra;
}
const TapeSettings& Tape::settings() const noexcept { return state_->settings; }
const Stopwatch& Tape::costs() const noexcept { return state_->watch; }
const ImageFacts& Tape::images() const noexcept { return state_->images; }

}  // namespace telepalp::replay
