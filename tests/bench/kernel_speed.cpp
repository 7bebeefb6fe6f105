// bench_kernel_speed [MODULES SIGNALS]: cost of a clock in SystemC's kernel for MODULES modules that only write SIGNALS
// signals in total, each a new value at every edge. Pixel-planes usually has seven active modules and six changing
// signals. Seconds are processor time.

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <systemc>
#include <vector>

#include "hw/systemc/clock.h"

namespace csgsim::bench {

namespace {

class Idle final : public sc_core::sc_module {
 public:
  sc_core::sc_in<bool> clock{"clock"};

  Idle(sc_core::sc_module_name name, std::size_t signals) : sc_core::sc_module(name), signals_(signals) {
    SC_HAS_PROCESS(Idle);
    SC_METHOD(on_clock);
    dont_initialize();
    sensitive << clock.pos();
  }

 private:
  void on_clock() {
    ++edges_;
    for (sc_core::sc_signal<std::uint64_t>& signal : signals_) signal.write(edges_);
  }

  std::vector<sc_core::sc_signal<std::uint64_t>> signals_;
  std::uint64_t edges_ = 0;
};

void run(std::size_t modules, std::size_t signals) {
  constexpr std::uint64_t clocks = 1'000'000;
  systemc::Clock clock("clock", sc_core::sc_time(100, sc_core::SC_NS));
  std::vector<std::unique_ptr<Idle>> idle;
  for (std::size_t i = 0; i < modules; ++i) {
    const std::size_t share = signals / modules + (i < signals % modules ? 1 : 0);
    idle.push_back(std::make_unique<Idle>(sc_core::sc_module_name(sc_core::sc_gen_unique_name("idle")), share));
    idle.back()->clock(clock);
  }
  sc_core::sc_start(sc_core::SC_ZERO_TIME);
  const std::clock_t begin = std::clock();
  sc_core::sc_start(clock.period() * static_cast<double>(clocks));
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  fmt::print("{} modules, {} signals: {:.3f} us a clock\n", modules, signals,
             seconds * 1e6 / static_cast<double>(clocks));
}

}  // namespace

}  // namespace csgsim::bench

int main(int argc, char** argv) {
  const auto argument = [&](int i, std::size_t otherwise) {
    return i < argc ? static_cast<std::size_t>(std::strtoul(argv[i], nullptr, 10)) : otherwise;
  };
  csgsim::bench::run(std::max<std::size_t>(argument(1, 7), 1), argument(2, 6));
}
