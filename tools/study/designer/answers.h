#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "proto/words/result.h"
#include "tools/study/designer/live/live_tool.h"
#include "tools/study/designer/live/reach.h"
#include "tools/study/search/design_search.h"

namespace telepalp::study {

// The program's messages to the designer's page: JSON objects whose `kind` says what they are. Lengths are in mm,
// angles in rad, forces in N; places are in the plane z = 0 of the tissue's frame, the skin at y = 0.

/// `kind`: design. The survey of a linkage, its first frame and the trace of its insertion.
[[nodiscard]] std::string design_json(const LiveFrame& frame, const mechanism::FourBar& bar, const Reach& reach,
                                      const std::vector<TracePoint>& trace);
/// `kind`: frame. Pose, forces, layers and punctures now; `trace`: since the last frame.
[[nodiscard]] std::string frame_json(const LiveFrame& frame, const std::vector<TracePoint>& trace);
/// `kind`: refused. `of`: the message that was refused: design, prediction, search or message.
[[nodiscard]] std::string refused_json(std::string_view of, const Error& error);
/// `kind`: device. What a page must know of a haptic device: whether it moves this page's linkage, and what is wrong.
[[nodiscard]] std::string device_json(bool ours, std::string_view trouble);
/// `kind`: predicting. `done` of `all` operators.
[[nodiscard]] std::string predicting_json(int done, int all);
/// `kind`: prediction.
[[nodiscard]] std::string prediction_json(const Judgement& judgement);
/// `kind`: searching. The front so far.
[[nodiscard]] std::string searching_json(const SearchState& state);
/// `kind`: found. The front, S4's own mechanisms, and whether the search was stopped.
[[nodiscard]] std::string found_json(const SearchResult& result);

}  // namespace telepalp::study
