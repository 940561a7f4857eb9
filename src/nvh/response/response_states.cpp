// SPDX-License-Identifier: Apache-2.0
#include "nvh/response/response_states.hpp"

#include <cmath>
#include <numbers>

#include "nvh/response/frequencies.hpp"
#include "nvh/response/transfer.hpp"
#include "output/model_geometry.hpp"

namespace nugget::nvh {
namespace {

using Complex = std::complex<double>;
using Load = model::SteadyState::Load;

/// What the loads together drive: of each its amplitude, as a factor on the answer to a load of 1 and on what goes
/// along with a motion.
class Drive {
 public:
  Drive(const Matrices& m, const model::SteadyState& request, const model::SteadyState::Case& driven)
      : m_(m), request_(request), driven_(driven.loads) {
    for (const Load& load : driven_) loads_.push_back(harmonic_load(m, load.excitation));
  }
  const std::vector<HarmonicLoad>& loads() const { return loads_; }

  Complex on_response(std::size_t l, double frequency) const { return factor(l, frequency, 2); }

  /// Motion of a system node: that of the unknowns, and what is carried along.
  std::array<Complex, 3> motion(int node, std::span<const double> real, std::span<const double> imaginary,
                                double frequency) const {
    const SixDof a = m_.equations.motion(node, real), b = m_.equations.motion(node, imaginary);
    std::array<Complex, 3> u{Complex(a[0], b[0]), Complex(a[1], b[1]), Complex(a[2], b[2])};
    for (std::size_t l = 0; l < loads_.size(); ++l) {
      const auto& excitation = driven_[l].excitation;
      const bool relative = request_.relative && excitation.kind == Transfer::Excitation::Kind::base;
      if (!excitation.moves() || relative) continue;
      const Complex along = factor(l, frequency, 0);
      for (std::size_t i = 0; i < 3; ++i) u[i] += along * loads_[l].carried[node][i];
    }
    return u;
  }

 private:
  /// Of a motion the answer is that to a unit acceleration, two derivatives more.
  Complex factor(std::size_t l, double frequency, int more) const {
    const Load& load = driven_[l];
    const Complex a = amplitude(m_.system.model, request_, load, frequency);
    if (a == 0.0 || !load.excitation.moves()) return a;
    return a * derivative(2.0 * std::numbers::pi * frequency, more - order(load.excitation.quantity));
  }

  const Matrices& m_;
  const model::SteadyState& request_;
  const std::vector<Load>& driven_;
  std::vector<HarmonicLoad> loads_;
};

}  // namespace

void each_motion(const Matrices& m, const Modes& modes, const model::SteadyState& request,
                 const model::SteadyState::Case& loads, const std::vector<double>& frequency,
                 const std::function<void(const MotionAt&)>& visit, const ProgressCallback& progress) {
  const Drive drive(m, request, loads);
  std::vector<double> real(m.size()), imaginary(m.size());
  MotionAt now;
  now.u.resize(m.system.model.nodes.size());
  const auto report_motion = [&](std::size_t k) {
    now.frequency = frequency[k];
    for (std::size_t n = 0; n < now.u.size(); ++n)
      now.u[n] = drive.motion(m.system.node_of[n], real, imaginary, frequency[k]);
    visit(now);
  };
  if (request.direct && m.size() > 0) {
    const auto load = [&](std::size_t k, std::vector<Complex>& x) {
      std::fill(x.begin(), x.end(), 0.0);
      for (std::size_t l = 0; l < drive.loads().size(); ++l) {
        const Complex factor = drive.on_response(l, frequency[k]);
        for (std::size_t i = 0; i < m.size(); ++i) x[i] += factor * drive.loads()[l].force[i];
      }
    };
    const auto keep = [&](std::size_t k, const std::vector<Complex>& x) {
      for (std::size_t i = 0; i < m.size(); ++i) {
        real[i] = x[i].real();
        imaginary[i] = x[i].imag();
      }
      report_motion(k);
    };
    return solve_directly(m, request.damping, frequency, 1, load, keep, progress);
  }
  const Superposition superposition(m, modes, request.modes, drive.loads());
  const Responses share = superposition.shares(request.damping, frequency);
  for (std::size_t k = 0; k < frequency.size(); ++k) {
    std::fill(real.begin(), real.end(), 0.0);
    std::fill(imaginary.begin(), imaginary.end(), 0.0);
    for (std::size_t i = 0; i < superposition.oscillators(); ++i) {
      Complex sum = 0.0;
      for (std::size_t l = 0; l < drive.loads().size(); ++l)
        if (const Complex factor = drive.on_response(l, frequency[k]); factor != 0.0) sum += factor * share(l, i, k);
      const std::span<const double> shape = superposition.shape(i);
      for (std::size_t j = 0; j < m.size(); ++j) {
        real[j] += sum.real() * shape[j];
        imaginary[j] += sum.imag() * shape[j];
      }
    }
    report_motion(k);
  }
}

std::size_t write_d3ssd(const std::filesystem::path& directory, const Matrices& m, const Modes& modes,
                        const model::SteadyState& request, const ProgressCallback& progress) {
  using Part = model::SteadyState::States::Part;
  const std::vector<double> frequency = frequencies(*request.states, modes);
  const std::size_t nodes = m.system.model.nodes.size();
  const auto part = [&](const Complex& z) {
    const double v = request.states->part == Part::amplitude ? std::abs(z)
                     : request.states->part == Part::real    ? z.real()
                                                             : z.imag();
    return std::isfinite(v) ? v : 0.0;  // a free body at frequency 0
  };
  for (const model::SteadyState::Case& loads : request.cases) {
    output::D3plotGeometry geometry = output::d3plot_geometry(m.system);
    geometry.family = output::D3plotGeometry::Family::d3ssd;
    geometry.suffix = file_of_case("", loads);
    geometry.rigid_walls = 0;
    output::D3plotState state = output::unstressed_state(m.system, geometry);
    state.v.resize(nodes);
    state.a.resize(nodes);
    output::D3plot file(directory, std::move(geometry));
    const auto write = [&](const MotionAt& now) {
      const Complex rate(0.0, 2.0 * std::numbers::pi * now.frequency);
      state.time = now.frequency;
      for (std::size_t n = 0; n < nodes; ++n) {
        const auto& u = now.u[n];
        state.x[n] = m.system.ties.x[n] + Vec3d{part(u[0]), part(u[1]), part(u[2])};
        state.v[n] = {part(rate * u[0]), part(rate * u[1]), part(rate * u[2])};
        state.a[n] = {part(rate * rate * u[0]), part(rate * rate * u[1]), part(rate * rate * u[2])};
      }
      file.write(state);
    };
    each_motion(m, modes, request, loads, frequency, write, progress);
  }
  return frequency.size();
}

}  // namespace nugget::nvh
