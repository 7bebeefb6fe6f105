// Requests and releases pages of memory in bulk.
// Used by sim/observe and host/emit.
#pragma once

#include <cstddef>
#include <vector>

namespace csgsim {

/// Requests all pages of memory that is about to be written from the system at once, as huge pages if available:
/// faulting them in one by one is several times slower. Pages that are not granted are mapped on first access.
void prefault_pages(void* memory, std::size_t byte_count);

/// Returns freed memory to the system, even between blocks in use. Called after work that leaves few allocations.
void release_free_memory();

/// A vector of `count` copies of `value`, whose pages are requested in advance.
template <class Element>
std::vector<Element> filled(std::size_t count, const Element& value) {
  std::vector<Element> elements;
  elements.reserve(count);
  prefault_pages(elements.data(), count * sizeof(Element));
  elements.assign(count, value);
  return elements;
}

}  // namespace csgsim
