#include "sim/studies/study.h"

#include "sim/report/page.h"
#include "sim/session/options/lists.h"
#include "sim/session/options/numbers.h"

namespace csgsim::studies {

PageSubject page_subject_on_machines(const session::ModelRequest& model, const std::string& machines) {
  PageSubject subject{model, {}};
  for (const std::string& name : session::parse_words(machines)) {
    subject.model.machine = name;
    subject.machines.push_back(session::machine_of(subject.model));
  }
  return subject;
}

PageSubject page_subject_of_models(const std::vector<std::string>& models, const session::ModelRequest& view,
                                   const std::string& machines) {
  PageSubject subject = page_subject_on_machines(view, machines);
  subject.model.model = models.front();
  if (models.size() > 1) subject.name = session::count_text(models.size(), "model");
  return subject;
}

report::Json Study::page_data(report::Json file) const { return file; }

std::vector<report::Section> Study::sections(const report::Json& /*data*/) const { return {}; }

}  // namespace csgsim::studies
