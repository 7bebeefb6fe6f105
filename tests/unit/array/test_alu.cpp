#include <doctest/doctest.h>

#include <array>
#include <cstdint>
#include <string>

#include "hw/array/kernels.h"
#include "hw/array/plane.h"

namespace {

using csgsim::array::AluFunction;
using csgsim::array::AluInfo;
using csgsim::array::Words;
namespace kernels = csgsim::array::kernels;

/// One pixel: operands and registers.
struct Pixel {
  bool x = false;
  bool y = false;
  bool present = false;
  bool enable = false;
  bool carry = false;
  bool latch = false;
  bool memory = false;

  bool operator==(const Pixel&) const = default;
};

bool majority(bool a, bool b, bool c) { return (a ? 1 : 0) + (b ? 1 : 0) + (c ? 1 : 0) >= 2; }

/// The meanings of the table, a pixel at a time.
Pixel expected_after(AluFunction function, bool constant, Pixel p) {
  const auto less = [&p](bool carry_in) {
    p.carry = majority(p.x, !p.y, carry_in);
    p.enable = p.enable && !p.carry;
  };
  const auto write = [&p](bool value) { p.memory = p.enable ? value : p.memory; };
  const auto sum = [&](bool x, bool carry_in) {
    write((x != p.y) != carry_in);
    p.carry = majority(x, p.y, carry_in);
  };
  const auto sign = [&p] { p.carry = majority(!p.x, false, p.carry); };
  switch (function) {
    case AluFunction::idle:
    case AluFunction::answer: break;
    case AluFunction::latch_x: p.latch = p.x; break;
    case AluFunction::enable_all: p.enable = p.present; break;
    case AluFunction::enable_invert: p.enable = p.present && !p.enable; break;
    case AluFunction::enable_load: p.enable = p.x; break;
    case AluFunction::enable_and: p.enable = p.enable && p.x; break;
    case AluFunction::enable_and_not: p.enable = p.enable && !p.x; break;
    case AluFunction::enable_or: p.enable = p.enable || p.x; break;
    case AluFunction::enable_xor: p.enable = p.enable != p.x; break;
    case AluFunction::enable_equal: p.enable = p.enable && p.x == p.y; break;
    case AluFunction::compare_from_0: p.carry = majority(p.x, !p.y, false); break;
    case AluFunction::compare_from_1: p.carry = majority(p.x, !p.y, true); break;
    case AluFunction::compare: p.carry = majority(p.x, !p.y, p.carry); break;
    case AluFunction::compare_with_0: p.carry = majority(p.x, true, p.carry); break;
    case AluFunction::less_from_0: less(false); break;
    case AluFunction::less_from_1: less(true); break;
    case AluFunction::less: less(p.carry); break;
    case AluFunction::sign_enable:
      sign();
      p.enable = p.enable && p.carry;
      break;
    case AluFunction::sign_enable_not:
      sign();
      p.enable = p.enable && !p.carry;
      break;
    case AluFunction::sign_select:
      sign();
      p.carry = p.enable && p.carry;
      break;
    case AluFunction::sign_select_not:
      sign();
      p.carry = p.enable && !p.carry;
      break;
    case AluFunction::enable_fits: p.enable = p.enable && !(p.carry && p.x); break;
    case AluFunction::store_x: write(p.x); break;
    case AluFunction::store_x_selected:
      if (p.carry) write(p.x);
      break;
    case AluFunction::store_not_x: write(!p.x); break;
    case AluFunction::store_constant: write(constant); break;
    case AluFunction::store_xor_constant: write(p.x != constant); break;
    case AluFunction::store_and: write(p.x && p.y); break;
    case AluFunction::store_or: write(p.x || p.y); break;
    case AluFunction::store_xor: write(p.x != p.y); break;
    case AluFunction::store_and_not: write(p.x && !p.y); break;
    case AluFunction::sum_from_0: sum(p.x, false); break;
    case AluFunction::sum: sum(p.x, p.carry); break;
    case AluFunction::sum_with_0: sum(false, p.carry); break;
    case AluFunction::store_enable: p.memory = p.enable; break;
  }
  return p;
}

constexpr unsigned registers = 7;
constexpr unsigned states = 1U << registers;
using Planes = std::array<Words, registers>;

/// Every combination of operands and registers is one pixel, and the whole several times over.
Planes all_states() {
  Planes planes;
  for (Words& plane : planes) plane.resize(8 * states / 64);
  for (std::size_t pixel = 0; pixel < planes[0].size() * 64; ++pixel) {
    for (unsigned r = 0; r < registers; ++r) {
      planes[r][pixel / 64] |= static_cast<std::uint64_t>((pixel % states) >> r & 1U) << (pixel % 64);
    }
  }
  return planes;
}

Pixel pixel_of(const Planes& planes, std::size_t pixel) {
  const auto bit = [&](unsigned r) { return (planes[r][pixel / 64] >> (pixel % 64) & 1U) != 0; };
  return {bit(0), bit(1), bit(2), bit(3), bit(4), bit(5), bit(6)};
}

kernels::AluPlanes operands(Planes& planes) {
  return {.x = planes[0].data(),
          .y = planes[1].data(),
          .present = planes[2].data(),
          .enable = planes[3].data(),
          .carry = planes[4].data(),
          .latch = planes[5].data(),
          .write = planes[6].data(),
          .words = planes[0].size()};
}

}  // namespace

TEST_CASE("every ALU function does what its meaning says, for every state of a pixel") {
  const Planes before = all_states();
  for (std::size_t row = 0; row < std::size(csgsim::array::alu_table); ++row) {
    const auto function = static_cast<AluFunction>(row);
    CAPTURE(std::string(csgsim::array::info(function).name));
    for (const bool constant : {false, true}) {
      Planes after = before;
      kernels::AluPlanes planes = operands(after);
      planes.constant = constant;
      kernels::alu_step(function, planes);
      bool all_right = true;
      for (std::size_t pixel = 0; pixel < before[0].size() * 64; ++pixel) {
        all_right = all_right && pixel_of(after, pixel) == expected_after(function, constant, pixel_of(before, pixel));
      }
      CHECK(all_right);
    }
  }
}

TEST_CASE("an ALU function touches the operands that its row names, and no others") {
  for (std::size_t row = 0; row < std::size(csgsim::array::alu_table); ++row) {
    const auto function = static_cast<AluFunction>(row);
    const AluInfo& info = csgsim::array::info(function);
    CAPTURE(std::string(info.name));
    Planes planes = all_states();
    kernels::AluPlanes used = operands(planes);
    if (!info.reads_x) used.x = nullptr;
    if (!info.reads_y) used.y = nullptr;
    if (!info.writes) used.write = nullptr;
    kernels::alu_step(function, used);
  }
}

TEST_CASE("ones are counted and found") {
  Words plane(24);
  CHECK(kernels::count_ones(plane.data(), plane.size()) == 0);
  CHECK_FALSE(kernels::any_ones(plane.data(), plane.size()));
  for (std::size_t word = 0; word < plane.size(); ++word) {
    plane[word] = std::uint64_t{1} << (word * 2);
    CHECK(kernels::any_ones(plane.data(), plane.size()));
    CHECK(kernels::count_ones(plane.data(), plane.size()) == 1);
    plane[word] = 0;
  }
  plane.assign(24, ~std::uint64_t{0});
  CHECK(kernels::count_ones(plane.data(), plane.size()) == 24 * 64);
}
