#pragma once

#include <functional>
#include <optional>

#include "proto/wire/mcap/reader.h"
#include "support/speech/speech_survey.h"

namespace telepalp::speech {

/// The name of the metadata record in which a recorder states where people speak, so that nobody need decode an hour of
/// speech, or read it. One value for each spoken topic, in words separated by spaces: the number of messages, a session
/// time [ns], and for each span its beginning and end since then [ms] and its loudest level [dB].
inline constexpr std::string_view kSpeechMetadata = "telepalp.speech";

/// The record about `speech`; nullopt: nobody's microphone was open.
[[nodiscard]] std::optional<wire::mcap::Metadata> speech_record(const Speech& speech);

/// Where people speak, from the file's records alone. nullopt: the file has speech, and no records tell of all of it:
/// it was recorded by an earlier release, repaired, cut or merged, or a record is damaged.
[[nodiscard]] std::optional<Speech> recorded_speech(wire::McapReader& reader);

/// Finds where people speak by decoding all speech in the file; a damaged part of the file is left out. `goes_on` is
/// asked before each message; false ends the reading early. Changes the reader's selection.
[[nodiscard]] Speech surveyed_speech(
    wire::McapReader& reader, const std::function<bool()>& goes_on = [] { return true; });

}  // namespace telepalp::speech
