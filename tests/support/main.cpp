#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>

#include "places.h"

int main(int argc, char** argv) {
  // Text is set in the fonts that its expected outlines were made with, here and in every process begun from here.
  ::setenv("FONTCONFIG_FILE", CSGSIM_BINARY_DIR "/tests/generated/test_fonts.conf", 1);
  doctest::Context context(argc, argv);
  return context.run();
}
