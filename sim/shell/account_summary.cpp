#include "sim/shell/account_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "sim/shell/numbers.h"

namespace csgsim::shell {

namespace {

/// waiting_for_host as `wait: host`.
std::string heading(std::string_view activity) {
  constexpr std::string_view waiting = "waiting_for_";
  std::string text(activity.starts_with(waiting) ? activity.substr(waiting.size()) : activity);
  std::replace(text.begin(), text.end(), '_', ' ');
  return activity.starts_with(waiting) ? "wait: " + text : text;
}

bool same_activities(const machines::PartAccount& one, const machines::PartAccount& other) {
  return std::equal(one.clocks.begin(), one.clocks.end(), other.clocks.begin(), other.clocks.end(),
                    [](const auto& a, const auto& b) { return a.activity == b.activity; });
}

void print_heading(const machines::PartAccount& part) {
  fmt::print("\n{:<18}", "part");
  for (const machines::ActivityClocks& one : part.clocks) fmt::print("{:>22}", heading(one.activity));
  fmt::print("\n");
}

void print_part(const machines::PartAccount& part, std::uint64_t frame) {
  fmt::print("  {:<16}", part.part);
  for (const machines::ActivityClocks& one : part.clocks) {
    fmt::print("{:>14}{:>6.1f} %", grouped(one.clocks), 100.0 * machines::Share{{}, one.clocks, frame}.value());
  }
  fmt::print("\n");
}

}  // namespace

void print_account(const observe::Report& report) {
  const machines::Account& account = report.result.account;
  if (!account.counts.empty() || !account.shares.empty()) fmt::print("\n");
  for (const machines::Count& count : account.counts)
    fmt::print("{:<26}{:>18}\n", heading(count.name), grouped(count.value));
  for (const machines::Share& share : account.shares) {
    fmt::print("{:<26}{:>18.4g}\n", heading(share.name), share.value());
  }
  for (std::size_t i = 0; i < account.parts.size(); ++i) {
    if (i == 0 || !same_activities(account.parts[i - 1], account.parts[i])) print_heading(account.parts[i]);
    print_part(account.parts[i], report.result.clocks);
  }
}

}  // namespace csgsim::shell
