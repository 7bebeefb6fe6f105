#include "hw/base/work.h"

#include <fmt/format.h>

#include "hw/base/interruption.h"

namespace csgsim {

namespace {

constexpr std::uint64_t million = 1'000'000;

}  // namespace

Work::Work(std::uint64_t limit) : count_(std::make_shared<Count>(Count{0, limit})) {}

void Work::charge(std::uint64_t steps, std::string_view activity) const {
  throw_if_interrupted();
  if (count_ == nullptr) return;
  Count& count = *count_;
  if (steps <= count.limit - count.done) {
    count.done += steps;
    return;
  }
  count.done = count.limit;
  throw WorkError(
      fmt::format("{} needs more work than the limit of {} million steps; use fewer or coarser parts in the model, or "
                  "raise --limit",
                  activity, static_cast<double>(count.limit) / static_cast<double>(million)));
}

Work Work::with_zero_count() const { return count_ == nullptr ? Work() : Work(count_->limit); }

std::uint64_t Work::done() const { return count_ == nullptr ? 0 : count_->done; }

}  // namespace csgsim
