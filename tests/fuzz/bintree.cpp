// Block models: the text of a bintree.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "sim/software/convert/blocks.h"
#include "tests/fuzz/property.h"

namespace convert = csgsim::software::convert;
namespace fuzz = csgsim::fuzz;

namespace {

/// Largest resolution for which the cells of a code are laid out.
constexpr std::uint32_t most_laid_out = 16;

void check_cells(const convert::Bintree& bintree, const convert::BlockCounts& counts) {
  const std::vector<bool> cells = convert::cells_of(bintree);
  const auto full = static_cast<std::uint64_t>(std::ranges::count(cells, true));
  fuzz::require(full == counts.cells, "the number of full cells equals that of the blocks");
  const std::string code = convert::code_of(cells, bintree.resolution);
  fuzz::require(code.size() <= bintree.code.size(), "the code of whole blocks is the shortest for its cells");
  convert::Bintree again = bintree;
  again.code = code;
  fuzz::require(convert::cells_of(again) == cells, "the code of cells decodes to these cells");
}

void check(const convert::Bintree& bintree) {
  const auto is_number = [](double one) { return std::isfinite(one); };
  fuzz::require(is_number(bintree.low.x) && is_number(bintree.low.y) && is_number(bintree.low.z) &&
                    is_number(bintree.side) && bintree.side > 0,
                "the cube has a place and a size");
  const convert::BlockCounts counts = convert::count_blocks(bintree);
  const std::uint64_t n = bintree.resolution;
  fuzz::require(counts.full <= counts.blocks && counts.cells <= n * n * n, "the counts do not exceed the cube's cells");
  fuzz::require(2 * counts.blocks == bintree.code.size() + 1, "each halving adds one block");
  const convert::Bintree again = convert::read_bintree(convert::text_of(bintree), "b");
  fuzz::require(again.code == bintree.code && again.resolution == bintree.resolution && again.low == bintree.low &&
                    again.side == bintree.side,
                "a bintree is read as it was written");
  if (bintree.resolution <= most_laid_out) check_cells(bintree, counts);
}

}  // namespace

/// Any bytes are a complete bintree, or give one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(convert::read_bintree(fuzz::text_of(data, size), "b"));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "b");
  }
  return 0;
}
