// SPDX-License-Identifier: Apache-2.0
#include "experiment.hpp"
#include "base/index.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <stdexcept>

#include "deck/deck.hpp"
#include "impact/contact/initial_penetrations.hpp"
#include "reading/build.hpp"
#include "weld/placement/coarsening.hpp"

namespace nugget::verify {
namespace {

class EveryCycle : public impact::Recorder {
 public:
  explicit EveryCycle(const Watch& watch) : watch_(watch) {}
  bool due(const system::State&) override { return true; }
  void write(const impact::Snapshot& now, bool) override { watch_(now); }

 private:
  const Watch& watch_;
};

class Nobody : public impact::Recorder {
 public:
  bool due(const system::State&) override { return false; }
  void write(const impact::Snapshot&, bool) override {}
};

class IntoMemory final : public Archive {
 public:
  explicit IntoMemory(std::string& kept) : Archive(false), kept_(kept) {}

 private:
  void bytes(void* data, std::size_t size) override { kept_.append(static_cast<const char*>(data), size); }
  std::string& kept_;
};

class FromMemory final : public Archive {
 public:
  explicit FromMemory(std::string_view kept) : Archive(true), kept_(kept) {}

 private:
  void bytes(void* data, std::size_t size) override {
    if (size > kept_.size()) throw ArchiveError("the state ends too early");
    std::memcpy(data, kept_.data(), size);
    kept_.remove_prefix(size);
  }
  std::string_view kept_;
};

bool same_bits(std::span<const Row> a, std::span<const Row> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Row)) == 0;
}

}  // namespace

void stop_on_errors(const Findings& findings) {
  if (findings.errors() == 0) return;
  std::string all = "the deck is refused:";
  for (const Finding& f : findings.all()) all += '\n' + to_string(f);
  throw std::runtime_error(all);
}

model::Model read_model(const std::string& text, Findings& findings) {
  const deck::Deck deck = deck::read_text(text, findings);
  model::Model model = reading::build(deck, findings);
  if (!model.coarsen.on || findings.errors() > 0) return model;
  Findings again;
  const model::Coarsening merged = weld::coarsening_of(model, weld::tie(model, again));
  return reading::build(deck, again, false, nullptr, &merged);
}

Experiment::Experiment(const std::string& text) : text_(text) {
  model_ = std::make_unique<model::Model>(read_model(text, findings_));
  stop_on_errors(findings_);
  if (const char* precision = std::getenv("NUGGET_PRECISION"))
    model_->control.single_precision = std::string_view(precision) == "single";
  ties_ = std::make_unique<weld::Ties>(
      weld::tie(*model_, impact::resolve_initial_penetrations(*model_, findings_), findings_));
  stop_on_errors(findings_);
  system_ = std::make_unique<system::System>(*model_, *ties_, findings_);
  stop_on_errors(findings_);
  simulation_ = std::make_unique<impact::Simulation>(*system_, findings_);
  stop_on_errors(findings_);
}

impact::Outcome Experiment::run(const Watch& watch, double until) {
  EveryCycle recorder(watch);
  impact::Options options{.until = until};
  std::string kept;
  if (std::getenv("NUGGET_RESUME") != nullptr) {
    options.checkpoints.time = 0.4 * (until > 0.0 ? until : model_->control.end_time);
    options.write_checkpoint = [&] {
      if (!kept.empty()) return;
      IntoMemory out(kept);
      out(*simulation_);
    };
  }
  const impact::Outcome outcome = simulation_->run(options, recorder, {});
  if (!kept.empty()) expect_same_end(kept, until);
  return outcome;
}

void Experiment::expect_same_end(const std::string& kept, double until) const {
  Experiment again(text_);
  impact::Simulation &resumed = *again.simulation_, &whole = *simulation_;
  Nobody looks_on;
  FromMemory from(kept);
  resumed.run({.until = until, .restore = [&] { from(resumed); }}, looks_on, {});
  const system::State &a = whole.state(), &b = resumed.state();
  EXPECT_EQ(a.cycle, b.cycle);
  EXPECT_EQ(a.time, b.time);
  EXPECT_TRUE(same_bits(a.x, b.x)) << "places";
  EXPECT_TRUE(same_bits(a.v, b.v)) << "velocities";
  EXPECT_TRUE(same_bits(a.w, b.w)) << "spins";
  EXPECT_TRUE(same_bits(a.f, b.f)) << "forces";
  EXPECT_TRUE(same_bits(a.m, b.m)) << "moments";
  EXPECT_EQ(whole.energy().total(), resumed.energy().total());
  EXPECT_EQ(whole.energy().external, resumed.energy().external);
  EXPECT_EQ(whole.components().welds.events(), resumed.components().welds.events());
  EXPECT_EQ(whole.components().rigid_welds.events(), resumed.components().rigid_welds.events());
}

std::size_t Experiment::node(int id) const {
  const model::Index n = model_->node_index(id);
  if (n == model::none) throw std::runtime_error(fmt::format("no node {}", id));
  return at(system_->node_of[n]);
}

Vec3d Experiment::displacement(const impact::Snapshot& now, int id) const {
  return position(now, id) - ties_->x[model_->node_index(id)];
}

const weld::History& Experiment::history(const impact::Snapshot& now, int id) const {
  for (std::size_t i = 0; i < ties_->welds.size(); ++i)
    if (ties_->welds[i].id == id && now.components.welds.history(i) != nullptr) return *now.components.welds.history(i);
  throw std::runtime_error(fmt::format("no weld {}", id));
}

const weld::Resultants& Experiment::weld(const impact::Snapshot& now, int id) const {
  return history(now, id).resultants();
}

void expect_reference(const std::string& test_case, const std::string& what, double value, double reference,
                      double gate, double scale) {
  const double base = scale != 0.0 ? std::abs(scale) : std::abs(reference);
  const double error = std::abs(value - reference) / base;
  EXPECT_LE(error, gate) << test_case << ", " << what << ": " << value << ", expected " << reference;
  EXPECT_TRUE(std::isfinite(value)) << test_case << ", " << what;
  // The book's table is made of these rows; see tools/verification_table.py.
  if (const char* path = std::getenv("NUGGET_VERIFICATION_ROWS"))
    std::ofstream(path, std::ios::app) << fmt::format("{}\t{}\t{:.6g}\t{:.6g}\t{:.3g}\t{:.3g}\n", test_case, what,
                                                      reference, value, error, gate);
}

std::string fields(std::initializer_list<double> values) {
  std::string line;
  for (double v : values) {
    std::string cell;
    for (int digits = 10; digits > 0; --digits) {
      cell = fmt::format("{:.{}g}", v, digits);
      if (cell.size() <= 10) break;
    }
    line += fmt::format("{:>10}", cell);
  }
  return line + '\n';
}

std::string node_line(int id, double x, double y, double z) {
  return fmt::format("{:8d}{:16.9g}{:16.9g}{:16.9g}\n", id, x, y, z);
}

std::string element_line(int id, int part, std::initializer_list<int> nodes) {
  std::string line = fmt::format("{:8d}{:8d}", id, part);
  for (int n : nodes) line += fmt::format("{:8d}", n);
  return line + '\n';
}

std::string curve(int id, std::initializer_list<std::pair<double, double>> points) {
  std::string text = "*DEFINE_CURVE\n" + fields({static_cast<double>(id), 0, 1, 1, 0, 0, 0});
  for (const auto& [x, y] : points) text += fmt::format("{:20.12g}{:20.12g}\n", x, y);
  return text;
}

}  // namespace nugget::verify
