#include "hw/machines/catalogue.h"
#include "hw/processors/built_in.h"
#include "hw/processors/processor.h"

namespace csgsim::processors {

namespace {

machines::Catalogue<Processor> catalogue() { return {"processor", built_in_processors(), read_processor}; }

}  // namespace

std::vector<std::string_view> processor_names() { return catalogue().names(); }

Processor load_processor(const std::string& spec) { return catalogue().load(spec); }

}  // namespace csgsim::processors
