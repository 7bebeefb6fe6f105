#include "sim/software/work.h"

#include <memory>
#include <utility>

#include "hw/base/hash.h"
#include "hw/base/text.h"

namespace csgsim::software {

Work work_of(const Choice& choice, const Subject& subject, const RayCaster& rays) {
  Work work;
  const std::unique_ptr<Method> method = make_method(choice, subject, true);
  work.picture = draw(rays, *method, &work.rays);
  work.counts = method->counts();
  work.measured = measure_seconds(rays, [&] { return make_method(choice, subject, false); });
  switch (choice.method->takes) {
    case Takes::events: break;
    case Takes::intervals: work.rays.sorting = {}; break;
    case Takes::planes:
      work.rays = {};
      work.measured.rays = 0;
      break;
  }
  return work;
}

Priced load_priced(const std::string& name) {
  if (name == processors::this_computer) return {name, std::nullopt};
  processors::Processor processor = processors::load_processor(name);
  return {escaped(processor.name), std::move(processor)};
}

std::string hash_of(const Priced& processor) {
  Hash hash;
  hash.add(processor.name);
  if (processor.processor) {
    for (const machines::Figure& figure : processor.processor->figures) hash.add(figure.key + "=" + figure.value + ";");
  }
  return hash.text();
}

PricedSeconds seconds_of(const Operations& rays, const Operations& sorting, const Classifying& classification,
                         const Seconds& measured, const Priced& processor) {
  if (!processor.processor) return {measured.classification, measured.rays + measured.classification};
  Operations others = classification.operations;
  others -= classification.traversal;
  const double alone = processors::seconds(others, *processor.processor) +
                       processors::seconds(classification.traversal, *processor.processor, classification.compiled);
  return {alone,
          alone + processors::seconds(rays, *processor.processor) + processors::seconds(sorting, *processor.processor)};
}

}  // namespace csgsim::software
