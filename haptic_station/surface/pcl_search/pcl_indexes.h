#pragma once

namespace telepalp::surface {

/// From now on, a setting that names an index of PCL uses it. Without this call it uses nanoflann's, which finds the
/// same neighbours, so that only a program that calls this needs PCL. Call it in main(), before any other thread
/// begins.
void use_pcl_indexes() noexcept;

/// From now on, nanoflann's index is used again. The two indexes list the same neighbours in another order, so that
/// sums over them differ in their last bits. Call it in main(), before any other thread begins.
void use_nanoflann_indexes() noexcept;

}  // namespace telepalp::surface
