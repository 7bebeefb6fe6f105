#include "sim/debug/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>

#include "hw/base/error.h"
#include "hw/base/output_file.h"
#include "hw/base/text.h"
#include "hw/isa/facts.h"
#include "hw/isa/operands.h"
#include "hw/isa/quoting.h"
#include "sim/checkpoint/file.h"
#include "sim/debug/condition.h"
#include "sim/debug/field_picture.h"
#include "sim/debug/show.h"

namespace csgsim::debug {

Session::Session(const isa::Program& program, const machines::Machine& machine, unsigned threads)
    : program_(program),
      machine_(machine),
      numbers_(program),
      identity_(checkpoint::identity_of(program, machine)),
      engine_(engine::make_functional_engine(machine, threads)),
      run_(engine_->begin(program)),
      frame_(program),
      stats_(program),
      clocks_(program, machine) {
  save_state();
}

std::string Session::execute(const Command& command) {
  return std::visit([this](const auto& one) { return perform(one); }, command);
}

std::vector<std::string> Session::words() const {
  std::vector<std::string> words{"E", "clock", "primitive", "change", "not", "continue"};
  for (const CommandInfo& one : command_table) words.emplace_back(one.word);
  for (const isa::NamedField& named : program_.facts->fields) words.push_back(isa::word_or_quoted(named.name));
  for (const std::string& name : program_.facts->primitives) words.push_back(printable(name));
  std::sort(words.begin(), words.end());
  words.erase(std::unique(words.begin(), words.end()), words.end());
  return words;
}

std::string Session::place() const { return place_text(*run_, program_); }

checkpoint::Snapshot Session::snapshot() const { return checkpoint::take_snapshot(identity_, *run_, frame_, stats_); }

void Session::restore(const checkpoint::Snapshot& snapshot) { checkpoint::resume(snapshot, *run_, frame_, stats_); }

void Session::save_state() {
  if (!history_.has_recent_save(number())) history_.save_state(number(), snapshot());
}

void Session::advance(std::uint64_t number) {
  const std::array<engine::Observer*, 2> observers{&frame_, &stats_};
  while (!run_->is_finished()) {
    const std::uint64_t here = numbers_.of(run_->place());
    if (here >= number) return;
    run_->advance(std::min(number, history_.next_save_number(here)), observers);
    save_state();
  }
}

void Session::finish_trailing_segments() {
  if (number() == numbers_.count()) advance(engine::Run::end);
}

std::string Session::run_to_stop(std::optional<Stop> until, const Target* target) {
  std::vector<Stop> stops;
  stops.reserve(breakpoints_.size());
  for (const Breakpoint& one : breakpoints_) stops.emplace_back(one.target, program_, numbers_, *run_, clocks_);
  while (!run_->is_finished()) {
    std::uint64_t check = until ? until->next_check() : engine::Run::end;
    for (Stop& stop : stops) check = std::min(check, stop.next_check());
    advance(check);
    std::string why;
    // every stop must be evaluated, since each remembers the last value
    if (until && until->is_reached()) why = to_text(*target, program_) + "\n";
    for (std::size_t i = 0; i < stops.size(); ++i) {
      if (stops[i].is_reached())
        why += fmt::format("breakpoint {}: {}\n", breakpoints_[i].number, to_text(breakpoints_[i].target, program_));
    }
    finish_trailing_segments();
    if (!why.empty()) return why + place();
  }
  return (until ? to_text(*target, program_) + " was not reached\n" : "") + place();
}

std::string Session::perform(const Nothing& /*command*/) { return ""; }

std::string Session::perform(const RunOn& /*command*/) { return run_to_stop({}, nullptr); }

std::string Session::perform(const StepOn& command) {
  for (std::uint64_t i = 0; i < command.count && !run_->is_finished(); ++i) {
    advance(number() + 1);
    finish_trailing_segments();
  }
  return place();
}

std::string Session::perform(const Until& command) {
  Stop stop(command.target, program_, numbers_, *run_, clocks_);
  const std::string target = to_text(command.target, program_);
  if (stop.holds_already()) return fmt::format("{} already holds\n{}", target, place());
  if (stop.is_behind()) throw InputError(fmt::format("{} is not ahead; step back first with back N", target));
  return run_to_stop(stop, &command.target);
}

std::vector<std::uint64_t> Session::executed() const {
  const engine::RunState state = run_->save();
  std::vector<std::uint64_t> numbers;
  numbers.reserve(static_cast<std::size_t>(numbers_.of(state.place)));
  auto skip = state.skips.begin();
  for (std::uint64_t number = 0; number < numbers_.of(state.place); ++number) {
    numbers.push_back(number);
    const engine::Place at = numbers_.place(number);
    if (skip == state.skips.end() || skip->segment != at.segment || skip->index != at.index) continue;
    number += program_.segments[at.segment].instructions[at.index].constant;
    ++skip;
  }
  return numbers;
}

std::string Session::perform(const Back& command) {
  const std::vector<std::uint64_t> done = executed();
  const std::uint64_t target =
      command.count < done.size() ? done[done.size() - static_cast<std::size_t>(command.count)] : 0;
  if (command.count == 0) return place();
  restore(history_.latest_at(target));
  if (number() < target) advance(target);
  return place();
}

std::string Session::perform(const SetBreak& command) {
  const Stop check(command.target, program_, numbers_, *run_, clocks_);
  breakpoints_.push_back({next_breakpoint_++, command.target});
  return fmt::format("breakpoint {}: {}\n", breakpoints_.back().number, to_text(command.target, program_));
}

std::string Session::perform(const DeleteBreak& command) {
  const auto found = std::find_if(breakpoints_.begin(), breakpoints_.end(),
                                  [&](const Breakpoint& one) { return one.number == command.number; });
  if (found == breakpoints_.end())
    throw InputError(fmt::format("there is no breakpoint {}; breakpoints lists them", command.number));
  breakpoints_.erase(found);
  return "";
}

std::string Session::perform(const ListBreaks& /*command*/) {
  std::string text;
  for (const Breakpoint& one : breakpoints_)
    text += fmt::format("{:>3}  {}\n", one.number, to_text(one.target, program_));
  return text.empty() ? "no breakpoints\n" : text;
}

void Session::check_in_segment(std::uint32_t x, std::uint32_t y) const {
  if (program_.segments.empty()) throw InputError("the Program has no segments; there is nothing to inspect");
  const isa::Region region = run_->region();
  if (region.holds(x, y)) return;
  throw InputError(fmt::format("pixel {},{} is not in segment {}, which has {} x {} pixels at {},{}", x, y,
                               run_->place().segment, region.width, region.height, region.x, region.y));
}

std::string Session::perform(const PrintValue& command) {
  check_in_segment(command.watched.x, command.watched.y);
  return fmt::format("{} = {}\n", to_text(command.watched, program_),
                     value_text(command.watched.field, read_value(command.watched, *run_), program_));
}

std::string Session::perform(const PrintPixel& command) {
  check_in_segment(command.x, command.y);
  const auto line = [&](isa::Field field) {
    const std::uint32_t value = read_value({field, command.x, command.y}, *run_);
    return fmt::format("  {:<12} {}\n", to_text(field, program_), value_text(field, value, program_));
  };
  std::string text = line({});
  for (const isa::NamedField& named : program_.facts->fields) text += line(named.field);
  return text;
}

std::string Session::perform(const PrintEnable& /*command*/) {
  const isa::Region region = run_->region();
  std::vector<std::uint64_t> words((region.width + 63U) / 64U * std::size_t{region.height});
  if (!words.empty()) run_->read_enable(words);
  std::uint64_t enabled = 0;
  for (const std::uint64_t word : words) enabled += static_cast<std::uint64_t>(std::popcount(word));
  return fmt::format("E = 1 at {} of {} pixels\n", enabled, std::uint64_t{region.width} * region.height);
}

std::string Session::perform(const Where& /*command*/) { return where_text(*run_, program_, clocks_); }

std::string Session::perform(const ListAround& command) {
  const std::uint64_t number = command.number.value_or(this->number());
  if (command.number && number >= numbers_.count())
    throw InputError(
        fmt::format("there is no instruction i{}: the Program has {}, counted from i0", number, numbers_.count()));
  return list_text(number, program_);
}

std::string Session::perform(const TakePicture& command) {
  check_in_segment(run_->region().x, run_->region().y);
  observe::check_format(command.file);
  const FieldPicture picture = draw_field(command.field, *run_, program_);
  OutputFile file(command.file);
  observe::write_picture(file, picture.picture);
  file.commit();
  return fmt::format("{}: {}, {}\n", printable(command.file), to_text(command.field, program_), picture.scale);
}

std::string Session::perform(const WriteCheckpoint& command) {
  checkpoint::save_snapshot(command.file, snapshot());
  return fmt::format("{}: before i{}\n", printable(command.file), number());
}

std::string Session::perform(const ReadCheckpoint& command) {
  restore(checkpoint::load_snapshot(command.file, program_, machine_));
  save_state();
  return place();
}

std::string Session::perform(const Help& /*command*/) { return help_text(); }

std::string Session::perform(const Quit& /*command*/) {
  is_over_ = true;
  return "";
}

}  // namespace csgsim::debug
