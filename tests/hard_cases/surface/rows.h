#pragma once

#include <vector>

#include "tests/hard_cases/hard_case.h"

namespace telepalp::hard_cases {

/// Points that span no plane, disagree, or lie far away.
[[nodiscard]] std::vector<HardCase> point_rows();
/// Missing parts of a depth image: holes, silhouettes, rims.
[[nodiscard]] std::vector<HardCase> image_rows();
/// Sensors that round: disparity steps, whole millimetres.
[[nodiscard]] std::vector<HardCase> sensor_rows();
/// Shapes and approaches without a unique answer.
[[nodiscard]] std::vector<HardCase> shape_rows();
/// Skin that is steep against the camera's rays.
[[nodiscard]] std::vector<HardCase> slope_rows();
/// Meshes and clouds as people have them: parts inside parts, noise, normals that disagree.
[[nodiscard]] std::vector<HardCase> model_rows();
/// Contact after gaps, shifts, black frames and foreign hands.
[[nodiscard]] std::vector<HardCase> return_rows();
/// Objects over the patient's skin: another person's hand, a towel; and skin that looks like one.
[[nodiscard]] std::vector<HardCase> object_rows();
/// The displayed surface's approach to the newest one.
[[nodiscard]] std::vector<HardCase> follow_rows();
/// Patients whose motion the surface's prediction does not model.
[[nodiscard]] std::vector<HardCase> prediction_rows();
/// Frames that are late, early, old, or do not come.
[[nodiscard]] std::vector<HardCase> time_rows();

}  // namespace telepalp::hard_cases
