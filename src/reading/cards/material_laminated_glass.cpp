// SPDX-License-Identifier: Apache-2.0
#include "kernel/element/shell.hpp"
#include "kernel/law/laminate.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/builder/common_cards.hpp"
#include "reading/cards/families.hpp"
#include "reading/cards/material.hpp"

// *MAT_LAMINATED_GLASS (032): windscreens. Which layer is glass and which is polymer stands here, how thick they are in
// *INTEGRATION_SHELL: reading/mesh/layers.cpp puts the two together.
namespace nugget::reading {

namespace {

using deck::Block;
using deck::Cursor;

struct GlassCards : MaterialCard {
  double eg = 0, prg = 0, syg = 0, etg = 0, efg = 0, ep = 0;
  double prp = 0, syp = 0, etp = 0;
};
const CardOf<GlassCards> glass_card{
    {&MaterialCard::mid, material_id},
    {&MaterialCard::ro, density},
    {&GlassCards::eg, real("eg", dimension::stress, required, above_zero(), "Young's modulus of the glass")},
    {&GlassCards::prg, real("prg", dimension::number, 0, between(0, 0.5), "its Poisson's ratio")},
    {&GlassCards::syg, real("syg", dimension::stress, required, above_zero(), "its yield stress")},
    {&GlassCards::etg, real("etg", dimension::stress, 0, at_least(0), "its plastic hardening modulus")},
    {&GlassCards::efg, real("efg", dimension::number, 0, at_least(0), "plastic strain at which it fails; 0: none")},
    {&GlassCards::ep, real("ep", dimension::stress, required, above_zero(), "Young's modulus of the polymer")},
};
const CardOf<GlassCards> polymer_layer_card{
    {&GlassCards::prp, real("prp", dimension::number, 0, between(0, 0.5), "its Poisson's ratio")},
    {&GlassCards::syp, real("syp", dimension::stress, required, above_zero(), "its yield stress")},
    {&GlassCards::etp, real("etp", dimension::stress, 0, at_least(0), "its plastic hardening modulus")},
};
struct LayerFlags {
  std::array<double, 8> f{};
};
constexpr RealField flag(std::string_view name) {
  return real(name, dimension::number, 0, between(0, 1), "layer from the bottom up 0: glass, 1: polymer");
}
const CardOf<LayerFlags> layer_flags_card{
    {at(&LayerFlags::f, 0), flag("f1")}, {at(&LayerFlags::f, 1), flag("f2")}, {at(&LayerFlags::f, 2), flag("f3")},
    {at(&LayerFlags::f, 3), flag("f4")}, {at(&LayerFlags::f, 4), flag("f5")}, {at(&LayerFlags::f, 5), flag("f6")},
    {at(&LayerFlags::f, 6), flag("f7")}, {at(&LayerFlags::f, 7), flag("f8")},
};

kernel::ComposedLaw flows(double young, double poisson, double yield, double hardening, double failure_strain) {
  kernel::PiecewiseLinear flow;
  flow.E = young;
  flow.nu = poisson;
  flow.yield = {{0, {0.0, 1.0}, {yield, yield + hardening}}};
  kernel::LawComponents law{flow};
  law.failure_strain = plastic_strain_at_failure(failure_strain);
  return kernel::composed_law(std::move(law));
}

void read_glass(Builder& b, const Block& block, const Options& options) {
  Cursor cursor(b.deck, block, b.findings);
  std::string title = read_title(cursor, options);
  GlassCards cards;
  const auto row = cursor.read(glass_card, cards);
  cursor.read(polymer_layer_card, cards);
  const kernel::ComposedLaw glass = flows(cards.eg, cards.prg, cards.syg, cards.etg, cards.efg),
                            polymer = flows(cards.ep, cards.prp, cards.syp, cards.etp, 0.0);
  std::vector<kernel::Laminate::Layer> layers;
  const auto add = [&](double f) { layers.push_back({.law = f > 0.0 ? polymer : glass, .density = cards.ro}); };
  while (cursor.more() && layers.size() < kernel::most_layers) {
    const auto flags = cursor.read(layer_flags_card);
    for (const double f : flags->f) add(f);
  }
  while (layers.size() < kernel::most_layers) add(0.0);
  expect_end(b, cursor);
  add_material(b, row, std::move(title), "MAT_LAMINATED_GLASS", kernel::laminate(std::move(layers), true));
}

}  // namespace

std::vector<Keyword> laminated_glass_keywords() {
  return {{.name = "MAT_LAMINATED_GLASS",
           .aliases = {"MAT_032"},
           .options = {"TITLE"},
           .layout = {{"", &glass_card}, {"", &polymer_layer_card}, {"1 to 4", &layer_flags_card}},
           .read = read_glass}};
}

}  // namespace nugget::reading
