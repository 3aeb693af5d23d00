// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// What an instrument carries from frame to frame, and what a vertex remembers of it.
#include <array>
#include <cstdint>
#include "sim/core/fields.h"
#include "sim/core/geometry.h"
#include "sim/core/tissue.h"

namespace placode::sim {

/// Where a tool is and what it does, between frames.
struct ToolState {
    Pose proxy;                    ///< Real pose, pushed back by tissue.
    Pose previous;                 ///< Proxy at the end of the previous frame.
    Vec3 force_n = Vec3::Zero();   ///< Force of tissue on the tool, mean over the frame [N].
    Vec3 steel_n = Vec3::Zero();   ///< Force of other instruments on it, mean over the frame [N].
    Vec3 needle_n = Vec3::Zero();  ///< Share of force_n that comes through a needle in the jaws.
    Vec3 friction_anchor = Vec3::Zero();
    double tip_gap_m = 1;  ///< Signed distance of the tip to the surface, negative inside.
    Tissue touched = Tissue::kSkin;  ///< Tissue next to the tip, valid when in_contact.
    uint8_t in_contact = 0, energised = 0;
    double power_in_tissue_w = 0;  ///< Delivered in the last frame.

    Pose hand;  ///< Where the hand held it at the end of the last frame.
    double stiffness_n_m =
        0;  ///< What the touched tissue answers at once, mean of the frame [N/m].
    Vec3 substep_force_n = Vec3::Zero();  ///< Of the last substep.
    double substep_stiffness_n_m = 0;     ///< Of the last substep.
    double substep_overlap_m = 0;         ///< Deepest contact at its end.
    double bare_gap_m = 1;  ///< Signed distance of bare metal to the surface, 1 = farther than the
                            ///< contact margin.
    Vec3 spot = Vec3::Zero();       ///< Point of the surface next to the bare metal, in W [m].
    Vec3 rest_spot = Vec3::Zero();  ///< The same at rest [m].
    int32_t spot_tet = -1;          ///< Tet behind it.
    double placode_force_n = 0;     ///< Mean over the frame.
    double gap_m = 1;  ///< Signed distance of the whole instrument to the surface, 1 = farther than
                       ///< the contact margin.
    float contact_share = 1;  ///< Share of the contact force that is let through: small while the
                              ///< needle cuts, and rising after it or after the hand came back.
    float jaw_rad = 0;
    uint8_t pedals = 0, engaged = 0, coagulating = 0;
};
template <class Visit>
void fields(Of<ToolState> auto& s, Visit&& visit) {
    auto& [proxy, previous, force_n, steel_n, needle_n, friction_anchor, tip_gap_m, touched,
           in_contact, energised, power_in_tissue_w, hand, stiffness_n_m, substep_force_n,
           substep_stiffness_n_m, substep_overlap_m, bare_gap_m, spot, rest_spot, spot_tet,
           placode_force_n, gap_m, contact_share, jaw_rad, pedals, engaged, coagulating] = s;
    visit.state(proxy, previous, force_n, steel_n, needle_n, friction_anchor, tip_gap_m, touched,
                in_contact, energised, power_in_tissue_w, hand, stiffness_n_m, substep_force_n,
                substep_stiffness_n_m, substep_overlap_m, bare_gap_m, spot, rest_spot, spot_tet,
                placode_force_n, gap_m, contact_share, jaw_rad, pedals, engaged, coagulating);
}

/// Where a vertex sticks to an instrument (dry friction has a memory).
struct FrictionAnchor {
    std::array<float, 3> anchor_T{};  ///< Point of the tool, in T [m].
    int8_t tool = -1;                 ///< -1 = none.
    uint8_t slipping = 0;             ///< Counts down the substeps since it slipped; 0 = sticks.
};
template <class Visit>
void fields(Of<FrictionAnchor> auto& s, Visit&& visit) {
    auto& [anchor_T, tool, slipping] = s;
    visit.state(anchor_T, tool, slipping);
}

}  // namespace placode::sim
