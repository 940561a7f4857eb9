// SPDX-License-Identifier: Apache-2.0
#include "app/linear_checks.hpp"

#include "app/preload.hpp"
#include "app/without_part.hpp"
#include "nvh/eigen/modes.hpp"
#include "nvh/statics/loose_bodies.hpp"
#include "nvh/statics/static_loads.hpp"
#include "nvh/statics/statics.hpp"
#include "weld/failure/missing_data.hpp"

namespace nugget::app {

void check_linear(LinearJob& job, const LinearChecks& checks, Findings& findings) {
  const model::Model& model = job.deck().model;
  const bool statics = checks.analysis == Analysis::statics;
  const bool preloaded = model.implicit.modes < 0 && model.implicit.geometric && !model.implicit.after_run;
  if (job.assembled()) {
    const nvh::Matrices& matrices = job.matrices();
    if (checks.analysis == Analysis::modes_and_responses)
      nvh::report_fixed_motions(matrices.equations, model, findings);
    if (!statics && checks.responses) check_responses(matrices, model, findings);
    if (statics) {
      weld::failure::report_missing_data(model, job.deck().ties, findings);
      nvh::check_support(matrices, findings);
    }
    if (statics || preloaded) {
      nvh::check_motions(matrices, findings);
      nvh::check_resistance(matrices, findings);
    }
  }
  if (statics) return;
  check_preload(model, checks.after, findings);
  if (checks.after == nullptr) note_what_takes_no_part(model, model.implicit.modes < 0, findings);
}

void check_modes_after(const std::filesystem::path& directory, const RunArguments& arguments, const PreparedDeck& p,
                       const impact::Simulation& run, Findings& findings) {
  Findings found;
  LinearJob job(directory, arguments, p, found, &run.system());
  check_linear(job, {.analysis = Analysis::modes_and_responses, .after = &run}, found);
  for (const Finding& f : found.all())
    if (f.severity == Severity::error) findings.add(f);
}

}  // namespace nugget::app
