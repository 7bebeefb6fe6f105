#include "tests/unit/flat/support.h"

#include <polyclipping/clipper.hpp>

#include "hw/base/text.h"
#include "places.h"
#include "tests/support/test.h"

namespace csgsim::flat {

namespace {

/// Finer than the resolution of host/flat.
constexpr double scale = 1 << 24;

ClipperLib::Path path_of(const Outline& outline) {
  ClipperLib::Path path;
  for (const glm::dvec2& corner : outline)
    path.emplace_back(std::llround(corner.x * scale), std::llround(corner.y * scale));
  return path;
}

ClipperLib::Paths paths_of(const Area& area) {
  ClipperLib::Paths paths;
  for (const Outline& outline : area.outlines) paths.push_back(path_of(outline));
  return paths;
}

bool holds(const ClipperLib::Path& outer, const ClipperLib::Path& inner) {
  for (const ClipperLib::IntPoint& corner : inner) {
    const int place = ClipperLib::PointInPolygon(corner, outer);
    if (place >= 0) return place == 1;
  }
  return false;
}

const std::string folder = CSGSIM_SOURCE_DIR "/tests/unit/flat/";

std::string contents(const std::string& file) {
  std::ifstream stream(folder + file, std::ios::binary);
  REQUIRE(stream);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

std::string mutate(std::string bytes, std::mt19937& random) {
  constexpr std::string_view alphabet = "0123456789.-+eE ,\"'<>/=&;()\nzZmMaALgGxXyY%\0\xff";
  const auto below = [&](std::size_t end) { return random() % end; };
  for (std::size_t left = 1 + below(8); left > 0 && !bytes.empty(); --left) {
    const std::size_t at = below(bytes.size());
    const std::size_t length = below(std::min<std::size_t>(bytes.size() - at, 40)) + 1;
    const std::size_t kind = below(4);
    if (kind == 0) bytes[at] = alphabet[below(alphabet.size())];
    if (kind == 1) bytes.erase(at, length);
    if (kind == 2) bytes.insert(below(bytes.size()), bytes.substr(at, length));
    if (kind == 3) bytes.insert(at, 1, alphabet[below(alphabet.size())]);
  }
  return bytes;
}

/// Possible change of the area when OpenSCAD writes its corners with six digits: each is off by at most half a unit of
/// the last digit in both directions.
double rounding(const Area& area) {
  double around = 0;
  double largest = 0;
  for (const Outline& outline : area.outlines) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const glm::dvec2 side = outline[(i + 1) % outline.size()] - outline[i];
      around += std::hypot(side.x, side.y);
      largest = std::max({largest, std::abs(outline[i].x), std::abs(outline[i].y)});
    }
  }
  const double unit = std::pow(10, std::ceil(std::log10(largest)) - 6);
  return around * unit / std::numbers::sqrt2;
}

}  // namespace

std::string drawing(const std::string& name) { return contents("drawings/" + name); }

void check_mutations(const std::string& extension, const std::function<void(const std::string&)>& read) {
  constexpr int rounds = 400;
  std::mt19937 random(1);
  for (const auto& entry : std::filesystem::directory_iterator(folder + "drawings")) {
    if (entry.path().extension() != extension) continue;
    const std::string original = drawing(entry.path().filename());
    for (int i = 0; i < rounds; ++i) {
      const std::string mutated = mutate(original, random);
      CAPTURE(mutated);
      try {
        read(mutated);
      } catch (const InputError& error) {
        CHECK(printable(error.what()) == error.what());
      }
    }
  }
}

Area openscad(const std::string& name) {
  const std::string all = contents("openscad/" + name + ".svg");
  const std::size_t start = all.find("<path d=\"");
  Area area;
  if (start == std::string::npos) return area;
  std::istringstream words(all.substr(start + 9, all.find('"', start + 9) - start - 9));
  for (std::string word; words >> word;) {
    if (word == "z") continue;
    if (word == "M") area.outlines.emplace_back();
    glm::dvec2 corner;
    char comma = 0;
    words >> corner.x >> comma >> corner.y;
    REQUIRE(!words.fail());
    area.outlines.back().emplace_back(corner.x, -corner.y);
  }
  return area;
}

double signed_area(const Outline& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2& a = outline[i];
    const glm::dvec2& b = outline[(i + 1) % outline.size()];
    twice += a.x * b.y - a.y * b.x;
  }
  return twice / 2;
}

double area_of(const Area& area) {
  double sum = 0;
  for (const Outline& outline : area.outlines) sum += signed_area(outline);
  return sum;
}

std::size_t corners(const Area& area) {
  std::size_t count = 0;
  for (const Outline& outline : area.outlines) count += outline.size();
  return count;
}

double difference(const Area& a, const Area& b) {
  ClipperLib::Clipper clipper;
  clipper.AddPaths(paths_of(a), ClipperLib::ptSubject, true);
  clipper.AddPaths(paths_of(b), ClipperLib::ptClip, true);
  ClipperLib::Paths result;
  REQUIRE(clipper.Execute(ClipperLib::ctXor, result, ClipperLib::pftEvenOdd, ClipperLib::pftEvenOdd));
  double sum = 0;
  for (const ClipperLib::Path& path : result) sum += ClipperLib::Area(path);
  return std::abs(sum) / (scale * scale);
}

void check_matches_openscad(const Area& area, const std::string& name) {
  check_area_matches_openscad(area, name);
  CAPTURE(name);
  CHECK(corners(area) == corners(openscad(name)));
}

void check_area_matches_openscad(const Area& area, const std::string& name) {
  CAPTURE(name);
  const Area expected = openscad(name);
  CHECK(area.outlines.size() == expected.outlines.size());
  CHECK(difference(area, expected) <= rounding(expected));
  check_orientation(area);
}

void check_orientation(const Area& area) {
  const ClipperLib::Paths paths = paths_of(area);
  for (std::size_t i = 0; i < paths.size(); ++i) {
    std::size_t depth = 0;
    for (std::size_t j = 0; j < paths.size(); ++j) depth += i != j && holds(paths[j], paths[i]) ? 1U : 0U;
    CHECK((signed_area(area.outlines[i]) > 0) == (depth % 2 == 0));
  }
}

}  // namespace csgsim::flat
