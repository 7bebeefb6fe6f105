#pragma once

#include <memory>

namespace csgsim {

/// A value of type T on the heap, copied and compared as a T is. A header can have one as a member with T declared
/// only, so that files which do not use the member need not include T's header. A value that was never written is T{}
/// and takes no memory; so is one that was moved from. The file that defines T instantiates the members, which
/// hw/base/indirect-inl.h has: `template class Indirect<T>`.
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
