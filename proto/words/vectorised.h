#pragma once

/// Before a function: it is compiled twice, for any x86-64 and for one with AVX2 (x86-64-v3), and the loader picks by
/// the processor it meets. Once only under the thread sanitizer, whose runtime is not awake yet when the loader asks.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
#define TELEPALP_VECTORISED __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define TELEPALP_VECTORISED
#endif
