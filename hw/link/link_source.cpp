#include "hw/link/link_source.h"

#include <array>
#include <utility>

namespace csgsim::link {

LinkSource::LinkSource(sc_core::sc_module_name name, const machines::Link& link)
    : systemc::ClockedModule(name), link_(link) {}

void LinkSource::load(FrameWords frame) {
  frame_ = std::move(frame);
  state_ = State::waiting;
}

void LinkSource::resume(FrameWords frame, std::size_t word, std::uint32_t clocks_left) {
  frame_ = std::move(frame);
  next_ = word;
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

void LinkSource::on_clock() {
  count();
  if (std::uint64_t instruction = 0; requests.nb_read(instruction)) return go_on_from(instruction);
  go_on();
}

/// The clock that ends.
void LinkSource::count() {
  switch (state_) {
    case State::waiting:
    case State::latent: ++account_.waiting; break;
    case State::sending: ++account_.sending; break;
    case State::blocked: ++account_.blocked; break;
    case State::done: ++account_.done; break;
  }
}

void LinkSource::go_on_from(std::uint64_t instruction) {
  if (instruction == 0) account_ = {.waiting = 1};
  next_ = frame_.begins.at(instruction);
  state_ = State::latent;
  left_ = link_.latency;
  if (left_ == 0) begin_word();
}

void LinkSource::go_on() {
  switch (state_) {
    case State::waiting:
    case State::done: break;
    case State::latent:
      if (--left_ == 0) begin_word();
      break;
    case State::sending:
      if (--left_ == 0) store_word();
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
