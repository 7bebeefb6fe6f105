#pragma once

/// Whether the address sanitizer watches, 1 or 0: clang and GCC tell it in different ways.
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
