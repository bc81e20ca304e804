#pragma once

/// Put before a function to compile it twice, for the x86-64 baseline and for x86-64-v3 (AVX2); the dynamic loader
/// selects the version for the processor. With the thread sanitizer the function is compiled once: the sanitizer's
/// runtime is not initialised yet when the loader runs the selection.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
#define TELEPALP_VECTORISED __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define TELEPALP_VECTORISED
#endif

/// Put before a loop whose iterations are independent, so that GCC omits the run-time check for overlapping arrays.
/// clang keeps the check.
#if defined(__clang__)
#define TELEPALP_INDEPENDENT_TURNS
#else
#define TELEPALP_INDEPENDENT_TURNS _Pragma("GCC ivdep")
#endif
