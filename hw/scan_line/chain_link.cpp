#include "hw/scan_line/chain_link.h"

namespace csgsim::scan_line {

ChainLink::ChainLink(sc_core::sc_module_name name, const machines::Link& link)
    : systemc::ClockedModule(name), link_(link) {}

void ChainLink::begin(const PictureLines& frame, std::size_t lines_to_send) {
  frame_ = frame;
  lines_left_ = lines_to_send;
  state_ = State::waiting;
  latency_ = link_.latency;
  sent_ = 0;
  counter_.begin();
}

void ChainLink::on_clock() {
  advance();
  if (state_ == State::waiting) take_line();
  counter_.edge(current_activity());
}

void ChainLink::advance() {
  switch (state_) {
    case State::waiting: break;
    case State::latent:
      if (--left_ > 0) break;
      state_ = State::sending;
      left_ = link_.word_clocks;
      break;
    case State::sending:
      if (--left_ == 0) store_word();
      break;
    case State::blocked: store_word(); break;
  }
}

void ChainLink::store_word() {
  if (!words.nb_write(command_words_[word_])) {
    state_ = State::blocked;
    return;
  }
  ++sent_;
  state_ = State::sending;
  left_ = link_.word_clocks;
  if (++word_ < command_words_.size()) return;
  if (command_ < frame_.lines[line_].instructions.size() + 2) return take_command();
  state_ = State::waiting;
}

void ChainLink::take_line() {
  if (lines_left_ == 0 || !lines.nb_read(line_)) return;
  --lines_left_;
  command_ = 0;
  take_command();
  state_ = latency_ > 0 ? State::latent : State::sending;
  left_ = latency_ > 0 ? latency_ : link_.word_clocks;
  latency_ = 0;
}

void ChainLink::take_command() {
  const isa::Segment& line = frame_.lines[line_];
  command_words_.clear();
  word_ = 0;
  const auto send = [&](const isa::Command& command) {
    isa::encode(command, link_.width, [&](const isa::LinkWord& word) { command_words_.push_back(word); });
  };
  if (command_ == 0) {
    send(isa::SegmentStart{line.region});
  } else if (command_ <= line.instructions.size()) {
    send(line.instructions[command_ - 1]);
  } else {
    send(isa::SegmentEnd{});
  }
  ++command_;
}

LineActivity ChainLink::current_activity() const {
  switch (state_) {
    case State::waiting: return lines_left_ == 0 ? LineActivity::done : LineActivity::waiting_for_host;
    case State::latent: return LineActivity::latency;
    case State::sending: return LineActivity::sending;
    case State::blocked: return LineActivity::waiting_for_entry;
  }
  return LineActivity::done;
}

}  // namespace csgsim::scan_line
