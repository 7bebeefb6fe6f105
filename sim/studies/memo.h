// Thread-safe memoization.
// Used to share results between the threads of a study.
#pragma once

#include <map>
#include <mutex>
#include <utility>

namespace csgsim::studies {

/// Values computed once per key, by the first thread that requests them; other threads wait. References stay valid.
template <class Key, class Value>
class Memo {
 public:
  /// If `compute` throws, the exception is passed on and the next call tries again.
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

  std::mutex lock_;  ///< guards the map, not its entries
  std::map<Key, Entry> entries_;
};

}  // namespace csgsim::studies
