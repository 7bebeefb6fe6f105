// Memory, registers and operands.

#include "tests/m68000/processor.h"

#include <fmt/format.h>

#include "tests/m68000/numbers.h"

namespace csgsim::m68000 {

namespace {

constexpr std::uint32_t address_mask = 0xff'ffffU;  // 24 address lines
constexpr std::uint32_t outside = 0xff'fff0U;       // return address of a call from the host program
constexpr unsigned long_mode = 7;                   // addressing modes that use no address register

}  // namespace

std::uint32_t Processor::checked_address(std::uint32_t address, Size size) const {
  const std::uint32_t at = address & address_mask;
  if (at + bytes_of(size) > memory_.size()) throw Stopped(fmt::format("address {:#x} is out of memory", at));
  if (size != Size::byte && at % 2 != 0) throw Stopped(fmt::format("address {:#x} is odd", at));
  return at;
}

std::uint32_t Processor::read(std::uint32_t address, Size size) const {
  const std::uint32_t at = checked_address(address, size);
  std::uint32_t value = 0;
  for (std::uint32_t byte = 0; byte < bytes_of(size); ++byte) value = value << 8U | memory_[at + byte];
  return value;
}

void Processor::write(std::uint32_t address, Size size, std::uint32_t value) {
  std::uint32_t at = checked_address(address, size) + bytes_of(size);
  for (std::uint32_t byte = 0; byte < bytes_of(size); ++byte, value >>= 8U)
    memory_[--at] = static_cast<std::uint8_t>(value & 0xffU);
}

std::uint32_t Processor::fetch(Size size) {
  const std::uint32_t value = read(pc, size == Size::byte ? Size::word : size);
  pc += size == Size::longword ? 4 : 2;
  return size == Size::byte ? value & 0xffU : value;
}

/// The sum of a base, an index register and a displacement of 8 bits.
std::uint32_t Processor::indexed_address(std::uint32_t base) {
  const std::uint32_t extension = fetch(Size::word);
  const std::uint32_t reg = (extension >> 12U) & 7U;
  const std::uint32_t index = (extension & 0x8000U) != 0 ? a[reg] : d[reg];
  return base + extended(extension & 0xffU, Size::byte) +
         ((extension & 0x800U) != 0 ? index : extended(index & 0xffffU, Size::word));
}

Processor::Place Processor::place(unsigned mode, unsigned reg, Size size) {
  using In = Place::In;
  // The stack pointer stays even.
  const std::uint32_t step = size == Size::byte && reg == 7 ? 2 : bytes_of(size);
  switch (mode) {
    case 0: return {In::data, reg};
    case 1: return {In::address, reg};
    case 2: return {In::memory, a[reg]};
    case 3: a[reg] += step; return {In::memory, a[reg] - step};
    case 4: a[reg] -= step; return {In::memory, a[reg]};
    case 5: {
      const std::uint32_t displacement = extended(fetch(Size::word), Size::word);
      return {In::memory, a[reg] + displacement};
    }
    case 6: return {In::memory, indexed_address(a[reg])};
    default: break;
  }
  const std::uint32_t base = pc;
  switch (reg) {
    case 0: return {In::memory, extended(fetch(Size::word), Size::word)};
    case 1: return {In::memory, fetch(Size::longword)};
    case 2: return {In::memory, base + extended(fetch(Size::word), Size::word)};
    case 3: return {In::memory, indexed_address(base)};
    case 4: return {In::immediate, fetch(size)};
    default: throw Stopped(fmt::format("unsupported addressing mode {}.{}", long_mode, reg));
  }
}

std::uint32_t Processor::get(const Place& place, Size size) const {
  switch (place.in) {
    case Place::In::data: return d[place.at] & mask_of(size);
    case Place::In::address: return a[place.at] & mask_of(size);
    case Place::In::memory: return read(place.at, size);
    case Place::In::immediate: break;
  }
  return place.at;
}

void Processor::put(const Place& place, Size size, std::uint32_t value) {
  switch (place.in) {
    case Place::In::data: d[place.at] = (d[place.at] & ~mask_of(size)) | (value & mask_of(size)); return;
    case Place::In::address: a[place.at] = extended(value & mask_of(size), size); return;
    case Place::In::memory: write(place.at, size, value); return;
    case Place::In::immediate: break;
  }
  throw Stopped("a constant cannot be a destination");
}

void Processor::push(std::uint32_t value) {
  a[7] -= 4;
  write(a[7], Size::longword, value);
}

std::uint32_t Processor::pop() {
  a[7] += 4;
  return read(a[7] - 4, Size::longword);
}

void Processor::unknown(Operation operation) const {
  throw Stopped(fmt::format("{:04x} before {:#x} is not a supported instruction", operation.word, pc));
}

void Processor::call(std::uint32_t address, std::uint64_t most) {
  push(outside);
  pc = address;
  for (std::uint64_t done = 0; pc != outside; ++done) {
    if (done == most) throw Stopped(fmt::format("the subroutine at {:#x} does not return", address));
    step();
  }
}

}  // namespace csgsim::m68000
