# What csgsim's libraries are built with.
find_package(glm REQUIRED)
find_package(pegtl REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(fmt REQUIRED)
find_package(hwy REQUIRED)
find_package(Boost REQUIRED)
find_package(Threads REQUIRED)

# Debian's CMake package of OpenImageIO asks for its command line tools and Python modules; pkg-config does not.
find_package(PkgConfig REQUIRED)
pkg_check_modules(OpenImageIO REQUIRED IMPORTED_TARGET GLOBAL OpenImageIO)

# Debian's SystemC has no CMake package.
find_library(SYSTEMC_LIBRARY systemc REQUIRED)
find_path(SYSTEMC_INCLUDE_DIR systemc REQUIRED)

# And the command line.
find_package(CLI11 REQUIRED)
