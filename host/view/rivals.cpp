#include "host/view/rivals.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>

namespace csgsim::view {

namespace {

using Numbers = std::vector<std::uint32_t>;

/// If there are at most this many functions, all of them are rivals.
constexpr std::size_t few = 16;

/// Number of a tile's corners, and index of its middle pixel, which follows them.
constexpr std::size_t corners = 4;
constexpr std::size_t middle = 4;
using Values = std::array<std::int64_t, corners + 1>;

constexpr bool is_pixel(const PixelRect& tile) { return tile.x0 == tile.x1 && tile.y0 == tile.y1; }

constexpr std::int32_t midpoint(std::int32_t low, std::int32_t high) { return low + (high - low) / 2; }

/// The halves of a tile, cut across its longer side. The tile must be larger than a pixel.
std::array<PixelRect, 2> halves(const PixelRect& tile) {
  std::array<PixelRect, 2> parts{tile, tile};
  if (tile.x1 - tile.x0 >= tile.y1 - tile.y0) {
    parts[0].x1 = midpoint(tile.x0, tile.x1);
    parts[1].x0 = parts[0].x1 + 1;
  } else {
    parts[0].y1 = midpoint(tile.y0, tile.y1);
    parts[1].y0 = parts[0].y1 + 1;
  }
  return parts;
}

/// The fronts or backs that lead in a tile.
struct Leading {
  Numbers numbers;
  std::uint32_t first = 0;  ///< the number of the function that leads at the middle; valid if `numbers` is not empty
  Values ranks{};           ///< ranks of `first`
};

/// Fronts or backs: the one with the greatest rank leads; among equal ranks, the first. At a single pixel, ranks are
/// depths, which are negated for backs. In a larger tile, where depths are not linear, ranks are values, and a function
/// with a higher number leads one with a lower number only if it is ahead by a whole depth step in the whole tile.
class Envelope {
 public:
  Envelope(std::span<const FixedLinear> functions, bool is_back, unsigned shift)
      : functions_(functions), is_back_(is_back), shift_(shift) {}

  [[nodiscard]] std::size_t size() const { return functions_.size(); }

  /// Finds the functions that lead somewhere in a tile. Calls lose(number, by) for each of the others, where `by` leads
  /// it at every pixel of the tile.
  template <class Lose>
  Leading leading(const Numbers& numbers, const PixelRect& tile, const Lose& lose) {
    Leading left;
    if (numbers.empty()) return left;
    ranks_.clear();
    for (const std::uint32_t number : numbers) ranks_.push_back(ranks(functions_[number], tile));
    // Indices into `numbers`. The middle comes first, because its leader is ahead of most others.
    std::array<std::size_t, corners + 1> leaders{};
    for (std::size_t at = 0; at <= corners; ++at) {
      const auto greatest = std::ranges::max_element(ranks_, {}, [&](const Values& one) { return one[at]; });
      leaders[at == middle ? 0 : at + 1] = static_cast<std::size_t>(greatest - ranks_.begin());
    }
    const std::int64_t step = is_pixel(tile) ? 1 : std::int64_t{1} << shift_;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const auto by = std::ranges::find_if(leaders, [&](std::size_t leader) {
        return leader != i && is_before(ranks_[leader], ranks_[i], leader < i ? 0 : step);
      });
      if (by == leaders.end()) {
        left.numbers.push_back(numbers[i]);
      } else {
        lose(numbers[i], numbers[*by]);
      }
    }
    left.first = numbers[leaders[0]];
    left.ranks = ranks_[leaders[0]];
    return left;
  }

 private:
  [[nodiscard]] Values ranks(const FixedLinear& function, const PixelRect& tile) const {
    const std::int32_t x = midpoint(tile.x0, tile.x1);
    const std::int32_t y = midpoint(tile.y0, tile.y1);
    Values values{value_at(function, tile.x0, tile.y0), value_at(function, tile.x1, tile.y0),
                  value_at(function, tile.x0, tile.y1), value_at(function, tile.x1, tile.y1), value_at(function, x, y)};
    for (std::int64_t& value : values) {
      if (is_pixel(tile)) value >>= shift_;
      if (is_back_) value = -value;
    }
    return values;
  }

  static bool is_before(const Values& one, const Values& other, std::int64_t by) {
    return std::equal(one.begin(), one.begin() + corners, other.begin(),
                      [&](std::int64_t mine, std::int64_t others) { return mine - others >= by; });
  }

  std::span<const FixedLinear> functions_;
  bool is_back_;
  unsigned shift_;
  std::vector<Values> ranks_;
};

/// Finds the rivals of one boundary. All functions are numbered together: fronts, backs, edges.
class Finder {
 public:
  Finder(const Boundary& boundary, unsigned shift)
      : boundary_(boundary),
        fronts_(boundary.fronts, false, shift),
        backs_(boundary.backs, true, shift),
        rivals_(fronts_.size() + backs_.size()),
        pixels_(rivals_.size()) {}

