# Build dependencies of csgsim's libraries. What is missing is reported at the end, all at once.
include(cmake/missing.cmake)

option(CSGSIM_TEXT "Build the module that sets text(), with Fontconfig, FreeType and HarfBuzz" ON)
option(CSGSIM_PICTURES "Build the module of picture formats other than PNG, with OpenImageIO" ON)
option(CSGSIM_VIEWER "Build the server of csgsim view" ON)
option(CSGSIM_CONVERT "Build csgsim convert, with minizip" ON)

# Boost's own CMake package instead of CMake's module.
if(POLICY CMP0167)
  cmake_policy(SET CMP0167 NEW)
endif()

# csgsim_find(NEED PACKAGE): find_package, which records a missing package.
macro(csgsim_find need package)
  find_package(${package} QUIET)
  csgsim_require(${need} "${${package}_FOUND}")
endmacro()

# csgsim_find_module(NEED PREFIX MODULE [OPTION OPTION]): the same with pkg-config.
macro(csgsim_find_module need prefix module)
  if(PKG_CONFIG_FOUND)
    pkg_check_modules(${prefix} QUIET IMPORTED_TARGET GLOBAL ${module})
  endif()
  csgsim_require(${need} "${${prefix}_FOUND}" ${ARGN})
endmacro()

csgsim_find(GLM glm)
csgsim_find(PEGTL pegtl)
csgsim_find(toml++ tomlplusplus)
csgsim_find(nlohmann-json nlohmann_json)
csgsim_find(fmt fmt)
csgsim_find(Highway hwy)
csgsim_find(Boost Boost)
find_package(Threads REQUIRED)
csgsim_find(libpng PNG)
csgsim_find(zlib ZLIB)
csgsim_find(pkg-config PkgConfig)

# Needed by 2-D shapes and meshes.
csgsim_find_module(Clipper polyclipping polyclipping)
csgsim_find(pugixml pugixml)
find_path(CGAL_INCLUDE_DIR CGAL/version.h)
csgsim_require(CGAL "${CGAL_INCLUDE_DIR}")

# Needed by the module of picture formats. Debian's CMake package of OpenImageIO requires its command-line tools and Python
# modules; pkg-config does not.
if(CSGSIM_PICTURES)
  csgsim_find_module(OpenImageIO OpenImageIO OpenImageIO OPTION CSGSIM_PICTURES)
endif()

# Needed by zipped meshes; preferably a static library, which adds nothing to the start-up time.
if(CSGSIM_CONVERT)
  find_library(CSGSIM_MINIZIP NAMES libminizip.a minizip)
  find_path(CSGSIM_MINIZIP_INCLUDE_DIR minizip/zip.h)
  csgsim_require(minizip "${CSGSIM_MINIZIP}" OPTION CSGSIM_CONVERT)
  csgsim_require(minizip "${CSGSIM_MINIZIP_INCLUDE_DIR}" OPTION CSGSIM_CONVERT)
endif()

# Needed by the module of text.
if(CSGSIM_TEXT)
  csgsim_find_module(Fontconfig fontconfig fontconfig OPTION CSGSIM_TEXT)
  csgsim_find_module(FreeType freetype freetype2 OPTION CSGSIM_TEXT)
  csgsim_find_module(HarfBuzz harfbuzz harfbuzz OPTION CSGSIM_TEXT)
endif()

# Debian's SystemC has no CMake package.
find_library(SYSTEMC_LIBRARY systemc)
find_path(SYSTEMC_INCLUDE_DIR systemc)
csgsim_require(SystemC "${SYSTEMC_LIBRARY}")
csgsim_require(SystemC "${SYSTEMC_INCLUDE_DIR}")

# Needed by the command line.
csgsim_find(CLI11 CLI11)
csgsim_find_module(libedit libedit libedit)

include(cmake/python.cmake)
csgsim_report_missing()

# Version numbers for csgsim --version. The pkg-config files of Clipper and freetype lack them.
file(STRINGS ${SYSTEMC_INCLUDE_DIR}/sysc/kernel/sc_ver.h systemc_numbers REGEX "#define SC_VERSION_(MAJOR|MINOR|PATCH) ")
string(REGEX REPLACE "[^0-9]*([0-9]+);[^0-9]*([0-9]+);[^0-9]*([0-9]+).*" "\\1.\\2.\\3" SYSTEMC_VERSION "${systemc_numbers}")
file(STRINGS ${polyclipping_INCLUDEDIR}/clipper.hpp CLIPPER_VERSION REGEX "#define CLIPPER_VERSION ")
string(REGEX REPLACE ".*\"(.*)\".*" "\\1" CLIPPER_VERSION "${CLIPPER_VERSION}")
set(built_with "SystemC ${SYSTEMC_VERSION}")
if(CSGSIM_PICTURES)
  list(APPEND built_with "OpenImageIO ${OpenImageIO_VERSION}")
endif()
list(APPEND built_with "libpng ${PNG_VERSION_STRING}" "zlib ${ZLIB_VERSION_STRING}")
if(CSGSIM_TEXT)
  list(APPEND built_with "HarfBuzz ${harfbuzz_VERSION}" "Fontconfig ${fontconfig_VERSION}")
endif()
list(APPEND built_with "Clipper ${CLIPPER_VERSION}" "pugixml ${pugixml_VERSION}" "GLM ${glm_VERSION}" "Highway ${hwy_VERSION}"
  "Boost ${Boost_VERSION}" "PEGTL ${pegtl_VERSION}" "toml++ ${tomlplusplus_VERSION}"
  "nlohmann-json ${nlohmann_json_VERSION}" "fmt ${fmt_VERSION}" "CLI11 ${CLI11_VERSION}" "libedit ${libedit_VERSION}")
list(JOIN built_with ", " CSGSIM_BUILT_WITH)
