#include "hw/process/published.h"

#include "hw/kinds/load.h"
#include "tests/support/test.h"

using namespace csgsim;
using process::Comparison;
using process::Use;

namespace {

std::vector<Comparison> compared(const std::string& name) {
  return process::compare_published(process::load_process(name),
                                    [](std::string_view machine) { return kinds::load(std::string(machine)); });
}

double model(const std::vector<Comparison>& all, std::string_view what) {
  const auto found = std::ranges::find(all, what, [](const Comparison& one) { return one.quantity.what; });
  REQUIRE_MESSAGE(found != all.end(), std::string(what));
  return found->model;
}

}  // namespace

TEST_CASE("the model agrees with what is published within the stated tolerance") {
  std::set<std::string_view> used;
  for (const std::string_view name : process::process_names()) {
    const std::vector<Comparison> all = compared(std::string(name));
    CHECK(!all.empty());
    std::set<std::string_view> fitted;
    for (const Comparison& one : all) {
      CAPTURE(std::string(one.quantity.what));
      CHECK(used.insert(one.quantity.what).second);  // each quantity once
      CHECK(one.quantity.source.size() > 10);
      CHECK(one.model > 0);
      const bool is_fitted = one.quantity.use == Use::fitted;
      CHECK(is_fitted == !one.quantity.parameter.empty());
      if (is_fitted) CHECK(fitted.insert(one.quantity.parameter).second);  // each parameter by one quantity
      CHECK((one.quantity.use == Use::not_found) == (one.quantity.published == 0));
      CHECK((one.quantity.use == Use::predicted) == !one.quantity.reason.empty());
      CHECK(std::abs(one.deviation()) <= one.quantity.tolerance);
    }
  }
}

TEST_CASE("a fitted quantity depends on its parameter, and no prediction is fitted") {
  for (const std::string_view name : process::process_names()) {
    const std::vector<Comparison> before = compared(std::string(name));
    const process::Process process = process::load_process(std::string(name));
    for (const Comparison& one : before) {
      if (one.quantity.use != Use::fitted) continue;
      CAPTURE(std::string(one.quantity.what));
      const auto figure = std::ranges::find(process.figures, one.quantity.parameter, &machines::Figure::key);
      REQUIRE(figure != process.figures.end());
      const std::string change = fmt::format("+{}={}", figure->key, std::stoll(figure->value) * 9 / 10);
      CHECK(model(compared(std::string(name) + change), one.quantity.what) != one.model);
    }
  }
}

// Transistors are those of docs/hardware.md, areas and energies those of the process files.
TEST_CASE("quantities of the chips equal calculations by hand") {
  const std::vector<Comparison> nmos = compared("nmos-3um");
  // 217 + 50 transistors of logic, and 72 cells of three.
  CHECK(model(nmos, "Pixel-planes 4, transistors of 64 pixels") == 64 * (267 + 216));
  const double memory = 72 * 1633.5 * 2.16;  // um2
  const double pixel = 267 * 475 + memory;
  CHECK(model(nmos, "Pixel-planes 4, memory's part of the chip, %") == doctest::Approx(100 * memory / pixel));
  CHECK(model(nmos, "Pixel-planes 4, area of 64 pixels, mm2") == doctest::Approx(64 * pixel * 1e-6));
  CHECK(model(nmos, "Intel 8086, 3 um, die, mm2") == doctest::Approx(29'000 * 475e-6));
  CHECK(model(nmos, "Intel 80186, 3 um, die, mm2") == doctest::Approx(55'000 * 475e-6));
  CHECK(model(nmos, "Intel 8086, half of the maximum power, W") == doctest::Approx(29'000 / 3.0 * 88e-6));
  // 246 + 149 of logic in degree 2.
  CHECK(model(nmos, "Pixel-Powers, transistors more than Pixel-planes 4, %") ==
        doctest::Approx(100 * ((395 + 216) / 483.0 - 1)));
  // 64 pixels: loads, and per clock two accesses, two adder bits, seven flip-flops and two stream wires; two clock
  // wires that are charged and discharged; refresh of 72 bits, read and written.
  const double access = 320e-12 * std::sqrt(72 / 65'536.0);
  const double side = std::sqrt(pixel * 1e-6);
  const double wire = 250e-15 * 25 / 2;
  const double clock = 2 * access + 2 * 6.4e-12 + 7 * 8e-12 + 2 * side * wire + 2 * side * 2 * wire;
  CHECK(model(nmos, "Pixel-planes 4, power of 64 pixels, W") ==
        doctest::Approx(64 * (267 / 3.0 * 88e-6 + 10e6 * clock + 72 * 2 * access / 2e-3)));
  const std::vector<Comparison> cmos = compared("cmos-1.6um");
  // 392 + 258 transistors of logic in degree 2, and 208 cells of six.
  CHECK(model(cmos, "Pixel-planes 5, transistors of 256 pixels") == 256 * (650 + 1248));
  CHECK(model(cmos, "Pixel-planes 5, area of 256 pixels, mm2") ==
        doctest::Approx(256e-6 * (650 * 430 + 208 * 748.8 * 1.4)));
  CHECK(model(cmos, "DEC MultiTitan, 1.5 um, die, mm2") == doctest::Approx(180'000 * 430e-6 * 2.25 / 2.56));
  CHECK(model(compared("cmos-45nm"), "AMD RV870, 40 nm, die, mm2") == doctest::Approx(2154 * 0.2 / 0.7 * 1600 / 2025));
}

TEST_CASE("a process of other names has no published quantities") {
  process::Process other = process::load_process("nmos-3um");
  const process::LoadMachine none = [](std::string_view /*name*/) { return machines::Machine(); };
  for (const char* const name : {"nmos-3um2", "mine", ""}) {
    other.name = name;
    CHECK(process::compare_published(other, none).empty());
  }
}
