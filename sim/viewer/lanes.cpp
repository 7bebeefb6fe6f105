#include "sim/viewer/lanes.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace csgsim::viewer {

using Json = nlohmann::ordered_json;

namespace {

constexpr std::uint64_t resolution = 400;  ///< stretches per lane

}  // namespace

/// The stretches of a lane in the format that the page receives; short neighbours are merged.
class Lanes::Shortened {
 public:
  Shortened(const std::vector<std::string>& texts, std::uint64_t grain) : texts_(texts), grain_(grain) {}

  void add(const Stretch& one) {
    const bool is_near = !held_.empty() && one.begin < begin_ + grain_;
    if (!is_near || one.clocks >= grain_) put_held();
    if (one.clocks >= grain_) {
      stretches_.push_back({one.begin, one.clocks, texts_[one.text]});
      return;
    }
    if (held_.empty()) begin_ = one.begin;
    end_ = one.end();
    ++count_;
    held_[one.text] += one.clocks;
  }

  Json take() {
    put_held();
    return std::move(stretches_);
  }

 private:
  void put_held() {
    if (held_.empty()) return;
    const auto most =
        std::max_element(held_.begin(), held_.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
    Json one{begin_, end_ - begin_, texts_[most->first]};
    std::uint64_t clocks = 0;
    for (const auto& held : held_) clocks += held.second;
    if (count_ > 1) one.insert(one.end(), {count_, clocks});
    stretches_.push_back(std::move(one));
    held_.clear();
    count_ = 0;
  }

  const std::vector<std::string>& texts_;
  std::uint64_t grain_;
  std::map<std::uint32_t, std::uint64_t> held_;  ///< clocks by text, of the merged stretches
  std::uint64_t begin_ = 0;
  std::uint64_t end_ = 0;
  std::size_t count_ = 0;
  Json stretches_ = Json::array();
};

Lanes::Lanes(std::string_view trace_events) : begin_(std::numeric_limits<std::uint64_t>::max()) {
  constexpr int of_events = 2;  // nesting depth: the file's object, the array
  // Events are consumed while parsing and not stored.
  const auto taken = [this](int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    if (depth != of_events || event != nlohmann::json::parse_event_t::object_end) return true;
    take(parsed);
    return false;
  };
  [[maybe_unused]] const nlohmann::json rest = nlohmann::json::parse(trace_events, taken);
  begin_ = std::min(begin_, end_);
}

std::uint32_t Lanes::text_index(const std::string& text) {
  const auto [found, is_new] = indices_.try_emplace(text, static_cast<std::uint32_t>(texts_.size()));
  if (is_new) texts_.push_back(text);
  return found->second;
}

void Lanes::take(const nlohmann::json& event) {
  const nlohmann::json& args = event.at("args");
  const auto lane = event.at("tid").get<unsigned>();
  if (event.at("ph") == "M") {
    const auto part = event.at("pid").get<unsigned>();
    if (event.at("name") == "process_name") {
      parts_[part] = args.at("name").get<std::string>();
      return;
    }
    lane_of_[lane] = lanes_.size();
    lanes_.push_back({parts_.at(part), args.at("name").get<std::string>(), {}});
    return;
  }
  const Stretch one{args.at("clock").get<std::uint64_t>(), args.at("clocks").get<std::uint64_t>(),
                    text_index(event.at("name").get<std::string>())};
  lanes_[lane_of_.at(lane)].stretches.push_back(one);
  begin_ = std::min(begin_, one.begin);
  end_ = std::max(end_, one.end());
}

Json Lanes::between(std::uint64_t begin_clock, std::uint64_t end_clock) const {
  Json lanes = Json::array();
  const std::uint64_t grain = std::max<std::uint64_t>(1, (end_clock - std::min(begin_clock, end_clock)) / resolution);
  for (const Lane& lane : lanes_) {
    Shortened shortened(texts_, grain);
    const auto ends_before = [](const Stretch& one, std::uint64_t clock) { return one.end() <= clock; };
    auto at = std::lower_bound(lane.stretches.begin(), lane.stretches.end(), begin_clock, ends_before);
    for (; at != lane.stretches.end() && at->begin < end_clock; ++at) {
      const std::uint64_t from = std::max(at->begin, begin_clock);
      shortened.add({from, std::min(at->end(), end_clock) - from, at->text});
    }
    lanes.push_back({{"part", lane.part}, {"name", lane.name}, {"stretches", shortened.take()}});
  }
  return lanes;
}

}  // namespace csgsim::viewer
