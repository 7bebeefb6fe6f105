#include "hw/pixel_planes/account.h"

namespace csgsim::pixel_planes {

machines::Account account(const ControllerAccount& controller, const machines::LinkAccount& link,
                          const machines::Link& figures, std::uint64_t instructions) {
  const std::uint64_t working = controller.issuing + controller.clearing;
  const std::uint64_t clocks =
      working + controller.starved + controller.answering + controller.jumping + controller.draining;
  const std::uint64_t bits = link.words * figures.width;
  return {.counts = {{"link_words", link.words}, {"link_bits", bits}},
          .shares = {{"link_bits_an_instruction", bits, instructions},
                     {"controller_busy", working, clocks},
                     {"link_busy", link.sending, clocks}},
          .parts = {{"controller",
                     {{"issuing", controller.issuing},
                      {"clearing", controller.clearing},
                      {"starved", controller.starved},
                      {"answering", controller.answering},
                      {"jumping", controller.jumping},
                      {"draining", controller.draining}}},
                    machines::part_of(link, "host link")}};
}

}  // namespace csgsim::pixel_planes
