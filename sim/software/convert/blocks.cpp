#include "sim/software/convert/blocks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <optional>

#include "host/convex/extent.h"
#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"
#include "hw/base/error.h"
#include "sim/software/convert/bodies.h"
#include "sim/software/convert/ray_bundle.h"

namespace csgsim::software::convert {

namespace {

/// A block of cells.
struct Block {
  std::array<std::uint32_t, 3> low{};
  std::array<std::uint32_t, 3> size{};

  [[nodiscard]] bool is_cell() const { return size == std::array<std::uint32_t, 3>{1, 1, 1}; }
  [[nodiscard]] Block half(std::size_t axis, bool is_upper) const {
    Block half = *this;
    half.size[axis] /= 2;
    if (is_upper) half.low[axis] += half.size[axis];
    return half;
  }
};

Block whole(std::uint32_t resolution) { return {{}, {resolution, resolution, resolution}}; }

/// Appends the code of a block and its descendants. `uniform(block)` returns whether the block is inside if it is
/// uniform, and is empty otherwise.
template <class Uniform>
void encode(const Block& block, std::size_t axis, const Uniform& uniform, std::string& code) {
  if (const std::optional<bool> is_in = uniform(block)) {
    code += *is_in ? '1' : '0';
    return;
  }
  code += '(';
  encode(block.half(axis, false), (axis + 1) % 3, uniform, code);
  encode(block.half(axis, true), (axis + 1) % 3, uniform, code);
}

/// Classification of the rays along a block.
class RayClass {
 public:
  explicit RayClass(const RayBundle& rays) : rays_(rays) {}

  std::optional<bool> operator()(const Block& block) const {
    std::optional<bool> all;
    for (std::uint32_t y = block.low[1]; y < block.low[1] + block.size[1]; ++y) {
      for (std::uint32_t x = block.low[0]; x < block.low[0] + block.size[0]; ++x) {
        const std::optional<bool> one = of_ray(rays_.changes(x, y), block.low[2], block.low[2] + block.size[2]);
        if (!one || (all && *all != *one)) return std::nullopt;
        all = one;
      }
    }
    return all;
  }

 private:
  static std::optional<bool> of_ray(std::span<const std::uint16_t> changes, std::uint32_t first, std::uint32_t last) {
    const auto after = std::ranges::upper_bound(changes, first);
    if (after != changes.end() && *after < last) return std::nullopt;
    return (after - changes.begin()) % 2 == 1;
  }

