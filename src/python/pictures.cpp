// SPDX-License-Identifier: Apache-2.0
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <tuple>
#include <vector>

#include "app/plotted_curves.hpp"
#include "python/topics.hpp"
#include "report/channel_curves.hpp"
#include "report/model_picture.hpp"
#include "report/picture_file.hpp"

// Plots and pictures of a run as SVG.
namespace nugget::python {
namespace {

namespace py = pybind11;
using Direction = std::array<double, 3>;

std::string plot(const std::string& directory, const std::vector<std::string>& channels, const std::string& over,
                 int channel_class, const std::string& other) {
  const py::gil_scoped_release others_may_go_on;
  app::PlotArguments arguments;
  arguments.directory = directory;
  arguments.channels = channels;
  arguments.over = over;
  arguments.channel_class = channel_class;
  arguments.other = other;
  return report::to_svg_file(report::plots_of(app::plotted_curves(arguments)));
}

using Trace = std::tuple<std::string, std::vector<double>, std::vector<double>, bool>;

/// Curves, or points, that no file holds.
std::string plot_curves(const std::vector<Trace>& traces, const std::string& abscissa, const std::string& ordinate,
                        bool log_x, bool log_y) {
  report::Plot plot{.abscissa = abscissa, .ordinate = ordinate, .x = {}, .curves = {}, .log_x = log_x, .log_y = log_y};
  for (const auto& [name, x, y, points] : traces) plot.traces.push_back({name, x, y, points});
  return report::to_svg_file({&plot, 1});
}

std::string picture(const std::string& directory, const report::PictureOptions& options) {
  const py::gil_scoped_release others_may_go_on;
  return report::model_picture(directory, options);
}

/// A vector as three numbers.
template <Vec3d report::PictureOptions::*member>
void put_direction(report::PictureOptions& options, const Direction& d) {
  options.*member = {d[0], d[1], d[2]};
}

}  // namespace

void add_pictures(py::module_& module) {
  using Options = report::PictureOptions;
  py::class_<Options>(module, "PictureOptions")
      .def(py::init())
      .def_readwrite("state", &Options::state)
      .def_readwrite("time", &Options::time)
      .def_readwrite("field", &Options::field)
      .def_readwrite("range", &Options::range)
      .def_readwrite("scale", &Options::scale)
      .def_readwrite("parts", &Options::parts)
      .def_readwrite("weld", &Options::weld)
      .def_readwrite("edges", &Options::edges)
      .def_readwrite("shapes", &Options::shapes)
      .def_readwrite("width", &Options::width)
      .def_readwrite("height", &Options::height)
      .def("look_towards", &put_direction<&Options::towards>)
      .def("put_up", &put_direction<&Options::up>);
  module.def("picture_fields", &report::picture_fields);
  module.def("channels",
             [](const std::string& directory) { return report::listed(report::read_channel_curves(directory)); });
  module.def("plot", &plot);
  module.def("plot_curves", &plot_curves);
  module.def("picture", &picture);
  module.def("is_picture_name", [](const std::string& name) { return report::is_picture_name(name); });
  module.def("write_picture", [](const std::string& name, const std::string& svg, int width) {
    report::write_picture(name, svg, width);
  });
}

}  // namespace nugget::python
