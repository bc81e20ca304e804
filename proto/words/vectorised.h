#pragma once

/// Before a function: it is compiled twice, for any x86-64 and for one with AVX2 (x86-64-v3), and the loader picks by
/// the processor it meets. Once only under the thread sanitizer, whose runtime is not awake yet when the loader asks.
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
#define TELEPALP_VECTORISED __attribute__((target_clones("default", "arch=x86-64-v3")))
#else
#define TELEPALP_VECTORISED
#endif

/// Before a loop: no turn of it reads what another writes, so the compiler need not ask at run time. clang asks anyway.
#if defined(__clang__)
#define TELEPALP_INDEPENDENT_TURNS
#else
#define TELEPALP_INDEPENDENT_TURNS _Pragma("GCC ivdep")
#endif
