#include "tests/m68000/processor.h"

#include "tests/support/test.h"

using namespace csgsim::m68000;

namespace {

constexpr std::uint32_t program_at = 0x1000;
constexpr std::uint32_t data_at = 0x2000;

struct Row {
  std::string instruction;
  std::vector<std::uint16_t> words;
  std::uint64_t clocks;
};

/// Words as assembled by GNU as; clocks from the tables of the MC68000 User's Manual, section 8.
const std::vector<Row> rows{
    {"move.w d1,d0", {0x3001}, 4},
    {"move.l d1,d0", {0x2001}, 4},
    {"move.w (a0),d0", {0x3010}, 8},
    {"move.l (a0)+,d0", {0x2018}, 12},
    {"move.w -(a0),d0", {0x3020}, 10},
    {"move.w 4(a0),d0", {0x3028, 0x0004}, 12},
    {"move.l 4(a0),d0", {0x2028, 0x0004}, 16},
    {"move.w 2(a0,d1.w),d0", {0x3030, 0x1002}, 14},
    {"move.l 2(a0,d1.l),d0", {0x2030, 0x1802}, 18},
    {"move.w 0x2000.w,d0", {0x3038, 0x2000}, 12},
    {"move.l 0x2000.l,d0", {0x2039, 0x0000, 0x2000}, 20},
    {"move.w #5,d0", {0x303c, 0x0005}, 8},
    {"move.l #500,d0", {0x203c, 0x0000, 0x01f4}, 12},
    {"move.w d0,(a0)", {0x3080}, 8},
    {"move.l d0,-(sp)", {0x2f00}, 12},
    {"move.w d0,4(a0)", {0x3140, 0x0004}, 12},
    {"move.l d0,4(a0)", {0x2140, 0x0004}, 16},
    {"move.w 4(a0),4(a1)", {0x3368, 0x0004, 0x0004}, 20},
    {"move.l 4(a0),4(a1)", {0x2368, 0x0004, 0x0004}, 28},
    {"movea.l 4(a0),a1", {0x2268, 0x0004}, 16},
    {"movea.l 0(a1,d1.w),a0", {0x2071, 0x1000}, 18},
    {"moveq #3,d0", {0x7003}, 4},
    {"add.w d1,d0", {0xd041}, 4},
    {"add.l d1,d0", {0xd081}, 8},
    {"add.l (a0),d0", {0xd090}, 14},
    {"add.w d0,(a0)", {0xd150}, 12},
    {"add.l d0,(a0)", {0xd190}, 20},
    {"addi.w #300,d0", {0x0640, 0x012c}, 8},
    {"addi.l #300,d0", {0x0680, 0x0000, 0x012c}, 16},
    {"addi.l #300,(a0)", {0x0690, 0x0000, 0x012c}, 28},
    {"addq.w #1,d0", {0x5240}, 4},
    {"addq.l #1,d0", {0x5280}, 8},
    {"addq.l #4,a0", {0x5888}, 8},
    {"subq.w #1,4(a0)", {0x5368, 0x0004}, 16},
    {"mulu d1,d0, of no ones", {0xc0c1}, 38},
    {"mulu #0xffff,d0", {0xc0fc, 0xffff}, 38 + 32 + 4},
    {"muls #0x5555,d0", {0xc1fc, 0x5555}, 38 + 32 + 4},
    {"muls #-1,d0", {0xc1fc, 0xffff}, 38 + 2 + 4},
    {"adda.w d0,a0", {0xd0c0}, 8},
    {"adda.l d0,a0", {0xd1c0}, 8},
    {"adda.l (a0),a1", {0xd3d0}, 14},
    {"cmp.w d1,d0", {0xb041}, 4},
    {"cmp.l d1,d0", {0xb081}, 6},
    {"cmp.w 4(a0),d0", {0xb068, 0x0004}, 12},
    {"cmpa.l d1,a0", {0xb1c1}, 6},
    {"cmpi.w #2,(a0)", {0x0c50, 0x0002}, 12},
    {"cmpi.w #2,d0", {0x0c40, 0x0002}, 8},
    {"cmpi.l #2,d0", {0x0c80, 0x0000, 0x0002}, 14},
    {"and.w d1,d0", {0xc041}, 4},
    {"and.l d1,d0", {0xc081}, 8},
    {"and.w 4(a0),d0", {0xc068, 0x0004}, 12},
    {"andi.l #7,d0", {0x0280, 0x0000, 0x0007}, 16},
    {"or.w d1,d0", {0x8041}, 4},
    {"eor.w d1,d0", {0xb340}, 4},
    {"eor.l d1,d0", {0xb380}, 8},
    {"eor.w d1,(a0)", {0xb350}, 12},
    {"not.w d0", {0x4640}, 4},
    {"not.l d0", {0x4680}, 6},
    {"not.w 4(a0)", {0x4668, 0x0004}, 16},
    {"neg.w d0", {0x4440}, 4},
    {"clr.w d0", {0x4240}, 4},
    {"clr.l d0", {0x4280}, 6},
    {"clr.w (a0)", {0x4250}, 12},
    {"tst.w d0", {0x4a40}, 4},
    {"tst.w 4(a0)", {0x4a68, 0x0004}, 12},
    {"ext.l d0", {0x48c0}, 4},
    {"swap d0", {0x4840}, 4},
    {"lsl.l #5,d0", {0xeb88}, 18},
    {"lsr.w #3,d0", {0xe648}, 12},
    {"asr.l d2,d0", {0xe4a0}, 8},
    {"lsl.w (a0)", {0xe3d0}, 12},
    {"roxl.l #1,d0", {0xe390}, 10},
    {"lea 4(a0),a1", {0x43e8, 0x0004}, 8},
    {"lea 2(a0,d1.w),a1", {0x43f0, 0x1002}, 12},
    {"lea 0x2000.l,a1", {0x43f9, 0x0000, 0x2000}, 12},
    {"pea 4(a0)", {0x4868, 0x0004}, 16},
    {"jmp (a0)", {0x4ed0}, 8},
    {"jsr (a0)", {0x4e90}, 16},
    {"jsr 0x2000.l", {0x4eb9, 0x0000, 0x2000}, 20},
    {"link a6,#-4", {0x4e56, 0xfffc}, 16},
    {"unlk a6", {0x4e5e}, 12},
    {"movem.l d2-d3/a2-a3,-(sp)", {0x48e7, 0x3030}, 40},
    {"movem.l (sp)+,d2-d3/a2-a3", {0x4cdf, 0x0c0c}, 44},
    {"movem.w (sp)+,d2-d3", {0x4c9f, 0x000c}, 20},
    {"rts", {0x4e75}, 16},
    {"nop", {0x4e71}, 4},
    {"bra.s there", {0x6004}, 10},
    {"beq.s there", {0x6704}, 10},
    {"bne.s there", {0x6604}, 8},
    {"bne.w there", {0x6600, 0x0004}, 12},
    {"bsr.s there", {0x6104}, 18},
    {"dbra d1,there", {0x51c9, 0xfffa}, 14},
    {"dbra d3,there", {0x51cb, 0xfffa}, 10},
    {"dbeq d1,there", {0x57c9, 0xfffa}, 12},
    {"seq d0", {0x57c0}, 6},
    {"sne d0", {0x56c0}, 4},
};

/// A processor about to execute the words: Z is set, d1 is 0, d2 64, d3 1, and all addresses point to zeros.
Processor before(const std::vector<std::uint16_t>& words) {
  Processor processor(0x4000);
  processor.a.fill(data_at);
  processor.d[2] = 64;
  processor.d[3] = 1;
  processor.conditions.zero = true;
  processor.pc = program_at;
  std::uint32_t at = program_at;
  for (const std::uint16_t word : words) {
    processor.write(at, Size::word, word);
    at += 2;
  }
  return processor;
}

}  // namespace

