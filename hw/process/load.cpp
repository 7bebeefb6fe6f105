#include "hw/machines/catalogue.h"
#include "hw/process/built_in.h"
#include "hw/process/process.h"

namespace csgsim::process {

namespace {

machines::Catalogue<Process> catalogue() { return {"process", built_in_processes(), read_process}; }

}  // namespace

std::vector<std::string_view> process_names() { return catalogue().names(); }

Process load_process(const std::string& spec) { return catalogue().load(spec); }

}  // namespace csgsim::process
