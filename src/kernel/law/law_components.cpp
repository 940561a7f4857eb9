// SPDX-License-Identifier: Apache-2.0
#include "kernel/law/law_components.hpp"

namespace nugget::kernel {

LawComponents::LawComponents(Flow of_points) : flow(std::move(of_points)) {}
LawComponents::LawComponents(const LawComponents&) = default;
LawComponents::LawComponents(LawComponents&&) noexcept = default;
LawComponents& LawComponents::operator=(const LawComponents&) = default;
LawComponents& LawComponents::operator=(LawComponents&&) noexcept = default;
LawComponents::~LawComponents() = default;

}  // namespace nugget::kernel
