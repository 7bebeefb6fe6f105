#include "hw/base/pages.h"

#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace csgsim {

#if defined(__linux__) && defined(MADV_POPULATE_WRITE)

namespace {

constexpr std::uintptr_t page = 4096;
/// For fewer pages, page faults cost less than a system call.
constexpr std::uintptr_t few_pages = 16;
constexpr std::uintptr_t large_page = std::uintptr_t{1} << 21U;

}  // namespace

void prefault_pages(void* memory, std::size_t byte_count) {
  const auto address = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (address + page - 1) / page * page;
  const std::uintptr_t end = (address + byte_count) / page * page;
  if (end < first + few_pages * page) return;
  auto* const pages = reinterpret_cast<void*>(first);  // NOLINT(performance-no-int-to-ptr)
  // Both calls are hints: if the system ignores them, it maps the pages later.
  if (end - first >= 2 * large_page) ::madvise(pages, end - first, MADV_HUGEPAGE);
  ::madvise(pages, end - first, MADV_POPULATE_WRITE);
}

#else

void prefault_pages(void* /*memory*/, std::size_t /*byte_count*/) {}

#endif

void release_free_memory() {
#ifdef __GLIBC__
  ::malloc_trim(0);
#endif
}

}  // namespace csgsim
