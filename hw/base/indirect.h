// A value on the heap with value semantics.
// Used by hw/isa/program.h.
#pragma once

#include <memory>

namespace csgsim {

/// A value of type T on the heap, copied and compared like a T. A header can have such a member while T is only
/// declared, so that files which do not use the member need not include T's header. A value that was never written, or
/// was moved from, equals T{} and takes no memory. The file that defines T includes hw/base/indirect-inl.h and
/// instantiates the members: `template class Indirect<T>`.
template <class T>
class Indirect {
 public:
  Indirect() noexcept;
  Indirect(const Indirect& other);
  Indirect(Indirect&& other) noexcept;
  Indirect& operator=(const Indirect& other);
  Indirect& operator=(Indirect&& other) noexcept;
  ~Indirect();

  const T& operator*() const;
  T& operator*();
  const T* operator->() const { return &**this; }
  T* operator->() { return &**this; }

  bool operator==(const Indirect& other) const;

 private:
  std::unique_ptr<T> value_;
};

}  // namespace csgsim
