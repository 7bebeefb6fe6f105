// Member definitions of Indirect.
// Used by hw/isa/program.cpp, which instantiates them.
#pragma once

#include <memory>

#include "hw/base/indirect.h"

namespace csgsim {

template <class T>
Indirect<T>::Indirect() noexcept = default;

template <class T>
Indirect<T>::Indirect(const Indirect& other) : value_(other.value_ ? std::make_unique<T>(*other.value_) : nullptr) {}

template <class T>
Indirect<T>::Indirect(Indirect&& other) noexcept = default;

template <class T>
Indirect<T>& Indirect<T>::operator=(const Indirect& other) {
  value_ = other.value_ ? std::make_unique<T>(*other.value_) : nullptr;
  return *this;
}

template <class T>
Indirect<T>& Indirect<T>::operator=(Indirect&& other) noexcept = default;

template <class T>
Indirect<T>::~Indirect() = default;

template <class T>
const T& Indirect<T>::operator*() const {
  static const T unwritten{};
  return value_ ? *value_ : unwritten;
}

template <class T>
T& Indirect<T>::operator*() {
  if (!value_) value_ = std::make_unique<T>();
  return *value_;
}

template <class T>
bool Indirect<T>::operator==(const Indirect& other) const {
  return (!value_ && !other.value_) || **this == *other;
}

}  // namespace csgsim