  AllRivals operator()(const PixelRect& pixels) {
    if (!pixels.empty()) divide(pixels, up_to(boundary_.fronts), up_to(boundary_.backs), up_to(boundary_.edges));
    AllRivals all;
    for (std::size_t i = 0; i < rivals_.size(); ++i)
      (i < fronts_.size() ? all.of_fronts : all.of_backs).push_back(sorted(rivals_[i], pixels_[i]));
    return all;
  }

 private:
  static Numbers up_to(const std::vector<FixedLinear>& functions) {
    Numbers numbers(functions.size());
    std::iota(numbers.begin(), numbers.end(), 0U);
    return numbers;
  }

  [[nodiscard]] std::uint32_t back(std::uint32_t number) const {
    return static_cast<std::uint32_t>(fronts_.size()) + number;
  }
  [[nodiscard]] std::uint32_t edge(std::uint32_t number) const {
    return static_cast<std::uint32_t>(fronts_.size() + backs_.size()) + number;
  }

  void add(std::uint32_t one, std::uint32_t rival) {
    if (rival != one) rivals_[one].push_back(rival);
  }

  /// Makes `rival` a rival of all the fronts and backs.
  void add_to_all(const Numbers& fronts, const Numbers& backs, std::uint32_t rival) {
    for (const std::uint32_t number : fronts) add(number, rival);
    for (const std::uint32_t number : backs) add(back(number), rival);
  }

  /// Collects the edges that are negative at some of the tile's pixels. Returns false if one edge is negative at all of
  /// them; that edge becomes a rival of all functions.
  bool find_edges(const PixelRect& tile, const Numbers& fronts, const Numbers& backs, const Numbers& edges,
                  Numbers& left) {
    for (const std::uint32_t number : edges) {
      const Range range = range_over(boundary_.edges[number], tile);
      if (range.high < 0) {
        add_to_all(fronts, backs, edge(number));
        return false;
      }
      if (range.low < 0) left.push_back(number);
    }
    return true;
  }

  void divide(const PixelRect& tile, const Numbers& of_fronts, const Numbers& of_backs, const Numbers& of_edges) {
    Numbers edges;
    if (!find_edges(tile, of_fronts, of_backs, of_edges, edges)) return;
    const Leading fronts =
        fronts_.leading(of_fronts, tile, [&](std::uint32_t number, std::uint32_t by) { add(number, by); });
    const Leading backs =
        backs_.leading(of_backs, tile, [&](std::uint32_t number, std::uint32_t by) { add(back(number), back(by)); });
    if (!fronts.numbers.empty() && !backs.numbers.empty() && is_nowhere(fronts.ranks, backs.ranks)) {
      add_to_all(fronts.numbers, backs.numbers, fronts.first);
      add_to_all(fronts.numbers, backs.numbers, back(backs.first));
      return;
    }
    if (fronts.numbers.size() + backs.numbers.size() + edges.size() <= few) {
      for (const std::uint32_t number : fronts.numbers) {
        add_to_all(fronts.numbers, backs.numbers, number);
        pixels_[number] = hull(pixels_[number], tile);
      }
      for (const std::uint32_t number : backs.numbers) {
        add_to_all(fronts.numbers, backs.numbers, back(number));
        pixels_[back(number)] = hull(pixels_[back(number)], tile);
      }
      for (const std::uint32_t number : edges) add_to_all(fronts.numbers, backs.numbers, edge(number));
      return;
    }
    for (const PixelRect& part : halves(tile)) divide(part, fronts.numbers, backs.numbers, edges);
  }

  /// Whether the ranks of a front and a back make the solid empty at each pixel of a tile.
  static bool is_nowhere(const Values& front, const Values& back) {
    return std::equal(front.begin(), front.begin() + corners, back.begin(),
                      [](std::int64_t begins, std::int64_t ends) { return begins >= -ends; });
  }

  [[nodiscard]] Rivals sorted(Numbers& numbers, const PixelRect& pixels) const {
    std::ranges::sort(numbers);
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    Rivals rivals;
    rivals.pixels = pixels;
    for (const std::uint32_t number : numbers) {
      if (number < back(0)) {
        rivals.fronts.push_back(number);
      } else if (number < edge(0)) {
        rivals.backs.push_back(number - back(0));
      } else {
        rivals.edges.push_back(number - edge(0));
      }
    }
    Numbers().swap(numbers);
    return rivals;
  }

  const Boundary& boundary_;
  Envelope fronts_;
  Envelope backs_;
  std::vector<Numbers> rivals_;
  std::vector<PixelRect> pixels_;
};

}  // namespace

AllRivals rivals(const Boundary& boundary, const PixelRect& pixels, unsigned shift) {
  return Finder(boundary, shift)(pixels);
}

}  // namespace csgsim::view
