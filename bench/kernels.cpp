// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdint>
#include <new>
#include <string>
#include <vector>

#include "base/index.hpp"
#include "base/row.hpp"
#include "kernel/element/belytschko_tsay.hpp"
#include "kernel/element/c0_triangle.hpp"
#include "kernel/element/full_hexahedron.hpp"
#include "kernel/element/full_shell.hpp"
#include "kernel/element/hexahedron.hpp"
#include "kernel/element/weld_beam.hpp"
#include "kernel/law/laws.hpp"
#include "kernel/law/spotweld_kernel.hpp"

// Cost of one element in one cycle: gather of nodal rows, kernel, forces into slots; one core, as many elements at a
// time as a register has lanes. Nodes stand still and keep their velocities, so that every cycle brings the same
// strain: small and elastic, or every point yields.
namespace {

using namespace nugget;
using namespace nugget::kernel;
using R = NativeBatch;

constexpr int side = 136;  // 18,496 quadrilaterals
constexpr double speed = 2000.0;

class Noise {
 public:
  double operator()() {
    state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
    return static_cast<double>(state_ >> 11) / 9007199254740992.0 - 0.5;
  }

 private:
  std::uint64_t state_ = 1;
};

struct Mesh {
  std::vector<Row> x, v, w;
  std::vector<int> corner;  ///< element by element
  std::size_t elements = 0;
  int corners = 0;

  void node(double px, double py, double pz, Noise& noise) {
    x.push_back({px + 0.1 * noise(), py + 0.1 * noise(), pz + 0.02 * noise(), 0});
    v.push_back({speed * noise(), speed * noise(), speed * noise(), 0});
    w.push_back({0.2 * speed * noise(), 0.2 * speed * noise(), 0.2 * speed * noise(), 0});
  }
  void element(std::initializer_list<int> nodes) {
    corner.insert(corner.end(), nodes);
    corners = static_cast<int>(nodes.size());
    ++elements;
  }
};

Mesh sheet(bool triangles) {
  Mesh m;
  Noise noise;
  for (int j = 0; j <= side; ++j)
    for (int i = 0; i <= side; ++i) m.node(i, j, 0.3 * std::sin(0.05 * i), noise);
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const int n = j * (side + 1) + i;
      if (triangles) {
        m.element({n, n + 1, n + side + 2});
        m.element({n, n + side + 2, n + side + 1});
      } else {
        m.element({n, n + 1, n + side + 2, n + side + 1});
      }
    }
  return m;
}

Mesh block() {
  constexpr int edge = 26;  // 17,576 bricks
  constexpr int row = edge + 1, layer = row * row;
  Mesh m;
  Noise noise;
  for (int k = 0; k <= edge; ++k)
    for (int j = 0; j <= edge; ++j)
      for (int i = 0; i <= edge; ++i) m.node(i, j, k, noise);
  for (int k = 0; k < edge; ++k)
    for (int j = 0; j < edge; ++j)
      for (int i = 0; i < edge; ++i) {
        const int n = k * layer + j * row + i, u = n + layer;
        m.element({n, n + 1, n + row + 1, n + row, u, u + 1, u + row + 1, u + row});
      }
  return m;
}

Mesh welds() {
  Mesh m;
  Noise noise;
  for (int i = 0; i < 16384; ++i) {
    m.node(10.0 * i, 0, 0, noise);
    m.node(10.0 * i, 0, 1.5, noise);
    m.element({2 * i, 2 * i + 1});
  }
  return m;
}

/// Memory on register boundaries, as the solver has it.
struct Reals {
  explicit Reals(std::size_t n)
      : data(static_cast<double*>(::operator new (n * sizeof(double), std::align_val_t{64}))) {}
  ~Reals() { ::operator delete (data, std::align_val_t{64}); }
  Reals(const Reals&) = delete;
  Reals& operator=(const Reals&) = delete;
  double* data;
};

