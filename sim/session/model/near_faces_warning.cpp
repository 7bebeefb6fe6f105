#include "sim/session/model/near_faces_warning.h"

#include <fmt/format.h>

#include "host/convex/near_faces.h"
#include "hw/base/messages.h"

namespace csgsim::session {

void warn_of_near_faces(const CompiledModel& model, const ModelRequest& request) {
  const convex::NearFaces found = convex::near_faces(model.tree, model.scene);
  if (found.pairs == 0) return;
  const std::string others =
      found.pairs == 1 && !found.is_incomplete
          ? ""
          : fmt::format(" ({}{} more such pairs)", found.is_incomplete ? "at least " : "", found.pairs - 1);
  report_line(
      fmt::format("{}: warning: one of its faces and one of {} are nearly, but not exactly, coplanar{}; specks or a "
                  "thin skin may be "
                  "visible: {}let one solid reach well into the other",
                  model::place_of(model.tree, found.first[0]), model::place_of(model.tree, found.first[1]), others,
                  request.snap ? "" : "use --snap, or "));
}

}  // namespace csgsim::session
