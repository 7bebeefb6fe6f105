#include "hw/link/link_source.h"

#include <array>
#include <utility>

#include "hw/systemc/kernel.h"

namespace csgsim::link {

LinkSource::LinkSource(sc_core::sc_module_name name, const sc_core::sc_time& period, const machines::Link& link)
    : systemc::ClockedModule(name), period_(period), link_(link) {}

void LinkSource::end_of_elaboration() {
  room_or_request_ |= words.data_read_event();
  room_or_request_ |= requests.data_written_event();
}

/// Clock edges since construction.
std::uint64_t LinkSource::edges() const { return systemc::edges(period_); }

void LinkSource::load(FrameWords frame) {
  frame_ = std::move(frame);
  state_ = State::waiting;
}

void LinkSource::resume(FrameWords frame, std::size_t word_index, std::uint32_t clocks_left) {
  frame_ = std::move(frame);
  next_ = word_index;
  left_ = clocks_left;
  state_ = next_ == frame_.words.size() ? State::done : left_ == 0 ? State::blocked : State::sending;
}

std::string_view LinkSource::state() const {
  constexpr auto names = std::to_array<std::string_view>({"waiting", "latent", "sending", "blocked", "done"});
  return names.at(static_cast<std::size_t>(state_));
}

std::optional<std::size_t> LinkSource::word() const {
  return state_ == State::sending || state_ == State::blocked ? std::optional(next_) : std::nullopt;
}

std::uint64_t& LinkSource::state_clocks(State state, machines::LinkAccount& account) {
  switch (state) {
    case State::waiting:
    case State::latent: return account.waiting;
    case State::sending: return account.sending;
    case State::blocked: return account.blocked;
    case State::done: return account.done;
  }
  return account.done;
}

machines::LinkAccount LinkSource::account() const {
  machines::LinkAccount account = account_;
  state_clocks(state_, account) += edges() - counted_at_;
  return account;
}

/// Sleeps while clocks only have to be counted.
void LinkSource::on_clock() {
  if (!clock.posedge()) return;
  const std::uint64_t now = edges();
  const std::uint64_t clocks = now - std::exchange(counted_at_, now);
  state_clocks(state_, account_) += clocks;
  if (std::uint64_t instruction = 0; requests.nb_read(instruction)) {
    continue_from(instruction);
  } else {
    advance(clocks);
  }
  sleep();
}

/// A request that arrives during sleep is read at the next edge.
void LinkSource::sleep() {
  switch (state_) {
    case State::waiting:
    case State::done: return next_trigger(requests.data_written_event());
    case State::blocked: return next_trigger(room_or_request_);
    case State::latent:
    case State::sending:
      if (left_ < 2) return;
      next_trigger(sc_core::sc_time::from_value(left_ * period_.value()), requests.data_written_event());
  }
}

void LinkSource::continue_from(std::uint64_t instruction_index) {
  if (instruction_index == 0) account_ = {.waiting = 1};
  next_ = frame_.begins.at(instruction_index);
  state_ = State::latent;
  left_ = link_.latency;
  if (left_ == 0) begin_word();
}

void LinkSource::advance(std::uint64_t clocks) {
  switch (state_) {
    case State::waiting:
    case State::done: break;
    case State::latent:
      if ((left_ -= static_cast<std::uint32_t>(clocks)) == 0) begin_word();
      break;
    case State::sending:
      if ((left_ -= static_cast<std::uint32_t>(clocks)) == 0) store_word();
      break;
    case State::blocked: store_word(); break;
  }
}

void LinkSource::begin_word() {
  state_ = State::sending;
  left_ = link_.word_clocks;
}

void LinkSource::store_word() {
  if (!words.nb_write(frame_.words[next_])) {
    state_ = State::blocked;
    return;
  }
  ++account_.words;
  if (++next_ == frame_.words.size()) {
    state_ = State::done;
  } else {
    begin_word();
  }
}

}  // namespace csgsim::link
