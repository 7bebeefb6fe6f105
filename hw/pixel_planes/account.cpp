#include "hw/pixel_planes/account.h"

#include "hw/pixel_planes/figures.h"

namespace csgsim::pixel_planes {

machines::Account account(const ControllerAccount& controller, const machines::LinkAccount& link,
                          const machines::Machine& machine, std::uint64_t instruction_count) {
  const std::uint64_t working = controller.issuing + controller.clearing + controller.copying;
  const std::uint64_t clocks = working + controller.starved + controller.answering + controller.jumping +
                               controller.draining + controller.refreshing + controller.holding;
  const std::uint64_t bits = link.words * machine.link.width;
  machines::Account result{.counts = {{"link_words", link.words}, {"link_bits", bits}},
                           .shares = {{"link_bits_per_instruction", bits, instruction_count},
                                      {"controller_utilisation", working, clocks},
                                      {"link_utilisation", link.sending, clocks}},
                           .parts = {{"controller",
                                      {{"issuing", controller.issuing},
                                       {"clearing", controller.clearing},
                                       {"starved", controller.starved},
                                       {"answering", controller.answering},
                                       {"jumping", controller.jumping},
                                       {"draining", controller.draining}}},
                                     machines::part_account(link, "host link")}};
  if (machines::kind_figures<Figures>(machine).scan_out_buffers < 2) return result;
  result.counts.push_back({"refresh_waits", controller.refresh_waits});
  std::vector<machines::ActivityClocks>& activities = result.parts.front().clocks;
  activities.push_back({"refreshing", controller.refreshing});
  activities.push_back({"holding", controller.holding});
  activities.push_back({"copying", controller.copying});
  return result;
}

}  // namespace csgsim::pixel_planes
