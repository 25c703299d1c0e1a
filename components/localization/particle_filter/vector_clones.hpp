// Loops over particles, compiled for several widths of vector registers; the one that the CPU has is taken
// when the program starts. Results may differ between CPU types in the last bits (fused multiply-add).
#pragma once

// Sanitizers begin after that choice.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__) && !defined(__SANITIZE_UNDEFINED__)
#define BW_VECTOR_CLONES __attribute__((target_clones("avx512f", "avx2", "default")))
#else
#define BW_VECTOR_CLONES
#endif
