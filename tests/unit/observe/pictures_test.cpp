#include "sim/observe/pictures.h"

#include <OpenImageIO/imageio.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "hw/isa/facts.h"
#include "places.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// A file that is deleted in the destructor.
class Scratch {
 public:
  explicit Scratch(const std::string& extension)
      : path_(fs::path(CSGSIM_BINARY_DIR) / ("pictures_test_" + std::to_string(::getpid()) + extension)) {}
  ~Scratch() { fs::remove(path_); }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A picture of 3 x 2 pixels with depths from 10 to 62 in steps of 1, 6 bits of depth and 6 of colour.
isa::Program program() {
  isa::Program program;
  program.shape = {3, 2, 12};
  program.colour = {6, 6};
  program.facts->fields = {{"Z2", {0, 6}, isa::FieldRole::depth}, {"colour", {6, 6}, isa::FieldRole::colour}};
  program.facts->depth_scale = {false, 10, 70};
  return program;
}

observe::Frame frame() {
  return {3,
          2,
          {0b000000, 0b110000, 0b001100, 0b000011, 0b111111, 0b010101},
          {0, 1, 2, 61, 62, 63},
          {0, 1, 2, 70'000, observe::no_owner, 5}};
}

template <class Value>
struct Picture {
  std::vector<Value> values;
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
};

template <class Value>
Picture<Value> read(const fs::path& path, OIIO::TypeDesc type) {
  const auto input = OIIO::ImageInput::open(path.native());
  REQUIRE(input);
  const OIIO::ImageSpec& spec = input->spec();
  CHECK(spec.x == 0);
  CHECK(spec.y == 0);
  Picture<Value> picture{{}, spec.width, spec.height, spec.channelnames};
  picture.values.resize(static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height) *
                        static_cast<std::size_t>(spec.nchannels));
  REQUIRE(input->read_image(0, 0, 0, spec.nchannels, type, picture.values.data()));
  return picture;
}

template <class Write>
void write_to(const fs::path& path, const Write& write) {
  OutputFile file(path);
  write(file);
  file.commit();
}

}  // namespace

TEST_CASE("a picture has each pixel's colour at its place in eight bits per channel") {
  const Scratch scratch(".png");
  write_to(scratch.path(), [](OutputFile& file) { observe::write_picture(file, frame(), program()); });
  const auto picture = read<std::uint8_t>(scratch.path(), OIIO::TypeDesc::UINT8);
  CHECK(picture.width == 3);
  CHECK(picture.height == 2);
  CHECK(picture.values == std::vector<std::uint8_t>{0, 0, 0, 255, 0, 0, 0, 255, 0,  //
                                                    0, 0, 255, 255, 255, 255, 85, 85, 85});
}

TEST_CASE("a grey picture has each pixel's grey at its place") {
  for (const char* const extension : {".png", ".tif"}) {
    CAPTURE(extension);
    const Scratch scratch(extension);
    const std::vector<std::uint8_t> bytes{0, 1, 127, 128, 254, 255};
    write_to(scratch.path(), [&](OutputFile& file) { observe::write_picture(file, observe::Picture{2, 3, 1, bytes}); });
    const auto picture = read<std::uint8_t>(scratch.path(), OIIO::TypeDesc::UINT8);
    CHECK(picture.width == 2);
    CHECK(picture.height == 3);
    CHECK(picture.channels.size() == 1);
    CHECK(picture.values == bytes);
  }
}

TEST_CASE("a picture of noise of any width survives a PNG round trip") {
  for (const std::uint32_t width : {1U, 2U, 7U, 640U, 5000U}) {
    CAPTURE(width);
    std::mt19937 random(width);
    observe::Picture noise{width, 17, 3, {}};
    for (std::uint32_t i = 0; i < width * 17 * 3; ++i) noise.bytes.push_back(static_cast<std::uint8_t>(random()));
    const Scratch scratch(".png");
    write_to(scratch.path(), [&](OutputFile& file) { observe::write_picture(file, noise); });
    const auto picture = read<std::uint8_t>(scratch.path(), OIIO::TypeDesc::UINT8);
    CHECK(picture.width == static_cast<int>(width));
    CHECK(picture.values == noise.bytes);
  }
}

TEST_CASE("a PNG too wide for its readers is rejected") {
  const Scratch scratch(".png");
  OutputFile file(scratch.path());
  const observe::Picture wide{2'000'000, 1, 1, std::vector<std::uint8_t>(2'000'000)};
  CHECK_THROWS_WITH_AS(observe::write_picture(file, wide), doctest::Contains(": cannot be written: "), InputError);
}

TEST_CASE("a depth picture has distances in model units and infinity for the background") {
  const Scratch scratch(".exr");
  write_to(scratch.path(), [](OutputFile& file) { observe::write_depth(file, frame(), program()); });
  const auto picture = read<float>(scratch.path(), OIIO::TypeDesc::FLOAT);
  CHECK(picture.channels == std::vector<std::string>{"Z"});
  REQUIRE(picture.values.size() == 6);
  CHECK(picture.values[0] == 9.0F);   // the near cap, one step before the near plane
  CHECK(picture.values[1] == 10.0F);  // the near plane
  CHECK(picture.values[2] == 11.0F);
  CHECK(picture.values[3] == 70.0F);  // the far plane
  CHECK(std::isinf(picture.values[5]));
}

TEST_CASE("an owner picture has primitive numbers and -1 for the background") {
  const Scratch scratch(".exr");
  write_to(scratch.path(), [](OutputFile& file) { observe::write_owner(file, frame()); });
  const auto picture = read<float>(scratch.path(), OIIO::TypeDesc::FLOAT);
  CHECK(picture.channels == std::vector<std::string>{"owner"});
  CHECK(picture.values == std::vector<float>{0, 1, 2, 70'000, -1, 5});
}

TEST_CASE("owner colours are distinct and none is that of the background") {
  // Bits of index + 1, lowest first, become the highest bits of red, green and blue.
  CHECK(observe::owner_colour(observe::no_owner) == std::array<std::uint8_t, 3>{0, 0, 0});
  CHECK(observe::owner_colour(0) == std::array<std::uint8_t, 3>{128, 0, 0});
  CHECK(observe::owner_colour(1) == std::array<std::uint8_t, 3>{0, 128, 0});
  CHECK(observe::owner_colour(2) == std::array<std::uint8_t, 3>{128, 128, 0});
  CHECK(observe::owner_colour(7) == std::array<std::uint8_t, 3>{64, 0, 0});
  std::set<std::array<std::uint8_t, 3>> colours{observe::owner_colour(observe::no_owner)};
  for (std::uint32_t i = 0; i < 100'000; ++i) colours.insert(observe::owner_colour(i));
  CHECK(colours.size() == 100'001);
}

TEST_CASE("an owner picture for ordinary tools has the colours of its legend") {
  const Scratch scratch(".png");
  const Scratch beside(".json");
  isa::Program named = program();
  named.facts->primitives = {"cube@1:1", "ball", "cube@3:1"};
  observe::Frame seen = frame();
  seen.owner = {0, 1, 1, 2, observe::no_owner, 1};
  write_to(scratch.path(), [&](OutputFile& file) { observe::write_owner(file, seen); });
  write_to(beside.path(), [&](OutputFile& file) { observe::write_legend(file, seen, named); });
  const auto picture = read<std::uint8_t>(scratch.path(), OIIO::TypeDesc::UINT8);
  CHECK(picture.values == std::vector<std::uint8_t>{128, 0, 0, 0, 128, 0, 0, 128, 0,  //
                                                    128, 128, 0, 0, 0, 0, 0, 128, 0});
  std::ifstream file(beside.path());
  const nlohmann::json legend = nlohmann::json::parse(file);
  CHECK(legend["nothing"] == nlohmann::json{{"colour", "#000000"}, {"pixels", 1}});
  REQUIRE(legend["primitives"].size() == 3);
  CHECK(legend["primitives"][1] ==
        nlohmann::json{{"index", 1}, {"name", "ball"}, {"colour", "#008000"}, {"pixels", 3}});
}

TEST_CASE("a picture name without a known format is rejected with a list of formats") {
  CHECK_NOTHROW(observe::check_format("a.png"));
  // Includes formats that only a loaded module may support.
  for (const char* const name : {"a.exr", "a.tif", "a.jpg", "a.ppm", "a.EXR", "a.sgi"}) {
    CAPTURE(name);
    CHECK_NOTHROW(observe::check_format(name));
    CHECK_NOTHROW(observe::check_depth_format(name));
  }
  for (const char* const name : {"a.xyz", "a", "a.null", "a.term"}) {
    CAPTURE(name);
    CHECK_THROWS_WITH_AS(
        observe::check_format(name),
        (std::string(name) +
         ": unknown picture format; end the name in .png, .tif, .ppm, .exr or another extension of pictures")
            .c_str(),
        InputError);
  }
}
