#pragma once

#include <cstddef>
#include <vector>

namespace csgsim {

/// Asks the system at once for all pages of memory that is about to be written, in large ones if it has them: page by
/// page, as they are touched, takes some times as long. What cannot be had so comes as it is touched.
void have_pages(void* memory, std::size_t bytes);

/// Gives memory that was freed back to the system, even where it lies between what is in use. For the end of work of
/// which little stays.
void give_back_memory();

/// So many elements of that value.
template <class Element>
std::vector<Element> filled(std::size_t count, const Element& value) {
  std::vector<Element> elements;
  elements.reserve(count);
  have_pages(elements.data(), count * sizeof(Element));
  elements.assign(count, value);
  return elements;
}

}  // namespace csgsim
