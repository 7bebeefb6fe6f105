#include "tests/numerics/variants.h"

#include "hw/pixel_square/kind.h"
#include "hw/scan_line/kind.h"

namespace csgsim::testing {

namespace {

emit::Options with_strategy(emit::Strategy strategy, unsigned stack_bits = emit::min_stack_bits) {
  emit::Options options;
  options.strategy = strategy;
  options.stack_bits = stack_bits;
  return options;
}

/// Weighed prices, from a host for which every test is worth its time to one for which none is.
std::vector<csg::Prices> weighed_prices() {
  std::vector<csg::Prices> all;
  for (const double of_host : {0.0, 10.0, 100.0, 1e6}) {
    all.push_back({.are_weighed = true,
                   .box = of_host,
                   .test = 5 * of_host,
                   .value = of_host / 3,
                   .support = 6 * of_host,
                   .instruction = 1000});
  }
  return all;
}

}  // namespace

std::vector<emit::Options> all_options() {
  using emit::Strategy;
  std::vector<emit::Options> all{with_strategy(Strategy::automatic)};
  for (const Strategy strategy : emit::default_strategies()) all.push_back(with_strategy(strategy));
  for (const unsigned bits : {4U, 5U, 6U, 7U, 9U}) all.push_back(with_strategy(Strategy::bits, bits));
  for (const Strategy strategy : emit::default_strategies()) {
    if (strategy == Strategy::products) continue;
    for (const emit::Colouring colouring : {emit::Colouring::field, emit::Colouring::automatic}) {
      all.push_back(with_strategy(strategy, 5));
      all.back().colouring = colouring;
    }
    all.push_back(with_strategy(strategy, 4));
    all.back().pruning = csg::Pruning::none();
  }
  for (const emit::Strategy strategy : {Strategy::list, Strategy::bits, Strategy::products, Strategy::stored}) {
    for (const emit::Colouring colouring : {emit::Colouring::field, emit::Colouring::rebroadcast}) {
      all.push_back(with_strategy(strategy));
      all.back().colouring = colouring;
      all.back().pruning.early_out = false;
    }
  }
  for (bool csg::Pruning::*const switched : {&csg::Pruning::space, &csg::Pruning::picture, &csg::Pruning::separation,
                                             &csg::Pruning::halfspaces, &csg::Pruning::hidden, &csg::Pruning::sets,
                                             &csg::Pruning::early_out, &csg::Pruning::near, &csg::Pruning::pixels}) {
    for (const Strategy strategy : {Strategy::stack, Strategy::stored}) {
      all.push_back(with_strategy(strategy));
      all.back().pruning.*switched = false;
    }
    all.push_back(with_strategy(Strategy::stack));
    all.back().pruning = csg::Pruning::none();
    all.back().pruning.*switched = true;
  }
  for (const emit::Colouring colouring : {emit::Colouring::field, emit::Colouring::rebroadcast}) {
    all.push_back(with_strategy(Strategy::stack));
    all.back().colouring = colouring;
    all.back().pruning = csg::Pruning::divider();
  }
  for (const csg::Prices& prices : weighed_prices()) {
    for (const Strategy strategy : {Strategy::stack, Strategy::products}) {
      all.push_back(with_strategy(strategy));
      all.back().prices = prices;
    }
  }
  return all;
}

std::vector<Setup> setups_in_parts(Setup setup) {
  std::vector<Setup> all;
  setup.kind = &scan_line::kind;
  all.push_back(setup);
  setup.kind = &pixel_square::kind;
  for (const machines::Size& square : {machines::Size{8, 8}, machines::Size{16, 16}, machines::Size{7, 3}}) {
    setup.square = square;
    setup.options = with_strategy(emit::Strategy::stack);
    all.push_back(setup);
    setup.options = with_strategy(emit::Strategy::list);
    setup.options.colouring = emit::Colouring::field;
    all.push_back(setup);
  }
  setup.options = with_strategy(emit::Strategy::stored);
  all.push_back(setup);
  all.push_back(setup);
  all.back().kind = &scan_line::kind;
  all.back().square = {};
  setup.options = with_strategy(emit::Strategy::bits, 4);
  setup.options.pruning = csg::Pruning::none();
  all.push_back(setup);
  setup.options = with_strategy(emit::Strategy::stack);
  for (const csg::Prices& prices : weighed_prices()) {
    setup.options.prices = prices;
    all.push_back(setup);
  }
  return all;
}

std::vector<Setup> setups_on_quadratic_machines(Setup setup) {
  std::vector<Setup> all;
  for (const char* machine : {"pixel-powers", "pixel-planes-5", "pixel-square+divider.kind=host"}) {
    setup.machine = machine;
    all.push_back(setup);
  }
  setup.machine = "pixel-powers+array.memory_bits=2048";
  setup.options = with_strategy(emit::Strategy::stored);
  all.push_back(setup);
  return all;
}

}  // namespace csgsim::testing
