// SPDX-License-Identifier: Apache-2.0
#include "reading/builder/passes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "kernel/law/composed_law_kernel.hpp"
#include "kernel/law/law_components.hpp"
#include "reading/builder/builder.hpp"
#include "reading/cards/added_law.hpp"

namespace nugget::reading {

namespace {

Material& material_at(Builder& b, Index material) {
  return b.model.materials[material];
}

/// The material that a layer's card names, or none and a finding.
Index material_of(Builder& b, const LayerCard& layer, const Part& part) {
  if (layer.names == LayerCard::Names::material) return b.find(b.materials, "material", layer.id);
  if (layer.names == LayerCard::Names::nothing) return part.material;
  const Index other = b.part(layer.id);
  if (other == none) return none;
  const Index material = b.model.parts[other].material;
  if (material == none || std::holds_alternative<kernel::Laminate>(material_at(b, material).law))
    refuse(b, layer.id, fmt::format("part {} has no single material for the layer", layer.id.integer()),
           "name a part whose *PART gives a material");
  return material;
}

/// The laws of materials as layers have them.
class Laws {
 public:
  explicit Laws(Builder& builder) : b_(builder) {}

  /// Nothing, and a finding, for a law that layers cannot have.
  std::optional<kernel::ComposedLaw> find(Index material, const LayerCard& layer) {
    if (const auto found = laws_.find(material); found != laws_.end()) return found->second;
    const Material& m = material_at(b_, material);
    std::optional<kernel::LawComponents> made = components_of(m.law);
    if (!made || !for_shells(*made) || is_fabric(made->flow)) {
      refuse(b_, layer.id, fmt::format("*{} is not a law of a shell's layers", m.keyword),
             "give the layer the law of a sheet, e.g. *MAT_ELASTIC");
      return {};
    }
    const auto* compound = std::get_if<kernel::ComposedLaw>(&m.law);
    return laws_.emplace(material, compound ? *compound : kernel::composed_law(std::move(*made))).first->second;
  }