TEST_CASE("instructions take the clocks of the manual") {
  for (const Row& row : rows) {
    CAPTURE(row.instruction);
    Processor processor = before(row.words);
    processor.step();
    CHECK(processor.clocks() == row.clocks);
  }
}

TEST_CASE("sums and comparisons set the condition codes that branches test") {
  struct Sum {
    std::uint16_t one;
    std::uint16_t other;
    std::uint16_t sum;
    Conditions conditions;  // carry, overflow, zero, negative, extend
  };
  for (const Sum& sum :
       {Sum{0x7fff, 1, 0x8000, {false, true, false, true, false}}, Sum{0xffff, 1, 0, {true, false, true, false, true}},
        Sum{0x8000, 0x8000, 0, {true, true, true, false, true}}, Sum{2, 3, 5, {false, false, false, false, false}}}) {
    Processor processor = before({0xd041});  // add.w d1,d0
    processor.d[0] = 0xabcd'0000U + sum.one;
    processor.d[1] = sum.other;
    processor.step();
    CHECK(processor.d[0] == 0xabcd'0000U + sum.sum);
    CHECK(processor.conditions == sum.conditions);
  }
  struct Comparison {
    std::uint16_t d0;
    std::uint16_t d1;
    std::string taken;  // for bhi bls bcc bcs bne beq bge blt bgt ble
  };
  for (const Comparison& one : {Comparison{1, 2, "-x-xx--x-x"}, Comparison{2, 2, "-xx--xx--x"},
                                Comparison{0xffff, 2, "x-x-x--x-x"}, Comparison{2, 0x8000, "-x-xx-x-x-"}}) {
    std::string taken;
    for (const std::uint16_t branch :
         std::vector<std::uint16_t>{0x6202, 0x6302, 0x6402, 0x6502, 0x6602, 0x6702, 0x6c02, 0x6d02, 0x6e02, 0x6f02}) {
      Processor processor = before({0xb041, branch});  // cmp.w d1,d0
      processor.d[0] = one.d0;
      processor.d[1] = one.d1;
      processor.step();
      processor.step();
      taken += processor.pc == program_at + 6 ? 'x' : '-';
    }
    CHECK(taken == one.taken);
  }
}

TEST_CASE("a rotation through X shifts X in and the shifted-out bit sets X and C") {
  for (const bool extend : {false, true}) {
    Processor left = before({0xe390});  // roxl.l #1,d0
    left.d[0] = 0x8000'0001;
    left.conditions.extend = extend;
    left.step();
    CHECK(left.d[0] == (extend ? 3U : 2U));
    CHECK(left.conditions == Conditions{true, false, false, false, true});
    Processor right = before({0xe250});  // roxr.w #1,d0
    right.d[0] = 0xabcd'0002;
    right.conditions.extend = extend;
    right.step();
    CHECK(right.d[0] == (extend ? 0xabcd'8001U : 0xabcd'0001U));
    CHECK(right.conditions == Conditions{false, false, false, extend, false});
  }
}

TEST_CASE("a byte moves the stack pointer by two and another address register by one") {
  Processor processor = before({0x1f03, 0x1103, 0x121f});  // move.b d3,-(sp); move.b d3,-(a0); move.b (sp)+,d1
  processor.step();
  CHECK(processor.a[7] == data_at - 2);
  CHECK(processor.read(data_at - 2, Size::byte) == 1);
  processor.step();
  CHECK(processor.a[0] == data_at - 1);
  processor.d[1] = 0xffff'ffff;
  processor.step();
  CHECK(processor.a[7] == data_at);
  CHECK(processor.d[1] == 0xffff'ff01);
}

TEST_CASE("returns from a subroutine and stops at an unsupported instruction") {
  Processor processor = before({0x7005, 0x4e75});  // moveq #5,d0; rts
  processor.call(program_at, 2);
  CHECK(processor.d[0] == 5);
  CHECK(processor.a[7] == data_at);
  CHECK(processor.clocks() == 4 + 16);
  CHECK_THROWS_AS(before({0x60fe}).call(program_at, 100), Stopped);  // bra to itself
  // Unsupported: chk, divu, abcd, movep, bset, addx, cmpm, link a7, trap, and a constant destination.
  for (const std::uint16_t word : std::vector<std::uint16_t>{0x4180, 0x80c0, 0xc100, 0x0188, 0x01c0, 0xd100, 0xb108,
                                                             0x4e57, 0x4e40, 0x39fc, 0xa000, 0xf000}) {
    CAPTURE(word);
    CHECK_THROWS_AS(before({word, 0, 0}).step(), Stopped);
  }
  Processor odd = before({0x3010});  // move.w (a0),d0
  odd.a[0] = data_at + 1;
  CHECK_THROWS_AS(odd.step(), Stopped);
  odd.pc = program_at;
  odd.a[0] = 0x4000;
  CHECK_THROWS_AS(odd.step(), Stopped);
}
