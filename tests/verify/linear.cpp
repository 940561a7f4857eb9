// SPDX-License-Identifier: Apache-2.0
#include "linear.hpp"

#include <gtest/gtest.h>

#include "base/index.hpp"
#include "experiment.hpp"
#include "impact/contact/initial_penetrations.hpp"
#include "nvh/matrices/linear_model.hpp"
#include "nvh/statics/statics.hpp"

namespace nugget::verify {

LinearExperiment::LinearExperiment(const std::string& text) {
  model_ = std::make_unique<model::Model>(read_model(text, findings_));
  stop_on_errors(findings_);
  ties_ = std::make_unique<weld::Ties>(
      weld::tie(*model_, impact::resolve_initial_penetrations(*model_, findings_), findings_));
  stop_on_errors(findings_);
  linear_ = std::make_unique<model::Model>(nvh::linear_model(*model_, findings_));
  system_ = std::make_unique<system::System>(*linear_, *ties_, findings_);
  matrices_ = std::make_unique<nvh::Matrices>(*system_, findings_);
  stop_on_errors(findings_);
}

nvh::Modes LinearExperiment::modes(int count) const {
  nvh::ModeRequest request;
  request.count = count;
  nvh::Modes modes = nvh::find_modes(*matrices_, request);
  EXPECT_TRUE(modes.proof.complete()) << modes.proof.counted << " modes counted, " << modes.proof.found << " found";
  EXPECT_EQ(modes.eigenvalue.size(), at(count));
  return modes;
}

std::vector<double> LinearExperiment::elastic_frequencies(int count) const {
  const nvh::Modes all = modes(count + 6);
  for (std::size_t i = 0; i < 6; ++i)
    EXPECT_LT(std::sqrt(std::abs(all.eigenvalue[i])), 1e-3 * std::sqrt(all.eigenvalue[6])) << "rigid motion " << i;
  std::vector<double> f;
  for (std::size_t i = 6; i < all.eigenvalue.size(); ++i) f.push_back(all.frequency(i));
  return f;
}

nvh::SixDof LinearExperiment::motion(const nvh::Modes& modes, std::size_t mode, int node) const {
  const model::Index n = system_->model.node_index(node);
  return matrices_->equations.motion(system_->node_of[n], modes.shape[mode]);
}

nvh::SixDof static_motion(Specimen s, int node) {
  s.card("CONTROL_IMPLICIT_GENERAL", {1, 1.0})
      .card("CONTROL_IMPLICIT_SOLUTION", {1})
      .text(constant_curve(1))
      .card("CONTROL_TERMINATION", {1.0});
  const LinearExperiment experiment(s.deck());
  Findings findings;
  const nvh::Statics statics = nvh::solve_statics(experiment.matrices(), findings);
  const auto n = at(experiment.system().model.node_index(node));
  return statics.motion[experiment.system().node_of[n]];
}

}  // namespace nugget::verify
