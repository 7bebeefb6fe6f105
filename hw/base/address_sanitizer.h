// Detects builds with AddressSanitizer.
// Used by hw/systemc, sim/pictures and tests.
#pragma once

/// CSGSIM_ADDRESS_SANITIZER: 1 if the build uses the address sanitizer, else 0. GCC and clang report it differently.
#if defined(__SANITIZE_ADDRESS__)
#define CSGSIM_ADDRESS_SANITIZER 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define CSGSIM_ADDRESS_SANITIZER 1
#else
#define CSGSIM_ADDRESS_SANITIZER 0
#endif
#else
#define CSGSIM_ADDRESS_SANITIZER 0
#endif
