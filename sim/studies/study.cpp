#include "sim/studies/study.h"

#include "sim/report/page.h"
#include "sim/session/options/lists.h"

namespace csgsim::studies {

PageSubject subject_on(const session::ModelRequest& model, const std::string& machines) {
  PageSubject subject{model, {}};
  for (const std::string& name : session::parse_words(machines)) {
    subject.model.machine = name;
    subject.machines.push_back(session::machine_of(subject.model));
  }
  return subject;
}

report::Json Study::page_data(report::Json file) const { return file; }

std::vector<report::Section> Study::sections(const report::Json& /*data*/) const { return {}; }

}  // namespace csgsim::studies
