// SPDX-License-Identifier: Apache-2.0
#include "impact/contact/contacts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

#include "impact/contact/contact_setup.hpp"
#include "impact/contact/edge_setup.hpp"
#include "model/contact_form.hpp"
#include "model/history_files.hpp"

namespace nugget::impact {
namespace {

void report_tiebreak(const model::Contact& card, const contact::Glue& glue, Findings& findings) {
  if (card.birth > 0.0)
    findings.note(
        card.place, '*' + card.keyword,
        fmt::format("what of SURFA touches SURFB at BT = {:g} is held there by springs from then on; how many "
                    "nodes that are stands in run.log",
                    card.birth));
  else if (glue.at_start() > 0)
    findings.note(card.place, '*' + card.keyword,
                  fmt::format("{} nodes of SURFA are glued to SURFB at the start", glue.at_start()));
  else if (!card.glue->bonds_later)
    findings.warning(card.place, '*' + card.keyword, "no node of SURFA touches SURFB at the start: nothing is glued",
                     "check the sides, and the gap between them against the thicknesses (SFSAT, SFSBT, SAST, SBST)");
}

}  // namespace

Contacts::Contacts(const system::System& system, std::span<const Row> x, Findings& findings) : system_(&system) {
  // Every rank has the gas, and looks at what contact covers of its fabric.
  const auto covered = [](const model::PorousFabric& fabric) { return fabric.covered_by_contact; };
  const bool covers_fabric = std::ranges::any_of(system.model.control_volumes, [&](const model::ControlVolume& volume) {
    return std::ranges::any_of(volume.flowing.fabric, covered);
  });
  const auto is_transducer = [](const model::Contact& card) { return card.kind == model::Contact::Kind::transducer; };
  const bool shows_hits = std::ranges::any_of(system.model.contacts, is_transducer);
  // The first rank writes forces by node, and transducers look at all contacts.
  const bool by_node = system.model.requests["ncforc"].asked();
  const auto prints = [](const model::Contact& card) { return card.prints_a || card.prints_b; };
  const bool all_by_node = by_node && std::ranges::any_of(system.model.contacts, [&](const model::Contact& card) {
                             return is_transducer(card) && prints(card);
                           });
  const contact::SurfaceChoice nothing{[](const contact::Segment&) { return false; }, [](int) { return false; }};
  for (const model::Contact& card : system.model.contacts) {
    if (card.ties_what_touches())
      findings.error(card.place, '*' + card.keyword,
                     "an explicit run does not have it: it ties parts that touch for modes, responses and statics",
                     "write *CONTACT_AUTOMATIC_SINGLE_SURFACE, without the card of CLOSE, for the explicit run; "
                     "`nugget modes` takes the deck as it is");
    if (!card.slides()) continue;
    const bool looked_at = covers_fabric || all_by_node || (by_node && prints(card));
    const bool by_share = system.starts_with_share() && !looked_at && !shows_hits && !model::checks_edges(card) &&
                          !card.glue && !card.balances_friction;
    contact::SurfaceContactSetup setup = contact_setup(system, card, by_share ? &nothing : nullptr);
    auto edges = edge_setup(system, card, setup, x);
    const std::size_t segments = setup.whole ? setup.whole->segments : setup.segments.size();
    if (segments == 0 && !(edges && !edges->edges.empty())) {
      findings.error(card.place, '*' + card.keyword,
                     "the contact has no segments: none of its parts has shells or bricks",
                     "check SURFA and SURFATYP; beams alone are pressed by _GENERAL");
      continue;
    }
    contacts_.emplace_back(std::move(setup), std::move(edges), card.glue, x);
    control_.push_back(card.control);
    card_.push_back(&card);
    if (looked_at) contacts_.back().look_everywhere();
    if (card.glue) report_tiebreak(card, *contacts_.back().glue(), findings);
  }
  if (shows_hits)
    for (contact::PenaltyContact& c : contacts_) c.keep_hits_for_results();
}

contact::SurfaceSource Contacts::source(std::size_t c) const {
  return [this, c](const contact::SurfaceChoice& choice) { return contact_setup(*system_, *card_[c], &choice); };
}

void Contacts::apply(const contact::Step& step, const system::State& state, std::span<Row> force) {
  contact::Step now = step;
  // While nothing is deleted no pair need look at what its elements are.
  const std::span<const unsigned char>& alive = step.element_alive;
  if (!alive.empty() && std::memchr(alive.data(), 0, alive.size()) == nullptr) now.element_alive = {};
  for (std::size_t c = 0; c < contacts_.size(); ++c) {
    now.off = !state.acts(control_[c]);
    contacts_[c].apply(now, force);
  }
}

void Contacts::elements_deleted(bool faces) {
  for (contact::PenaltyContact& c : contacts_) c.elements_deleted(faces);
}

std::vector<std::string> Contacts::glue_summary(const system::System& system) const {
  std::vector<std::string> lines;
  std::size_t next = 0;
  for (const model::Contact& card : system.model.contacts) {
    if (!card.slides()) continue;
    const contact::Glue* glue = contacts_[next++].glue();
    if (glue == nullptr) continue;
    std::string line = fmt::format("glue of contact {}: {} nodes at the start", card.id, glue->at_start());
    if (card.glue->bonds_later || card.birth > 0.0) line += fmt::format(", {} later", glue->later());
    line += fmt::format("; {} failed", glue->failed());
    if (glue->failed() > 0)
      line += fmt::format(", node {} first at time={:.5E}, the last at time={:.5E}", system.node_id(glue->first_node()),
                          glue->first_time(), glue->last_time());
    lines.push_back(std::move(line));
  }
  return lines;
}

contact::ContactEnergies Contacts::energies() const {
  contact::ContactEnergies all;
  for (const contact::PenaltyContact& c : contacts_) all.add(c.energies());
  return all;
}

std::vector<std::string> Contacts::drop_summary(const system::System& system) const {
  std::vector<std::string> lines;
  std::size_t next = 0;
  for (const model::Contact& card : system.model.contacts) {
    if (!card.slides()) continue;
    const contact::Drops drops = contacts_[next++].energies().drops;
    if (drops.count == 0) continue;
    lines.push_back(
        fmt::format("contact {} dropped {} springs under load, which held {:.3e}; the largest held {:.3e}, at node {} "
                    "against node {}, time={:.5E}",
                    card.id, drops.count, drops.energy, drops.largest, system.node_id(drops.node),
                    system.node_id(drops.other), drops.time));
  }
  return lines;
}

std::string Contacts::giving_most(const system::System& system) const {
  const model::Contact* least = nullptr;
  double energy = 0.0;
  std::size_t next = 0;
  for (const model::Contact& card : system.model.contacts) {
    if (!card.slides()) continue;
    const double own = contacts_[next++].energy();
    if (least != nullptr && own >= energy) continue;
    least = &card;
    energy = own;
  }
  return least != nullptr ? fmt::format("in contact {} (*{})", least->id, least->keyword) : "in springs of ties";
}

void Contacts::add_energy(Energy& energy) const {
  for (const contact::PenaltyContact& c : contacts_) energy.contact += c.energy();
}

}  // namespace nugget::impact
