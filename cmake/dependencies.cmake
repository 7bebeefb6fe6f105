# Build dependencies of csgsim's libraries.
find_package(glm REQUIRED)
find_package(pegtl REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(hwy REQUIRED)
find_package(Boost REQUIRED)
find_package(Threads REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)

# Needed by the module of picture formats. Debian's CMake package of OpenImageIO requires its command-line tools and Python
# modules; pkg-config does not.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO)

# Needed by 2-D shapes and meshes.
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET GLOBAL polyclipping)
find_package(pugixml REQUIRED)

# Needed by zipped meshes; a static library, which adds nothing to the start-up time.
find_library(CSGSIM_MINIZIP libminizip.a REQUIRED)

# Needed by the module of text.
pkg_check_modules(fontconfig REQUIRED IMPORTED_TARGET GLOBAL fontconfig)
pkg_check_modules(freetype REQUIRED IMPORTED_TARGET GLOBAL freetype2)
pkg_check_modules(harfbuzz REQUIRED IMPORTED_TARGET GLOBAL harfbuzz)

# Debian's SystemC has no CMake package.
find_library(SYSTEMC_LIBRARY systemc REQUIRED)
find_path(SYSTEMC_INCLUDE_DIR systemc REQUIRED)

# Needed by the command line.
find_package(CLI11 REQUIRED)
pkg_check_modules(libedit REQUIRED IMPORTED_TARGET libedit)

# Version numbers for csgsim --version. The pkg-config files of Clipper and freetype lack them.
file(STRINGS ${SYSTEMC_INCLUDE_DIR}/sysc/kernel/sc_ver.h systemc_numbers REGEX "#define SC_VERSION_(MAJOR|MINOR|PATCH) ")
string(REGEX REPLACE "[^0-9]*([0-9]+);[^0-9]*([0-9]+);[^0-9]*([0-9]+).*" "\\1.\\2.\\3" SYSTEMC_VERSION "${systemc_numbers}")
file(STRINGS ${polyclipping_INCLUDEDIR}/clipper.hpp CLIPPER_VERSION REGEX "#define CLIPPER_VERSION ")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" CLIPPER_VERSION "${CLIPPER_VERSION}")
string(JOIN ", " CSGSIM_BUILT_WITH
  "SystemC ${SYSTEMC_VERSION}" "OpenImageIO ${OpenImageIO_VERSION}" "libpng ${PNG_VERSION_STRING}" "zlib ${ZLIB_VERSION_STRING}"
  "HarfBuzz ${harfbuzz_VERSION}" "Fontconfig ${fontconfig_VERSION}" "Clipper ${CLIPPER_VERSION}" "pugixml ${pugixml_VERSION}"
  "GLM ${glm_VERSION}" "Highway ${hwy_VERSION}" "Boost ${Boost_VERSION}" "PEGTL ${pegtl_VERSION}" "toml++ ${tomlplusplus_VERSION}"
  "nlohmann-json ${nlohmann_json_VERSION}" "fmt ${fmt_VERSION}" "CLI11 ${CLI11_VERSION}" "libedit ${libedit_VERSION}")
