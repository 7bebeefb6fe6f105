#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace csgsim::m68000 {

/// Thrown for a word that is no instruction of the subset, or for an address that is odd or outside the memory.
class Stopped : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Size of an operand in bytes.
enum class Size : std::uint8_t { byte = 1, word = 2, longword = 4 };

/// The condition codes, in the order of the bits of the status register.
struct Conditions {
  bool carry = false;
  bool overflow = false;
  bool zero = false;
  bool negative = false;
  bool extend = false;

  bool operator==(const Conditions&) const = default;
};

/// An MC68000 without exceptions, interrupts and privileged instructions, limited to the instructions that the programs
/// of tests/m68000 use. Clocks are those of the MC68000 User's Manual, section 8, without wait states.
class Processor {
 public:
  /// Creates a processor with memory from address 0.
  explicit Processor(std::size_t memory_bytes) : memory_(memory_bytes) {}

  std::array<std::uint32_t, 8> d{};
  std::array<std::uint32_t, 8> a{};  ///< a[7] is the stack pointer
  std::uint32_t pc = 0;
  Conditions conditions;

  [[nodiscard]] std::uint32_t read(std::uint32_t address, Size size) const;
  void write(std::uint32_t address, Size size, std::uint32_t value);

  /// Executes one instruction. Throws Stopped.
  void step();

  /// Calls the subroutine and returns after its RTS. Throws Stopped, also after more than `most` instructions.
  void call(std::uint32_t address, std::uint64_t most);

  [[nodiscard]] std::uint64_t clocks() const { return clocks_; }

 private:
  /// The location of an operand.
  struct Place {
    enum class In : std::uint8_t { data, address, memory, immediate } in = In::data;
    std::uint32_t at = 0;  ///< number of the register, address, or value
  };

  struct Operation {
    std::uint16_t word = 0;
    [[nodiscard]] unsigned bits(unsigned least, unsigned count) const { return (word >> least) & ((1U << count) - 1); }
    [[nodiscard]] unsigned mode() const { return bits(3, 3); }
    [[nodiscard]] unsigned reg() const { return bits(0, 3); }
    [[nodiscard]] unsigned upper() const { return bits(9, 3); }
  };

  /// The lower 24 bits of the address. Throws Stopped if an operand of that size cannot be there.
  [[nodiscard]] std::uint32_t checked_address(std::uint32_t address, Size size) const;
  std::uint32_t fetch(Size size);
  std::uint32_t indexed_address(std::uint32_t base);
  Place place(unsigned mode, unsigned reg, Size size);
  std::uint32_t get(const Place& place, Size size) const;
  void put(const Place& place, Size size, std::uint32_t value);
  void take(unsigned clocks) { clocks_ += clocks; }
  void push(std::uint32_t value);
  std::uint32_t pop();

  [[noreturn]] void unknown(Operation operation) const;
  [[nodiscard]] bool is_condition_true(unsigned condition) const;
  void set_logic_conditions(std::uint32_t value, Size size);
  std::uint32_t add(std::uint32_t to, std::uint32_t value, Size size);
  std::uint32_t subtract(std::uint32_t from, std::uint32_t value, Size size);
  void compare(std::uint32_t from, std::uint32_t value, Size size);

  void move(Operation operation);
  void immediate(Operation operation);
  void execute_miscellaneous(Operation operation);
  void execute_one_operand(Operation operation);
  void move_multiple(Operation operation, bool to_registers);
  void execute_address_work(Operation operation);
  void execute_quick(Operation operation);
  void execute_branch(Operation operation);
  void execute_count_down(Operation operation);
  void move_quick(Operation operation);
  void execute_arithmetic(Operation operation);
  void execute_address_arithmetic(Operation operation);
  void multiply(Operation operation);
  std::uint32_t combine(unsigned line, std::uint32_t to, std::uint32_t value, Size size);
  void execute_compare_or_exclusive_or(Operation operation);
  void shift(Operation operation);
  std::uint32_t shift_result(unsigned kind, bool left, std::uint32_t value, unsigned places, Size size);

  std::vector<std::uint8_t> memory_;
  std::uint64_t clocks_ = 0;
};

}  // namespace csgsim::m68000
