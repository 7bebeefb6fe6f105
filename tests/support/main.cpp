#define DOCTEST_CONFIG_IMPLEMENT
#include <doctest/doctest.h>

#include <cstdlib>

#include "places.h"
#include "tests/support/properties.h"

namespace {

/// Reports the current test case to the property streams.
struct CaseNames : doctest::IReporter {
  explicit CaseNames(const doctest::ContextOptions&) {}
  void report_query(const doctest::QueryData&) override {}
  void test_run_start() override {}
  void test_run_end(const doctest::TestRunStats&) override {}
  void test_case_start(const doctest::TestCaseData& begun) override { csgsim::testing::begin_case(begun.m_name); }
  void test_case_reenter(const doctest::TestCaseData&) override {}
  void test_case_end(const doctest::CurrentTestCaseStats&) override {}
  void test_case_exception(const doctest::TestCaseException&) override {}
  void subcase_start(const doctest::SubcaseSignature&) override {}
  void subcase_end() override {}
  void log_assert(const doctest::AssertData&) override {}
  void log_message(const doctest::MessageData&) override {}
  void test_case_skipped(const doctest::TestCaseData&) override {}
};

REGISTER_LISTENER("case names", 0, CaseNames);

}  // namespace

int main(int argc, char** argv) {
  // Text uses the fonts with which the expected outlines were made, in this process and in all its children.
  ::setenv("FONTCONFIG_FILE", CSGSIM_BINARY_DIR "/tests/generated/test_fonts.conf", 1);
  csgsim::testing::add_parameters();
  doctest::Context context(argc, argv);
  return context.run();
}
