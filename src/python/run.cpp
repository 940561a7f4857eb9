// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <sys/time.h>

#include <array>
#include <csignal>
#include <exception>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "app/commands.hpp"
#include "impact/simulation/simulation.hpp"
#include "output/restart_file.hpp"
#include "python/terminal_text.hpp"
#include "python/topics.hpp"

// Commands that compute, in the process of Python.
namespace nugget::python {
namespace {

namespace py = pybind11;

/// The commands are programs: they take over signals and, to resume, the folder. Both are given back at the end.
class Surroundings {
 public:
  Surroundings() : folder_(std::filesystem::current_path()) {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], nullptr, &handlers_[i]);
  }
  ~Surroundings() {
    constexpr itimerval none{};
    setitimer(ITIMER_REAL, &none, nullptr);
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &handlers_[i], nullptr);
    std::error_code gone;
    std::filesystem::current_path(folder_, gone);
    impact::Simulation::interrupt(nullptr);  // what came after the last cycle is not meant for the next run
  }
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGALRM};
  std::array<struct sigaction, signals.size()> handlers_{};
  std::filesystem::path folder_;
};

/// Calls a function of Python as a run goes on. Where it gives False or raises, the run is interrupted.
class Watcher {
 public:
  explicit Watcher(py::function function) : function_(std::move(function)) {}

  void operator()(const impact::Progress& p) {
    const py::gil_scoped_acquire gil;
    if (raised_) return;
    try {
      const py::object answer = function_(p.time, p.end_time, p.cycle, p.energy_ratio, p.welds_failed);
      if (answer.is(py::bool_(false))) impact::Simulation::interrupt("its caller");
    } catch (const py::error_already_set&) {
      raised_ = std::current_exception();
      impact::Simulation::interrupt("an exception of its caller");
    }
  }
  void raise_again() const {
    if (raised_) std::rethrow_exception(raised_);
  }

 private:
  py::function function_;
  std::exception_ptr raised_;
};

/// (exit code, what the command printed). One at a time: threads, signals and the terminal are those of the process.
template <class Command>
std::pair<int, std::string> in_process(Command command) {
  static std::mutex one_at_a_time;
  const py::gil_scoped_release others_may_go_on;
  const std::lock_guard mine(one_at_a_time);
  const Surroundings surroundings;
  const TerminalText terminal;
  const auto code = static_cast<int>(command());
  return {code, terminal.text()};
}

std::pair<int, std::string> run(app::RunArguments arguments, const py::object& progress) {
  arguments.quiet = true;
  if (progress.is_none()) return in_process([&] { return app::run(arguments); });
  Watcher watcher{py::function(progress)};
  arguments.progress = std::ref(watcher);
  auto end = in_process([&] { return app::run(arguments); });
  watcher.raise_again();
  return end;
}

std::pair<int, std::string> modes(app::ModesArguments arguments) {
  arguments.run.quiet = true;
  return in_process([&] { return app::modes(arguments); });
}

std::pair<int, std::string> frf(app::RunArguments arguments, bool direct) {
  arguments.quiet = true;
  return in_process([&] { return app::frf(arguments, direct); });
}

std::pair<int, std::string> place_welds(const std::string& points, const std::string& deck, const std::string& output,
                                        const std::string& form, double reach, double diameter,
                                        const std::vector<std::string>& material, double strength_diameter,
                                        bool skip_unsupported) {
  app::WeldArguments arguments;
  arguments.points = points;
  arguments.deck = deck;
  arguments.output = output;
  arguments.form = weld::weld_form(form).value();
  arguments.search_distance = reach;
  arguments.diameter = diameter;
  arguments.material = material;
  arguments.strength_diameter = strength_diameter;
  arguments.skip_unsupported = skip_unsupported;
  return in_process([&] { return app::weld(arguments); });
}

/// Restart files are those of the program that was linked from the same objects: a copy of it stands beside the module.
void take_program_beside() {
  Dl_info here{};
  if (dladdr(reinterpret_cast<const void*>(&take_program_beside), &here) == 0) return;
  const std::filesystem::path module = std::filesystem::absolute(here.dli_fname);
  const std::filesystem::path program = module.parent_path() / "_program";
  output::take_for_program(std::filesystem::exists(program) ? program : module);
}

}  // namespace

void add_run(py::module_& module) {
  take_program_beside();
  using Run = app::RunArguments;
  py::class_<Run>(module, "RunArguments")
      .def(py::init())
      .def_readwrite("deck", &Run::deck)
      .def_readwrite("directory", &Run::directory)
      .def_readwrite("threads", &Run::threads)
      .def_readwrite("until", &Run::until)
      .def_readwrite("max_cycles", &Run::max_cycles)
      .def_readwrite("checkpoint", &Run::checkpoint)
      .def_readwrite("stop_after", &Run::stop_after)
      .def_readwrite("weld_law", &Run::weld_law)
      .def_readwrite("resume", &Run::resume)
      .def_readwrite("weld_tie", &Run::weld_tie)
      .def_readwrite("precision", &Run::precision)
      .def_readwrite("subcycle", &Run::subcycle)
      .def_readwrite("load_case", &Run::load_case)
      .def_readwrite("skip_unsupported", &Run::skip_unsupported);
  using Modes = app::ModesArguments;
  py::class_<Modes>(module, "ModesArguments")
      .def(py::init())
      .def_readwrite("run", &Modes::run)
      .def_readwrite("count", &Modes::count)
      .def_readwrite("low", &Modes::low)
      .def_readwrite("high", &Modes::high);
  module.def("says_checkpoints", &app::says_checkpoints);
  module.def("run", &run);
  module.def("modes", &modes);
  module.def("frf", &frf);
  module.def("weld", &place_welds);
  module.def("weld_forms", [] {
    std::vector<std::string> names;
    for (const weld::NamedWeldForm& f : weld::weld_forms()) names.emplace_back(f.name);
    return names;
  });
}

}  // namespace nugget::python