 private:
  Builder& b_;
  std::map<Index, kernel::ComposedLaw> laws_;
};

/// Material axes of a law at the start; null: it has none.
const kernel::MaterialAxes* axes_of(const Law& law) {
  const auto* compound = std::get_if<kernel::ComposedLaw>(&law);
  return compound ? axes_of(compound->components->flow) : nullptr;
}

bool same(const kernel::MaterialAxes& one, const kernel::MaterialAxes& other) {
  return one.by == other.by && one.angle == other.angle && norm(one.a - other.a) == 0.0 && norm(one.d - other.d) == 0.0;
}

/// The law of another part's material with the axes of the shells' own part, where both have axes: the other part gives
/// constants only (remarks of *INTEGRATION_SHELL).
kernel::ComposedLaw turned_as_own(Builder& b, const Part& part, const LayerCard& layer, const Material& material,
                                  const kernel::ComposedLaw& law) {
  const kernel::MaterialAxes* given = axes_of(law);
  const kernel::MaterialAxes* own = part.material == none ? nullptr : axes_of(material_at(b, part.material).law);
  if (layer.names != LayerCard::Names::part || given == nullptr || own == nullptr || same(*given, *own)) return law;
  layer.id.report(b.findings, Severity::warning,
                  fmt::format("AOPT and BETA of material {} are not looked at: a layer's axes are those of material "
                              "{}, of the shells' own part",
                              material.id, material_at(b, part.material).id),
                  "turn layers by B of *PART_COMPOSITE, or write the same axes in both materials");
  kernel::LawComponents turned = *law.components;
  *axes_of(turned.flow) = *own;
  return kernel::composed_law(std::move(turned));
}

/// What of a layer's card has no effect, or none that is built.
void check_layer(Builder& b, const LayerCard& layer, const kernel::ComposedLaw& law, const Material& material) {
  const bool has_axes = axes_of(law.components->flow) != nullptr;
  if (layer.angle != 0.0 && !has_axes)
    layer.id.report(b.findings, Severity::note,
                    fmt::format("the layer's angle has no effect: *{} has no axes", material.keyword));
  if (has_axes && b.model.control.laminated_shear)
    refuse(b, layer.id,
           fmt::format("laminated shell theory (LAMSHT of *CONTROL_SHELL) is not built for layers of *{}",
                       material.keyword),
           "write LAMSHT 0 and choose SHRF, or give the layer *MAT_ELASTIC");
  if (const auto* flow = std::get_if<kernel::Viscoplastic>(&law.components->flow);
      flow != nullptr && flow->anisotropy && !kernel::HillAnisotropy::is_convex(flow->anisotropy->of_layers()))
    refuse(b, layer.id, fmt::format("the ratios R00, R45, R90 of material {} are no ratios of Lankford", material.id),
           "give three above 0");
  if (const auto* flow = std::get_if<kernel::TabulatedRubber>(&law.components->flow);
      flow != nullptr && !flow->overstress.maxwell_branches.empty())
    refuse(b, layer.id, fmt::format("VISCO of material {} has no effect in shells", material.id),
           "write VISCO 0 there");
  if (const double points = law.components->points_to_delete; points == 1.0)
    layer.id.report(b.findings, Severity::note,
                    fmt::format("material {}: the first point of the layer that fails deletes the shell with all "
                                "its layers, as NUMFIP or NUMINT of 1 says",
                                material.id),
                    "write -100 there: it then goes with the last layer that can fail");
}

/// Points of one a layer bend as if each layer were thin: reported where that matters.
void report_bending(Builder& b, const Part& part, const kernel::Laminate& made) {
  const double share = kernel::share_of_bending(made);
  if (share > 0.97) return;
  b.findings.note(part.place, "*PART_COMPOSITE",
                  fmt::format("part {}: its layers, of one integration point each, have {:.0f} % of the bending "
                              "stiffness of classical laminate theory",
                              part.id, 100.0 * share),
                  "split thick layers into several of the same material");
}

/// Layers that know no failure do not keep a shell, which is not what who mixes them expects.
void report_failure(Builder& b, const Part& part, const std::vector<kernel::Laminate::Layer>& layers) {
  const auto fails = [](const kernel::Laminate::Layer& l) {
    return kernel::LawKernel<kernel::ComposedLaw>(l.law).can_fail();
  };
  const auto failing = std::count_if(layers.begin(), layers.end(), fails);
  if (failing == 0 || failing == static_cast<std::ptrdiff_t>(layers.size())) return;
  b.findings.warning(
      part.place, "*PART_COMPOSITE",
      fmt::format("part {}: a shell is deleted when the last of its layers that can fail has failed; the "
                  "{} whose material knows no failure do not keep it",
                  part.id, layers.size() - static_cast<std::size_t>(failing)),
      "give these a failure of their own, or use *INTEGRATION_SHELL with FAILOPT 1");
}

void make_layers_of(Builder& b, Laws& laws, Part& part, const LayerStack& stack) {
  std::vector<kernel::Laminate::Layer> layers;
  std::vector<int> ids;
  std::map<Index, kernel::ComposedLaw> turned;  // layers of one material share their law
  for (const LayerCard& card : stack.layers) {
    const Index material = material_of(b, card, part);
    if (material == none) continue;  // reported already
    const auto found = laws.find(material, card);
    if (!found) continue;
    const Material& m = material_at(b, material);
    if (!turned.contains(material)) turned.emplace(material, turned_as_own(b, part, card, m, *found));
    const kernel::ComposedLaw& law = turned.at(material);
    check_layer(b, card, law, m);
    layers.push_back({law, m.density, card.place, card.share, card.angle, card.shear_scale});
    ids.push_back(m.id);
  }
  if (layers.size() < stack.layers.size()) return;
  const bool composite = part.material == none;
  if (composite) report_failure(b, part, layers);
  kernel::Laminate made = kernel::laminate(std::move(layers), stack.kept_by_unfailing_layers);
  if (b.model.control.laminated_shear) kernel::use_laminated_shear(made);
  if (composite) report_bending(b, part, made);
  Material of_layers;
  of_layers.id = composite ? 0 : material_at(b, part.material).id;
  of_layers.title = fmt::format("{}", fmt::join(ids, " "));
  const bool has_rule = part.section != none && !b.model.shell_sections[part.section].rule.empty();
  of_layers.keyword = composite ? "PART_COMPOSITE" : has_rule ? "INTEGRATION_SHELL" : "SECTION_SHELL";
  of_layers.density = made.density;
  of_layers.law = std::move(made);
  of_layers.place = part.place;
  part.material = static_cast<Index>(b.model.materials.size());
  b.model.materials.push_back(std::move(of_layers));
}

/// Laminated glass: the material says what each layer is, the rule of the section where it lies.
void make_layers_of_glass(Builder& b, Part& part, const LayerStack* stack) {
  if (stack == nullptr)
    return b.findings.error(part.place, "*PART",
                            fmt::format("part {}: material {}, *MAT_LAMINATED_GLASS, needs the thickness of each layer",
                                        part.id, material_at(b, part.material).id),
                            "give them by *INTEGRATION_SHELL, and its id below 0 as QR/IRID of the section");
  Material made = material_at(b, part.material);
  std::vector<kernel::Laminate::Layer> layers = *std::get<kernel::Laminate>(made.law).layers;
  layers.resize(stack->layers.size());
  for (std::size_t k = 0; k < layers.size(); ++k) {
    layers[k].place = stack->layers[k].place;
    layers[k].share = stack->layers[k].share;
  }
  made.law = kernel::laminate(std::move(layers), true);
  part.material = static_cast<Index>(b.model.materials.size());
  b.model.materials.push_back(std::move(made));
}

/// Whether the layers need a law each. Angles turn nothing where a law has no axes, which is reported once.
bool differ(Builder& b, const Part& part, const LayerStack& stack) {
  if (b.model.control.laminated_shear) return true;
  const auto named = [](const LayerCard& l) { return l.names != LayerCard::Names::nothing; };
  if (std::any_of(stack.layers.begin(), stack.layers.end(), named)) return true;
  const auto turned =
      std::find_if(stack.layers.begin(), stack.layers.end(), [](const LayerCard& l) { return l.angle != 0.0; });
  if (turned == stack.layers.end() || part.material == none) return false;
  const Material& material = material_at(b, part.material);
  const auto made = components_of(material.law);
  if (!made || axes_of(made->flow) == nullptr)
    turned->id.report(
        b.findings, Severity::note,
        fmt::format("angles of layers have no effect in part {}: *{} has no axes", part.id, material.keyword));
  return made && axes_of(made->flow) != nullptr;
}

}  // namespace

void make_layers(Builder& b) {
  Laws laws(b);
  for (Part& part : b.model.parts) {
    if (part.kind != ElementKind::shell || part.section == none) continue;
    const auto stack = b.layer_stacks.find(part.section);
    if (part.material != none && std::holds_alternative<kernel::Laminate>(material_at(b, part.material).law)) {
      make_layers_of_glass(b, part, stack == b.layer_stacks.end() ? nullptr : &stack->second);
      continue;
    }
    if (stack == b.layer_stacks.end() || !differ(b, part, stack->second)) continue;
    if (part.material != none && !components_of(material_at(b, part.material).law)) continue;  // rigid, null
    make_layers_of(b, laws, part, stack->second);
  }
}

}  // namespace nugget::reading
