#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

struct Mask {
  int width = 0;
  int height = 0;
  std::vector<bool> seen;

  [[nodiscard]] bool at(int x, int y) const {
    return x >= 0 && y >= 0 && x < width && y < height && seen[static_cast<std::size_t>(y * width + x)];
  }

  /// Whether a neighbour of the pixel has another value.
  [[nodiscard]] bool is_edge(int x, int y) const {
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx)
        if (at(x + dx, y + dy) != at(x, y)) return true;
    return false;
  }
};

/// Reads a plain PBM.
Mask mask_of_pbm(const std::string& path) {
  std::ifstream file(path);
  Mask mask;
  std::string kind;
  file >> kind >> mask.width >> mask.height;
  for (char bit = 0; file >> bit;) mask.seen.push_back(bit == '1');
  REQUIRE(mask.seen.size() == static_cast<std::size_t>(mask.width * mask.height));
  return mask;
}

using Colour = std::array<std::uint8_t, 3>;

/// Reads the pixels of a binary PPM.
std::vector<Colour> pixels_of(const std::string& ppm) {
  std::istringstream header(ppm);
  std::string kind;
  std::size_t width = 0;
  std::size_t height = 0;
  header >> kind >> width >> height;
  std::vector<Colour> pixels(width * height);
  const std::size_t begin = ppm.size() - pixels.size() * 3;
  for (std::size_t i = 0; i < pixels.size() * 3; ++i) pixels[i / 3][i % 3] = static_cast<std::uint8_t>(ppm[begin + i]);
  return pixels;
}

std::vector<Colour> drawn(const std::string& words) {
  const Folder folder;
  require_success(run("render " + words + " -o " + (folder / "p.ppm")));
  return pixels_of(content(folder / "p.ppm"));
}

const std::string cameras = std::string(CSGSIM_SOURCE_DIR) + "/tests/cli/cameras/";

}  // namespace

TEST_CASE("a camera of six or seven numbers matches OpenSCAD except on the outline") {
  std::ifstream list(cameras + "cameras.txt");
  int count = 0;
  for (std::string name, projection, camera; list >> name >> projection >> camera; ++count) {
    CAPTURE(name);
    const Mask theirs = mask_of_pbm(cameras + name + ".pbm");
    const std::vector<Colour> pixels = drawn(cameras + "part.csg --imgsize 100,75 --camera=" + camera +
                                             " --projection " + projection + " --colour-scheme Nature");
    REQUIRE(pixels.size() == theirs.seen.size());
    int differing = 0;
    int covered = 0;
    for (int y = 0; y < theirs.height; ++y) {
      for (int x = 0; x < theirs.width; ++x) {
        const bool ours = pixels[static_cast<std::size_t>(y * theirs.width + x)] != Colour{0xfa, 0xfa, 0xfa};
        covered += ours ? 1 : 0;
        if (ours == theirs.at(x, y)) continue;
        ++differing;
        CHECK(theirs.is_edge(x, y));
      }
    }
    CHECK(covered > 300);
    CHECK(differing * 50 <= covered);  // 2 % at most
  }
  CHECK(count == 10);
}

TEST_CASE("render accepts OpenSCAD's forms of --projection and --size and --viewall") {
  const std::string part = cameras + "part.csg ";
  CHECK(drawn(part + "--size 40x30 --projection p") == drawn(part + "--imgsize 40,30 --projection perspective"));
  CHECK(drawn(part + "--size 40x30 --projection o") == drawn(part + "--size 40x30"));
  CHECK(drawn(part + "--size 40x30 --projection o") != drawn(part + "--size 40x30 --projection p"));
  CHECK(drawn(part + "--size 40x30 --viewall") == drawn(part + "--size 40x30 --view-all"));
  check_misuse("render " + part + "--camera 1,2,3,4,5", "ex,ey,ez,cx,cy,cz or x,y,z,rx,ry,rz,d");
  check_misuse("render " + part + "--camera 1,2,3,4,5,6,7,8", "ex,ey,ez,cx,cy,cz or x,y,z,rx,ry,rz,d");
}

TEST_CASE("a turned camera of seven numbers keeps its roll from frame to frame") {
  const Folder folder;
  const std::string part = "render " + cameras + "part.csg --size 40x30 --camera=";
  require_success(run(part + "0,0,5,70,30,210,100 --frames 2 --orbit 50 -o " + (folder / "f.png")));
  require_success(run(part + "0,0,5,70,30,235,100 -o " + (folder / "p.png")));
  CHECK(content(folder / "f_001.png") == content(folder / "p.png"));
}

TEST_CASE("a colour scheme has OpenSCAD's colours of background and uncoloured faces") {
  const std::string part = cameras + "part.csg --size 40x30 ";
  CHECK(drawn(part + "--colour-scheme Cornfield") == drawn(part));
  const std::vector<Colour> night = drawn(part + "--colorscheme 'Tomorrow Night'");
  CHECK(night.front() == Colour{0x1d, 0x1f, 0x21});
  // A face perpendicular to the light shows its colour unchanged: white light of 0.3 and 0.7 on #16a085.
  const Folder folder;
  write(folder / "s.toml",
        "[ambient]\nintensity = 1\n[[lights]]\nkind = \"directional\"\ndirection = [0, 0, -1]\nintensity = 0\n");
  const std::string flat = part + "--scene " + (folder / "s.toml") + " --colour-scheme ";
  const auto has = [](const std::vector<Colour>& pixels, const Colour& colour) {
    return std::find(pixels.begin(), pixels.end(), colour) != pixels.end();
  };
  CHECK(has(drawn(flat + "Nature"), {0x16, 0xa0, 0x85}));
  CHECK(has(drawn(flat + "Nature"), {0xdb, 0xf4, 0xda}));
  CHECK(has(drawn(flat + "Starnight"), {0xff, 0xff, 0xe0}));
  CHECK(drawn(flat + "Starnight").front() == Colour{0, 0, 0});
}
