#include "sim/viewer/evaluations.h"

#include <algorithm>
#include <utility>

namespace csgsim::viewer {

namespace {

const char* text_of(Stage stage) {
  switch (stage) {
    case Stage::waiting: return "waiting";
    case Stage::evaluating: return "evaluating the model";
    case Stage::drawing: return "drawing";
  }
  return "";
}

double seconds(std::chrono::steady_clock::duration time) { return std::chrono::duration<double>(time).count(); }

}  // namespace

void Evaluations::end(Entry& entry, EndReason why) {
  if (entry.ended != EndReason::not_yet) return;
  entry.ended = why;
  entry.stop.request_stop();
}

void Evaluations::cancel(std::string_view name) {
  const std::lock_guard lock(mutex_);
  for (Entry& entry : entries_) {
    if (!name.empty() && entry.name == name) end(entry, EndReason::cancelled);
  }
}

void Evaluations::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  for (Entry& entry : entries_) end(entry, EndReason::closed);
}

void Evaluations::end_overdue() {
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  for (Entry& entry : entries_) {
    if (entry.stage == Stage::evaluating && now - entry.since > time_limit_) end(entry, EndReason::overdue);
  }
}

Json Evaluations::progress(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  const auto entry = std::ranges::find(entries_, name, &Entry::name);
  if (name.empty() || entry == entries_.end()) return Json::object();
  Json progress{{"doing", text_of(entry->stage)}, {"seconds", seconds(Clock::now() - entry->since)}};
  if (entry->stage == Stage::evaluating) progress["most"] = seconds(time_limit_);
  return progress;
}

std::list<Evaluations::Entry>::iterator Evaluation::add_entry(Evaluations& evaluations, std::string name) {
  const std::lock_guard lock(evaluations.mutex_);
  evaluations.entries_.push_back({.name = std::move(name)});
  const auto entry = std::prev(evaluations.entries_.end());
  if (evaluations.is_closed_) Evaluations::end(*entry, EndReason::closed);
  return entry;
}

Evaluation::Evaluation(Evaluations& all, std::string name)
    : all_(all), entry_(add_entry(all, std::move(name))), interruptible_(entry_->stop.get_token()) {}

Evaluation::~Evaluation() {
  const std::lock_guard lock(all_.mutex_);
  all_.entries_.erase(entry_);
}

void Evaluation::begin(Stage stage) {
  const std::lock_guard lock(all_.mutex_);
  entry_->stage = stage;
  entry_->since = Evaluations::Clock::now();
}

EndReason Evaluation::end_reason() const {
  const std::lock_guard lock(all_.mutex_);
  return entry_->ended;
}

}  // namespace csgsim::viewer