/// Runs `cycle(ids, block)` over the mesh, `lanes<R>` elements at a time; counts seconds an element.
template <class Start, class Cycle>
void sweep(benchmark::State& state, const Mesh& mesh, int state_size, int rows, Start&& start, Cycle&& cycle) {
  constexpr int W = lanes<R>;
  const std::size_t blocks = mesh.elements / W, corners = at(mesh.corners);
  std::vector<int> ids(blocks * W * corners);
  Reals fields(blocks * at(W * state_size));
  Reals slots(3 * blocks * W * corners * at(rows));
  for (std::size_t e = 0; e < blocks * W; ++e) {
    for (std::size_t a = 0; a < corners; ++a) ids[(e / W * corners + a) * W + e % W] = mesh.corner[e * corners + a];
    start(fields.data + e / W * at(W * state_size), static_cast<int>(e % W), &mesh.corner[e * corners]);
  }
  const auto run = [&] {
    for (std::size_t b = 0; b < blocks; ++b)
      cycle(&ids[b * W * corners], fields.data + b * at(W * state_size), slots.data + 3 * b * W * corners * at(rows));
  };
  for (int warm = 0; warm < 60; ++warm) run();
  for (auto _ : state) {
    run();
    benchmark::ClobberMemory();
  }
  state.counters["per_element"] =
      benchmark::Counter(static_cast<double>(blocks * W) * static_cast<double>(state.iterations()),
                         benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

template <int N>
NodalMotion<R, N> gather_motion(const Mesh& m, const int* id) {
  NodalMotion<R, N> n;
  for (int a = 0; a < N; ++a) {
    n.x[a] = gather<R>(m.x.data(), id + a * lanes<R>);
    n.v[a] = gather<R>(m.v.data(), id + a * lanes<R>);
    n.w[a] = gather<R>(m.w.data(), id + a * lanes<R>);
  }
  return n;
}
/// Into the i-th slots of a block, as system::SlotsOf has them.
void store(double* slots, int i, const Vec3<R>& v) {
  double* slot = slots + 3 * i * lanes<R>;
  real_store(slot, v.x);
  real_store(slot + lanes<R>, v.y);
  real_store(slot + 2 * lanes<R>, v.z);
}
template <int N>
void store_forces(double* slots, const NodalForces<R, N>& f) {
  for (int a = 0; a < N; ++a) {
    store(slots, 2 * a, f.f[a]);
    store(slots, 2 * a + 1, f.m[a]);
  }
}

constexpr double E = 210000.0, nu = 0.3;
constexpr double small_step = 1e-15, large_step = 2e-7;

Elastic elastic() {
  return {E, nu};
}
PlasticKinematic kinematic() {
  return {E, nu, 250.0, 1000.0, 0.5, 0, 0, 0};
}
PiecewiseLinear curve(std::vector<double> x, std::vector<double> y) {
  PiecewiseLinear law;
  law.E = E;
  law.nu = nu;
  law.yield = {Curve{0, std::move(x), std::move(y)}};
  return law;
}
PiecewiseLinear bilinear() {
  return curve({0, 1}, {250, 1250});
}
PiecewiseLinear curved() {
  return curve({0, 0.005, 0.01, 0.02, 0.04, 0.08, 0.15, 0.3, 0.6, 1},
               {250, 280, 300, 320, 350, 380, 410, 450, 500, 550});
}
PiecewiseLinear rated() {
  PiecewiseLinear law = curved();
  law.rate_c = 40.0;
  law.rate_p = 5.0;
  return law;
}
Spotweld weld() {
  Spotweld law;
  law.E = E;
  law.nu = nu;
  law.yield = 400.0;
  law.hardening = 1000.0;
  return law;
}

ShellProperties section() {
  ShellProperties shell;
  shell.density = 7.85e-9;
  shell.layers = gauss_layers(3);
  return shell;
}

template <class Law>
void shell(benchmark::State& state, const Law& parameters, double dt, ShellProperties properties = section()) {
  static const Mesh mesh = sheet(false);
  const LawKernel<Law> law(parameters);
  const ShellLayout layout = shell_layout(properties, law);
  sweep(
      state, mesh, layout.size(), 2,
      [&](double* s, int lane, const int*) { start_shell(layout, 1.5, s, lanes<R>, lane); },
      [&](const int* id, double* s, double* slot) {
        store_forces(slot, shell_cycle(properties, law, gather_motion<4>(mesh, id), dt, s));
      });
}

template <class Law>
void full_shell(benchmark::State& state, const Law& parameters, double dt, ShellProperties properties = section()) {
  static const Mesh mesh = sheet(false);
  const LawKernel<Law> law(parameters);
  const ShellLayout layout = full_shell_layout(properties, law);
  sweep(
      state, mesh, layout.size(), 2,
      [&](double* s, int lane, const int*) { start_shell(layout, 1.5, s, lanes<R>, lane); },
      [&](const int* id, double* s, double* slot) {
        store_forces(slot, full_shell_cycle(properties, law, gather_motion<4>(mesh, id), dt, s));
      });
}

template <class Law>
void triangle(benchmark::State& state, const Law& parameters, double dt) {
  static const Mesh mesh = sheet(true);
  const ShellProperties properties = section();
  const LawKernel<Law> law(parameters);
  const ShellLayout layout = shell_layout(properties, law);
  sweep(
      state, mesh, layout.size(), 2,
      [&](double* s, int lane, const int*) { start_shell(layout, 1.5, s, lanes<R>, lane); },
      [&](const int* id, double* s, double* slot) {
        store_forces(slot, triangle_cycle(properties, law, gather_motion<3>(mesh, id), dt, s));
      });
}

template <class Law>
void brick(benchmark::State& state, const Law& parameters, double dt, int hourglass) {
  static const Mesh mesh = block();
  HexahedronProperties properties;
  properties.density = 7.85e-9;
  properties.hourglass = hourglass;
  const LawKernel<Law> law(parameters);
  const HexahedronLayout layout = hexahedron_layout(law);
  sweep(
      state, mesh, layout.size(), 1,
      [&](double* s, int lane, const int* corner) {
        std::array<Vec3d, 8> x;
        for (std::size_t a = 0; a < 8; ++a) {
          const Row& r = mesh.x[corner[a]];
          x[a] = {r.x, r.y, r.z};
        }
        start_hexahedron(layout, x, s, lanes<R>, lane);
      },
      [&](const int* id, double* s, double* slot) {
        SolidMotion<R> n;
        for (int a = 0; a < 8; ++a) {
          n.x[a] = gather<R>(mesh.x.data(), id + a * lanes<R>);
          n.v[a] = gather<R>(mesh.v.data(), id + a * lanes<R>);
        }
        const SolidForces<R> f = hexahedron_cycle(properties, law, n, dt, s);
        for (int a = 0; a < 8; ++a) store(slot, a, f.f[a]);
      });
}

template <class Law>
void full_brick(benchmark::State& state, const Law& parameters, double dt) {
  static const Mesh mesh = block();
  HexahedronProperties properties;
  properties.density = 7.85e-9;
  const LawKernel<Law> law(parameters);
  const FullHexahedronLayout layout = full_hexahedron_layout(law);
  sweep(
      state, mesh, layout.size(), 1,
      [&](double* s, int lane, const int*) { start_full_hexahedron(layout, s, lanes<R>, lane); },
      [&](const int* id, double* s, double* slot) {
        SolidMotion<R> n;
        for (int a = 0; a < 8; ++a) {
          n.x[a] = gather<R>(mesh.x.data(), id + a * lanes<R>);
          n.v[a] = gather<R>(mesh.v.data(), id + a * lanes<R>);
        }
        const SolidForces<R> f = full_hexahedron_cycle(properties, BrickStrains::shape_functions, law, n, dt, s);
        for (int a = 0; a < 8; ++a) store(slot, a, f.f[a]);
      });
}

void weld_beam(benchmark::State& state, double dt, int quadrature) {
  static const Mesh mesh = welds();
  WeldBeamProperties properties;
  properties.density = 7.8e-9;
  properties.fibres = disc_fibres(6.0, 0.0, quadrature);
  const LawKernel<Spotweld> law(weld());
  const WeldBeamLayout layout = weld_beam_layout(properties, law);
  sweep(
      state, mesh, layout.size(), 2,
      [&](double* s, int lane, const int* corner) {
        const Row &a = mesh.x[corner[0]], &b = mesh.x[corner[1]];
        start_weld_beam(layout, {a.x, a.y, a.z}, {b.x, b.y, b.z}, {}, s, lanes<R>, lane);
      },
      [&](const int* id, double* s, double* slot) {
        store_forces(slot, weld_beam_cycle(properties, law, gather_motion<2>(mesh, id), dt, s));
      });
}

ShellProperties with_warping() {
  ShellProperties shell = section();
  shell.warping_stiffness = true;
  shell.thickness_update = ThicknessUpdate::all;
  return shell;
}

ShellProperties with_drilling() {
  ShellProperties shell = section();
  shell.warping_stiffness = true;
  shell.drilling = usual_drilling;
  return shell;
}

template <class Case>
void add(const std::string& name, Case run) {
  benchmark::RegisterBenchmark(name.c_str(), run)->Unit(benchmark::kMillisecond);
}

[[maybe_unused]] const bool registered = [] {
  add("shell/elastic", [](benchmark::State& s) { shell(s, elastic(), small_step); });
  add("shell/j2 elastic", [](benchmark::State& s) { shell(s, bilinear(), small_step); });
  add("shell/j2 all plastic", [](benchmark::State& s) { shell(s, bilinear(), large_step); });
  add("shell/curve all plastic", [](benchmark::State& s) { shell(s, curved(), large_step); });
  add("shell/Cowper-Symonds all plastic", [](benchmark::State& s) { shell(s, rated(), large_step); });
  add("shell/kinematic all plastic", [](benchmark::State& s) { shell(s, kinematic(), large_step); });
  add("shell/j2 elastic, warping, thinning",
      [](benchmark::State& s) { shell(s, bilinear(), small_step, with_warping()); });
  add("full shell/j2 elastic", [](benchmark::State& s) { full_shell(s, bilinear(), small_step); });
  add("full shell/j2 all plastic", [](benchmark::State& s) { full_shell(s, bilinear(), large_step); });
  add("full shell/j2 elastic, warping, drilling",
      [](benchmark::State& s) { full_shell(s, bilinear(), small_step, with_drilling()); });
  add("triangle/j2 elastic", [](benchmark::State& s) { triangle(s, bilinear(), small_step); });
  add("triangle/j2 all plastic", [](benchmark::State& s) { triangle(s, bilinear(), large_step); });
  add("brick/j2 elastic, hourglass 2", [](benchmark::State& s) { brick(s, bilinear(), small_step, 2); });
  add("brick/j2 elastic, hourglass 4", [](benchmark::State& s) { brick(s, bilinear(), small_step, 4); });
  add("brick/j2 elastic, hourglass 6", [](benchmark::State& s) { brick(s, bilinear(), small_step, 6); });
  add("brick/j2 all plastic, hourglass 2", [](benchmark::State& s) { brick(s, bilinear(), large_step, 2); });
  add("full brick/j2 elastic", [](benchmark::State& s) { full_brick(s, bilinear(), small_step); });
  add("full brick/j2 all plastic", [](benchmark::State& s) { full_brick(s, bilinear(), large_step); });
  add("weld beam/elastic, 4 points", [](benchmark::State& s) { weld_beam(s, small_step, 2); });
  add("weld beam/all plastic, 4 points", [](benchmark::State& s) { weld_beam(s, large_step, 2); });
  add("weld beam/elastic, 16 points", [](benchmark::State& s) { weld_beam(s, small_step, 3); });
  return true;
}();

}  // namespace
