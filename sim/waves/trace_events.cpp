#include "sim/waves/trace_events.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <utility>

namespace csgsim::waves {

namespace {

std::string json_string(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// An event that names a process or a thread.
std::string name_event(std::string_view kind, unsigned part, unsigned lane, std::string_view name) {
  return fmt::format(R"({{"ph":"M","name":"{}","pid":{},"tid":{},"args":{{"name":{}}}}})", kind, part, lane,
                     json_string(name));
}

/// The number in the display format of its tap.
std::string text_of(std::uint64_t number, const wave::Tap& tap) {
  if (tap.show == wave::Show::bits) return fmt::format("{:0{}b}", number, tap.width);
  if (tap.show == wave::Show::hexadecimal) return fmt::format("{:0{}x}", number, (tap.width + 3) / 4);
  return std::to_string(number);
}

/// Returns a function that reads the tap in a clock, as text.
std::function<std::string()> reader_of(const wave::Tap& tap) {
  if (tap.show == wave::Show::text) return tap.text;
  return [tap] {
    const wave::Number number = tap.number();
    return number ? text_of(*number, tap) : std::string();
  };
}

}  // namespace

TraceEvents::TraceEvents(const std::vector<wave::Tap>& taps, Shown shown, std::uint64_t period_ps,
                         std::function<void(std::string_view)> write)
    : period_(period_ps), out_(std::move(write)) {
  out_.text = "{\"displayTimeUnit\":\"ns\",\"traceEvents\":[";
  std::vector<std::string_view> parts;
  for (const wave::Tap& tap : taps) {
    if (shown == Shown::texts && tap.show != wave::Show::text) continue;
    const std::string_view name = tap.name;
    const std::size_t dot = std::min(name.find('.'), name.size());
    const std::string_view part = name.substr(0, dot);
    auto found = std::ranges::find(parts, part);
    if (found == parts.end()) {
      found = parts.insert(parts.end(), part);
      put(name_event("process_name", static_cast<unsigned>(parts.size()), 0, part));
    }
    Lane lane{.text = reader_of(tap),
              .part = static_cast<unsigned>(found - parts.begin()) + 1,
              .number = static_cast<unsigned>(lanes_.size()) + 1,
              .shown = {}};
    put(name_event("thread_name", lane.part, lane.number, dot < name.size() ? name.substr(dot + 1) : name));
    lanes_.push_back(std::move(lane));
  }
}

void TraceEvents::sample(std::uint64_t clock) {
  for (Lane& lane : lanes_) {
    if (clock != next_) end(lane, next_);
    std::string text = lane.text();
    if (text == lane.shown) continue;
    end(lane, clock);
    lane.shown = std::move(text);
    lane.begin = clock;
  }
  next_ = clock + 1;
  out_.write_if_long();
}

void TraceEvents::finish() {
  for (Lane& lane : lanes_) end(lane, next_);
  out_.text += "\n]}\n";
  out_.write_all();
}

void TraceEvents::put(std::string_view event) {
  out_.text += std::exchange(has_events_, true) ? ",\n" : "\n";
  out_.text += event;
}

void TraceEvents::end(Lane& lane, std::uint64_t clock) {
  if (!lane.shown.empty()) {
    put(fmt::format(R"({{"ph":"X","name":{},"pid":{},"tid":{},"ts":{},"dur":{},"args":{{"clock":{},"clocks":{}}}}})",
                    json_string(lane.shown), lane.part, lane.number, microseconds(lane.begin),
                    microseconds(clock - lane.begin), lane.begin, clock - lane.begin));
  }
  lane.shown.clear();
}

std::string TraceEvents::microseconds(std::uint64_t clocks) const {
  constexpr std::uint64_t in_one = 1'000'000;
  const std::uint64_t picoseconds = clocks * period_;
  return fmt::format("{}.{:06}", picoseconds / in_one, picoseconds % in_one);
}

}  // namespace csgsim::waves
