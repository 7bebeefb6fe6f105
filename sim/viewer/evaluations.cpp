#include "sim/viewer/evaluations.h"

#include <algorithm>
#include <utility>

namespace csgsim::viewer {

namespace {

const char* text_of(Doing doing) {
  switch (doing) {
    case Doing::waiting: return "waiting";
    case Doing::evaluating: return "evaluating the model";
    case Doing::drawing: return "drawing";
  }
  return "";
}

double seconds(std::chrono::steady_clock::duration time) { return std::chrono::duration<double>(time).count(); }

}  // namespace

void Evaluations::end(Entry& entry, Ended why) {
  if (entry.ended != Ended::not_yet) return;
  entry.ended = why;
  entry.stop.request_stop();
}

void Evaluations::cancel(std::string_view name) {
  const std::lock_guard lock(mutex_);
  for (Entry& entry : entries_) {
    if (!name.empty() && entry.name == name) end(entry, Ended::cancelled);
  }
}

void Evaluations::close() {
  const std::lock_guard lock(mutex_);
  is_closed_ = true;
  for (Entry& entry : entries_) end(entry, Ended::closed);
}

void Evaluations::end_overdue() {
  const std::lock_guard lock(mutex_);
  const Clock::time_point now = Clock::now();
  for (Entry& entry : entries_) {
    if (entry.doing == Doing::evaluating && now - entry.since > most_) end(entry, Ended::overdue);
  }
}

Json Evaluations::progress(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  const auto entry = std::ranges::find(entries_, name, &Entry::name);
  if (name.empty() || entry == entries_.end()) return Json::object();
  Json progress{{"doing", text_of(entry->doing)}, {"seconds", seconds(Clock::now() - entry->since)}};
  if (entry->doing == Doing::evaluating) progress["most"] = seconds(most_);
  return progress;
}

std::list<Evaluations::Entry>::iterator Evaluation::entered(Evaluations& all, std::string name) {
  const std::lock_guard lock(all.mutex_);
  all.entries_.push_back({.name = std::move(name)});
  const auto entry = std::prev(all.entries_.end());
  if (all.is_closed_) Evaluations::end(*entry, Ended::closed);
  return entry;
}

Evaluation::Evaluation(Evaluations& all, std::string name)
    : all_(all), entry_(entered(all, std::move(name))), interruptible_(entry_->stop.get_token()) {}

Evaluation::~Evaluation() {
  const std::lock_guard lock(all_.mutex_);
  all_.entries_.erase(entry_);
}

void Evaluation::begin(Doing doing) {
  const std::lock_guard lock(all_.mutex_);
  entry_->doing = doing;
  entry_->since = Evaluations::Clock::now();
}

Ended Evaluation::ended() const {
  const std::lock_guard lock(all_.mutex_);
  return entry_->ended;
}

}  // namespace csgsim::viewer
