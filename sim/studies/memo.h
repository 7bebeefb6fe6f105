#pragma once

#include <map>
#include <mutex>
#include <utility>

namespace csgsim::studies {

/// Values that are computed once for each key, by the thread that asks first; the others wait for it. They stay where
/// they are.
template <class Key, class Value>
class Memo {
 public:
  /// An exception of `compute` is passed on, and the next call tries again.
  template <class Compute>
  const Value& get(Key key, const Compute& compute) {
    Entry* entry = nullptr;
    {
      const std::lock_guard guard(lock_);
      entry = &entries_[std::move(key)];
    }
    std::call_once(entry->once, [&] { entry->value = compute(); });
    return entry->value;
  }

 private:
  struct Entry {
    std::once_flag once;
    Value value{};
  };

  std::mutex lock_;  ///< of the map, not of its entries
  std::map<Key, Entry> entries_;
};

}  // namespace csgsim::studies
