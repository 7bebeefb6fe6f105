// Runtime functions that Debian's libraries for WASI require or lack.
#include <cstdint>
#include <cstdlib>
#include <new>

// The libraries use stack protectors, which the C library does not provide.
extern "C" {
std::uintptr_t __stack_chk_guard = 0x595e9fbd;
[[noreturn]] void __stack_chk_fail() { std::abort(); }
}

// The page has one thread, which never ends, so its thread-local objects are not destroyed.
extern "C" int __cxa_thread_atexit(void (* /*destroy*/)(void*), void* /*object*/, void* /*library*/) { return 0; }

namespace {

void* allocated(std::size_t bytes) {
  if (void* const place = std::malloc(bytes == 0 ? 1 : bytes)) return place;
  throw std::bad_alloc();
}

void* allocated(std::size_t bytes, std::align_val_t alignment) {
  const auto step = static_cast<std::size_t>(alignment);
  if (void* const place = std::aligned_alloc(step, (bytes + step - 1) / step * step)) return place;
  throw std::bad_alloc();
}

}  // namespace

// The libraries are compiled without exceptions; their operators would abort when memory runs out.
void* operator new(std::size_t bytes) { return allocated(bytes); }
void* operator new[](std::size_t bytes) { return allocated(bytes); }
void* operator new(std::size_t bytes, std::align_val_t alignment) { return allocated(bytes, alignment); }
void* operator new[](std::size_t bytes, std::align_val_t alignment) { return allocated(bytes, alignment); }
void* operator new(std::size_t bytes, const std::nothrow_t& /*tag*/) noexcept { return std::malloc(bytes); }
void operator delete(void* place) noexcept { std::free(place); }
void operator delete[](void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t /*bytes*/) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t /*bytes*/) noexcept { std::free(place); }
void operator delete(void* place, std::align_val_t /*alignment*/) noexcept { std::free(place); }
void operator delete[](void* place, std::align_val_t /*alignment*/) noexcept { std::free(place); }
void operator delete(void* place, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept { std::free(place); }
void operator delete[](void* place, std::size_t /*bytes*/, std::align_val_t /*alignment*/) noexcept {
  std::free(place);
}