  const RayBundle& rays_;
};

/// Calls visit(block, is_in) for the leaves of a code. Returns whether the code is exactly one valid tree.
template <class Visit>
bool visit_leaves(std::string_view code, std::uint32_t resolution, const Visit& visit) {
  struct Open {
    Block block;
    std::size_t axis;
  };
  std::vector<Open> open{{whole(resolution), 0}};
  for (const char one : code) {
    if (open.empty()) return false;
    const Open now = open.back();
    open.pop_back();
    if (one != '(') {
      visit(now.block, one == '1');
      continue;
    }
    if (now.block.is_cell()) return false;
    open.push_back({now.block.half(now.axis, true), (now.axis + 1) % 3});
    open.push_back({now.block.half(now.axis, false), (now.axis + 1) % 3});
  }
  return open.empty();
}

std::uint64_t cells_in(const Block& block) {
  return static_cast<std::uint64_t>(block.size[0]) * block.size[1] * block.size[2];
}

}  // namespace

Bintree blocks(const model::Tree& tree, std::uint32_t resolution, const facet::Faceting& faceting, const Work& work) {
  Bintree bintree{.resolution = resolution, .code = "0"};
  if (tree.root == model::no_index) return bintree;
  const Bodies bodies = make_bodies(tree, faceting, work);
  const facet::Box box = convex::extent(facet::make_geometry(tree, faceting), csg::make_positive_tree(tree));
  const glm::dvec3 size = box.high - box.low;
  bintree.side = std::max({size.x, size.y, size.z});
  bintree.low = box.centre() - bintree.side / 2.0;
  const double unit = bodies.planes.unit();
  const CellGrid grid{(bintree.low - bodies.reference) / unit, bintree.cell() / unit, resolution};
  const RayBundle rays(tree, bodies, grid, work);
  bintree.code.clear();
  encode(whole(resolution), 0, RayClass(rays), bintree.code);
  return bintree;
}

BlockCounts count_blocks(const Bintree& bintree) {
  BlockCounts counts;
  visit_leaves(bintree.code, bintree.resolution, [&](const Block& block, bool is_in) {
    ++counts.blocks;
    if (!is_in) return;
    ++counts.full;
    counts.cells += cells_in(block);
  });
  return counts;
}

std::vector<bool> cells_of(const Bintree& bintree) {
  const std::size_t n = bintree.resolution;
  std::vector<bool> cells(n * n * n, false);
  visit_leaves(bintree.code, bintree.resolution, [&](const Block& block, bool is_in) {
    if (!is_in) return;
    for (std::size_t z = block.low[2]; z < block.low[2] + block.size[2]; ++z)
      for (std::size_t y = block.low[1]; y < block.low[1] + block.size[1]; ++y)
        for (std::size_t x = block.low[0]; x < block.low[0] + block.size[0]; ++x) cells[(z * n + y) * n + x] = true;
  });
  return cells;
}

std::string code_of(const std::vector<bool>& cells, std::uint32_t resolution) {
  const std::size_t n = resolution;
  const auto uniform = [&](const Block& block) -> std::optional<bool> {
    const bool first = cells[(block.low[2] * n + block.low[1]) * n + block.low[0]];
    for (std::size_t z = block.low[2]; z < block.low[2] + block.size[2]; ++z)
      for (std::size_t y = block.low[1]; y < block.low[1] + block.size[1]; ++y)
        for (std::size_t x = block.low[0]; x < block.low[0] + block.size[0]; ++x)
          if (cells[(z * n + y) * n + x] != first) return std::nullopt;
    return first;
  };
  std::string code;
  encode(whole(resolution), 0, uniform, code);
  return code;
}

std::string text_of(const Bintree& bintree) {
  constexpr std::size_t line_length = 120;
  std::string text = fmt::format("bintree 1\nresolution {}\ncube {} {} {} {}\n", bintree.resolution, bintree.low.x,
                                 bintree.low.y, bintree.low.z, bintree.side);
  for (std::size_t at = 0; at < bintree.code.size(); at += line_length)
    text += bintree.code.substr(at, line_length) + "\n";
  return text;
}

namespace {

/// The words of a text, one after another.
class Words {
 public:
  Words(std::string_view text, std::string_view name) : text_(text), name_(name) {}

  std::string_view next() {
    constexpr std::string_view blanks = " \n\r\t";
    text_.remove_prefix(std::min(text_.find_first_not_of(blanks), text_.size()));
    const std::string_view word = text_.substr(0, text_.find_first_of(blanks));
    text_.remove_prefix(word.size());
    return word;
  }

  void expect(std::string_view word) {
    if (next() != word) fail(fmt::format("'{}' is missing", word));
  }

  template <class Number>
  Number number() {
    const std::string_view word = next();
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc{} || end != word.data() + word.size())
      fail(fmt::format("'{}' is not a number", word));
    return value;
  }

  [[noreturn]] void fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}; create the bintree again", name_, what));
  }

 private:
  std::string_view text_;
  std::string_view name_;
};

}  // namespace

Bintree read_bintree(std::string_view text, std::string_view name) {
  Words words(text, name);
  words.expect("bintree");
  words.expect("1");
  words.expect("resolution");
  Bintree bintree;
  bintree.resolution = words.number<std::uint32_t>();
  if (bintree.resolution < min_cells || bintree.resolution > max_cells || !std::has_single_bit(bintree.resolution))
    words.fail("the resolution is not a power of two from 2 to 1024");
  words.expect("cube");
  for (int axis = 0; axis < 3; ++axis) bintree.low[axis] = words.number<double>();
  bintree.side = words.number<double>();
  const bool has_place = std::isfinite(bintree.low.x) && std::isfinite(bintree.low.y) && std::isfinite(bintree.low.z);
  if (!has_place || !std::isfinite(bintree.side) || bintree.side <= 0)
    words.fail("the cube needs a finite position and a finite side above 0");
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) bintree.code += word;
  const bool is_code = bintree.code.find_first_not_of("(01") == std::string::npos &&
                       visit_leaves(bintree.code, bintree.resolution, [](const Block&, bool) {});
  if (!is_code) words.fail("the code is not one complete tree");
  return bintree;
}

}  // namespace csgsim::software::convert
