// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "assessment/metrics.h"

#include <cmath>

#include "assessment/motion_detail.h"
#include "assessment/motion_metrics.h"
#include "assessment/practice.h"
#include "assessment/tissue_metrics.h"

namespace placode::assessment {

std::vector<MetricDefinition> metric_definitions() {
    using enum Direction;
    return {
        {"task_time_s", "Time", "s", kLowerIsBetter,
         "From the first instrument in view to the end.", "universal"},
        {"ring_completeness_percent", "Ring completeness", "%", kHigherIsBetter,
         "Share of the planned contour's points that are cut through to the target depth within 1 "
         "mm, "
         "as the picture shows it.",
         "Placode"},
        {"largest_gap_mm", "Largest gap", "mm", kLowerIsBetter,
         "Longest stretch of the planned contour without a point that is cut.", "Placode"},
        {"contour_deviation_mm", "Deviation from the plan", "mm", kLowerIsBetter,
         "Mean distance of the kerf's centre from the planned contour.", "Placode"},
        {"contour_deviation_p95_mm", "Deviation, 95th percentile", "mm", kLowerIsBetter,
         "95th percentile of the distance of the kerf's centre from the planned contour.",
         "Placode"},
        {"contour_deviation_max_mm", "Deviation, largest", "mm", kLowerIsBetter,
         "Largest distance of the kerf's centre from the planned contour.", "Placode"},
        {"contour_hausdorff_mm", "Hausdorff distance", "mm", kLowerIsBetter,
         "Largest distance from the kerf's centre to the plan or from the plan to it.",
         "Hausdorff, both directions"},
        {"contour_signed_mm", "Deviation, signed", "mm", kNeutral,
         "Mean signed distance: negative towards the placode, positive outwards.", "Placode"},
        {"kerf_width_mm", "Width of the kerf", "mm", kLowerIsBetter,
         "Mean width of what was removed along the contour.", "Placode"},
        {"off_line_mm", "Length off the planned line", "mm", kLowerIsBetter,
         "Length of the incision whose centre is more than 0.5 mm off the plan, or that reaches "
         "into "
         "healthy skin or to the placode.",
         "Placode"},
        {"outside_band_mm", "Length in healthy skin", "mm", kLowerIsBetter,
         "Length of the contour beside which tissue over 1 mm outside the skin edge was removed.",
         "Placode"},
        {"toward_placode_mm", "Length too near the placode", "mm", kLowerIsBetter,
         "Length of the contour beside which tissue within 0.5 mm of the placode was removed.",
         "Placode"},
        {"placode_contacts", "Placode contacts", "", kLowerIsBetter,
         "Times an instrument touched the placode.", "Placode"},
        {"placode_contact_s", "Placode contact time", "s", kLowerIsBetter,
         "Total time an instrument touched the placode.", "Placode"},
        {"placode_peak_force_mn", "Peak force on the placode", "mN", kLowerIsBetter,
         "Largest contact force on the placode.", "Placode"},
        {"placode_energised_s", "Energised placode contact", "s", kLowerIsBetter,
         "Time an energised instrument touched the placode.", "Placode"},
        {"placode_peak_cem43_min", "Placode thermal dose", "min", kLowerIsBetter,
         "Largest thermal dose in the placode, equivalent minutes at 43 C, at most 1e6.",
         "Sapareto & Dewey 1984"},
        {"placode_peak_c", "Placode peak temperature", "C", kLowerIsBetter,
         "Highest temperature in the placode.", "Placode"},
        {"placode_arrhenius", "Placode heat damage", "", kLowerIsBetter,
         "Arrhenius integral of the placode's highest temperature with constants of skin: an upper "
         "bound, 1 = 63 % dead, at most 1e6.",
         "Henriques & Moritz 1947"},
        {"placode_overheated", "Placode overheated", "", kLowerIsBetter,
         "Places of the placode, squares of 2 mm, where tissue passed the warning dose.",
         "Placode"},
        {"placode_burned_percent", "Placode burned", "%", kLowerIsBetter,
         "Share of the placode's volume beyond the injury dose or temperature.", "Placode"},
        {"placode_cut_mm3", "Placode cut", "mm3", kLowerIsBetter,
         "Volume of the placode that was removed or torn.", "Placode"},
        {"energy_activations", "Activations", "", kNeutral, "Times the energy was switched on.",
         "Placode"},
        {"energy_on_s", "Energy on", "s", kLowerIsBetter, "Time with the pedal down.", "Placode"},
        {"energy_in_air_s", "Energy in the air", "s", kLowerIsBetter,
         "Time with the pedal down and no contact with tissue.", "Placode"},
        {"energy_in_air_count", "Activations in the air", "", kLowerIsBetter,
         "Times the pedal was down in the air for over 1 s.", "Placode"},
        {"energy_near_placode_s", "Energy near the placode", "s", kLowerIsBetter,
         "Time with the pedal down and the tip within 1 mm of the placode, or over it.", "Placode"},
        {"energy_j", "Energy delivered", "J", kLowerIsBetter, "Energy that reached tissue.",
         "Placode"},
        {"dwell_s", "Resting on one spot", "s", kLowerIsBetter,
         "Time of those activations that stayed on one spot for over 1 s.", "Placode"},
        {"buried_s", "Tip below the surface", "s", kLowerIsBetter,
         "Time with the tip of an instrument below the surface, spells over 0.3 s.", "Placode"},
        {"buried_count", "Times below the surface", "", kLowerIsBetter,
         "Times that the tip of an instrument was below the surface for over 0.3 s.", "Placode"},
        {"peak_force_mn", "Peak force", "mN", kLowerIsBetter,
         "Largest force of an instrument on tissue.", "Placode"},
        {"over_force_count", "Too much force", "", kLowerIsBetter,
         "Times the force was above the scene's limit.", "Placode"},
        {"over_force_s", "Time with too much force", "s", kLowerIsBetter,
         "Time with the force above the scene's limit.", "Placode"},
        {"torn_volume_mm3", "Torn tissue", "mm3", kLowerIsBetter,
         "Rest volume of elements torn by stretch.", "Placode"},
        {"torn_skin_mm3", "Torn skin", "mm3", kLowerIsBetter,
         "Rest volume of skin elements torn by stretch.", "Placode"},
        {"released_deg", "Placode released", "deg", kHigherIsBetter,
         "Sectors of 5 degrees in which no tissue leads from the placode to the skin.", "Placode"},
        {"placode_snip_mm2", "Placode cut by scissors", "mm2", kLowerIsBetter,
         "Area over which scissors parted placode from placode.", "Placode"},
        {"skin_snip_mm2", "Skin cut by scissors", "mm2", kLowerIsBetter,
         "Area of snips that went mostly through skin.", "Placode"},
        {"snips", "Snips", "", kNeutral, "Times that scissors closed on tissue.", "Placode"},
        {"pieces_out", "Pieces taken out", "", kHigherIsBetter,
         "Loose pieces drawn back to the port.", "Placode"},
        {"resected_mm3", "Resected tissue", "mm3", kNeutral, "Rest volume of these pieces.",
         "Placode"},
        {"resected_percent", "Marked tissue resected", "%", kHigherIsBetter,
         "Share of the marked volume that was drawn out of the field in pieces; what burned, tore "
         "or "
         "was washed away does not count.",
         "Placode"},
        {"marked_gone_percent", "Marked tissue gone", "%", kHigherIsBetter,
         "Share of the marked volume that is no longer there, taken out or destroyed, as the "
         "picture "
         "shows it.",
         "Placode"},
        {"marked_lost_percent", "Marked tissue destroyed", "%", kLowerIsBetter,
         "Share of the marked volume that burned, tore or was washed away as crumbs.", "Placode"},
        {"grasps", "Grasps", "", kNeutral, "Times that jaws closed on tissue.", "Placode"},
        {"lift_hold_s", "Held lifted", "s", kHigherIsBetter,
         "Time during which held tissue was at least 0.7 mm above where it was grasped.",
         "Placode"},
        {"slip_count", "Slips of the grasper", "", kLowerIsBetter,
         "Times that tissue slid out of the jaws.", "Placode"},
        {"crush_count", "Crushed", "", kLowerIsBetter,
         "Grasps with a jaw pressure above the tissue's limit.", "Placode"},
        {"over_traction_count", "Pulled too hard", "", kLowerIsBetter,
         "Pulls above the tissue's limit for over 0.3 s.", "Placode"},
        {"peak_traction_mn", "Peak traction", "mN", kLowerIsBetter,
         "Largest pull of held tissue on the jaws.", "Placode"},
        {"path_length_mm", "Path length", "mm", kLowerIsBetter,
         "Way of the instrument tips, filtered at 10 Hz, 100 Hz.", "Chmarra et al. 2008"},
        {"depth_path_mm", "Depth path", "mm", kLowerIsBetter,
         "Way of the tips along their own shafts.", "Cotin et al. 2002"},
        {"angular_path_deg", "Angular path", "deg", kLowerIsBetter,
         "Total rotation of the instruments.", "PerkTutor"},
        {"mean_speed_mm_s", "Mean speed", "mm/s", kNeutral, "Path length over time.",
         "Chmarra et al. 2008"},
        {"movements", "Movements", "", kLowerIsBetter,
         "Times a tip's speed rose through 20 mm/s after having been below 10 mm/s.",
         "after ICSAD"},
        {"idle_time_s", "Idle time", "s", kLowerIsBetter,
         "Time with all instruments below 1 mm/s and no pedal down.", "after Oropesa et al. 2013"},
        {"sparc", "Smoothness (SPARC)", "", kHigherIsBetter,
         "Spectral arc length, median over movements above 5 mm/s that last 0.3 s or more.",
         "Balasubramanian et al. 2015"},
        {"ldlj_vector", "Smoothness (LDLJ-V)", "", kHigherIsBetter,
         "Log dimensionless jerk of the vector velocity, median over the same movements.",
         "Balasubramanian et al. 2015"},
        {"ldlj_speed", "Smoothness (LDLJ)", "", kHigherIsBetter,
         "Log dimensionless jerk of the speed, median over the same movements.",
         "Balasubramanian et al. 2015"},
        {"out_of_view_s", "Out of view", "s", kLowerIsBetter,
         "Time that instrument tips were outside the picture.", "Placode"},
        {"out_of_view_count", "Times out of view", "", kLowerIsBetter,
         "Times that an instrument tip left the picture.", "Placode"},
        {"out_of_view_percent", "Share out of view", "%", kLowerIsBetter,
         "Share of the time that instrument tips were outside the picture.", "Placode"},
        {"idle_percent", "Idle share", "%", kLowerIsBetter, "Idle time over the whole time.",
         "after Oropesa et al. 2013"},
        {"roll_path_deg", "Rotation about the shaft", "deg", kLowerIsBetter,
         "Total rotation of the instruments about their own shafts.", "Cotin et al. 2002"},
        {"pitch_path_deg", "Pitch path", "deg", kLowerIsBetter,
         "Total change of the shafts' direction up and down, seen from the first pose.",
         "after Ershad et al. 2018"},
        {"yaw_path_deg", "Yaw path", "deg", kLowerIsBetter,
         "Total change of the shafts' direction to the sides, seen from the first pose.",
         "after Ershad et al. 2018"},
        {"cutting_economy", "Economy of cutting", "", kHigherIsBetter,
         "Planned contour that was cut, over the way of the tip while energy was on.", "Placode"},
        {"economy_of_volume", "Economy of volume", "", kNeutral,
         "Cube root of the box around the tip's way over its length, busiest instrument.",
         "Oropesa et al. 2013"},
        {"working_volume_mm3", "Working volume", "mm3", kNeutral,
         "Box around the way of the busiest instrument's tip.", "PerkTutor"},
        {"economy_of_motion", "Economy of motion", "", kHigherIsBetter,
         "Straight lines over the ways of the tips, over the movements of SPARC.",
         "after Oropesa et al. 2013"},
        {"translational_actions", "Translational actions", "", kLowerIsBetter,
         "Times a tip moved faster than 50 mm/s for over 0.2 s.", "PerkTutor"},
        {"rotational_actions", "Rotational actions", "", kLowerIsBetter,
         "Times an instrument turned faster than 50 degrees a second for over 0.2 s.", "PerkTutor"},
        {"jerk_normalised", "Normalised jerk", "", kLowerIsBetter,
         "Root of squared jerk without unit, median over the movements of SPARC; 19 at best.",
         "Chmarra et al. 2008"},
        {"speed_peaks_per_min", "Speed peaks", "1/min", kLowerIsBetter,
         "Local maxima of the tips' speeds above 20 mm/s, per minute.", "after PMC5845064"},
        {"path_length_left_mm", "Path length, left hand", "mm", kLowerIsBetter,
         "Way of the left hand's instrument.", "Chmarra et al. 2008"},
        {"path_length_right_mm", "Path length, right hand", "mm", kLowerIsBetter,
         "Way of the right hand's instruments.", "Chmarra et al. 2008"},
        {"bimanual_r", "Hands together", "", kNeutral, "Correlation of the hands' speeds.",
         "Hofstad et al. 2013"},
        {"bimanual_balance", "Balance of hands", "", kHigherIsBetter,
         "Shorter over longer way of the two hands.", "SurgTrac"},
        {"both_moving_percent", "Both hands moving", "%", kHigherIsBetter,
         "Share of the time with both hands above 5 mm/s.", "Placode"},
        {"left_only_percent", "Left hand alone moving", "%", kNeutral,
         "Share of the time with the left hand alone above 5 mm/s.", "Placode"},
        {"right_only_percent", "Right hand alone moving", "%", kNeutral,
         "Share of the time with the right hand alone above 5 mm/s.", "Placode"},
        {"neither_moving_percent", "No hand moving", "%", kLowerIsBetter,
         "Share of the time with no hand above 5 mm/s.", "Placode"},
        {"bimanual_rotation_r", "Hands turning together", "", kNeutral,
         "Correlation of the hands' angular speeds.", "Hofstad et al. 2013"},
        {"tremor_rms_mm", "Tremor", "mm", kLowerIsBetter,
         "Root of the tip's power from 8 to 12 Hz, unfiltered, worst instrument.", "Welch 1967"},
        {"tremor_acceleration_mm_s2", "Tremor, acceleration", "mm/s2", kLowerIsBetter,
         "Root of the power of the tip's acceleration from 8 to 12 Hz, unfiltered, worst "
         "instrument.",
         "Welch 1967"},
        {"mean_force_mn", "Mean force", "mN", kLowerIsBetter,
         "Mean force of instruments on tissue while they touch it.", "Placode"},
        {"rms_force_mn", "RMS force", "mN", kLowerIsBetter, "Root mean square of that force.",
         "Placode"},
        {"force_impulse_mn_s", "Impulse of force", "mN s", kLowerIsBetter,
         "Force on tissue summed up over time.", "Placode"},
        {"excess_impulse_mn_s", "Impulse of too much force", "mN s", kLowerIsBetter,
         "What the force was above the scene's limit, summed up over time.", "Placode"},
        {"placode_impulse_mn_s", "Impulse on the placode", "mN s", kLowerIsBetter,
         "Force on the placode summed up over time.", "Placode"},
        {"contour_deviation_rms_mm", "Deviation, RMS", "mm", kLowerIsBetter,
         "Root mean square of the distance of the kerf's centre from the planned contour.",
         "Placode"},
        {"gap_count", "Gaps", "", kLowerIsBetter,
         "Stretches of the planned contour without a point that is cut.", "Placode"},
        {"over_stretch_count", "Over-stretched", "", kLowerIsBetter,
         "Times that tissue was stretched beyond its injury limit.", "Placode"},
        {"max_stretch", "Largest stretch", "", kLowerIsBetter,
         "Largest principal stretch beyond that limit, 1 = at rest.", "Placode"},
        {"over_stretch_mm3_s", "Over-stretched volume and time", "mm3 s", kLowerIsBetter,
         "Rest volume beyond its injury stretch times how long, spells over 50 ms.", "Placode"},
        {"thermal_spread_mm", "Thermal spread", "mm", kLowerIsBetter,
         "Mean distance from the edge of the incision to where heat damage (Omega) falls to 1, on "
         "both sides, along rays across the plan.",
         "Placode, Arrhenius constants of liver"},
        {"thermal_spread_p95_mm", "Thermal spread, 95th percentile", "mm", kLowerIsBetter,
         "95th percentile of that distance.", "Placode"},
        {"thermal_spread_max_mm", "Thermal spread, largest", "mm", kLowerIsBetter,
         "Largest of these distances; 4 at most.", "Placode"},
        {"dose_spread_mm", "Spread of the thermal dose", "mm", kLowerIsBetter,
         "Mean distance from the edge of the incision to where the dose falls to 240 equivalent "
         "minutes at 43 C.",
         "Sapareto & Dewey 1984"},
        {"dose_spread_p95_mm", "Spread of the thermal dose, 95th percentile", "mm", kLowerIsBetter,
         "95th percentile of that distance.", "Placode"},
        {"dose_spread_max_mm", "Spread of the thermal dose, largest", "mm", kLowerIsBetter,
         "Largest of these distances; 4 at most.", "Placode"},
        {"steps_done_percent", "Steps done", "%", kHigherIsBetter,
         "Share of the task's steps that were done.", "Placode"},
        {"target_error_mm", "Distance from targets", "mm", kLowerIsBetter,
         "Mean distance from the target's centre where tissue was first touched.", "Placode"},
        {"target_misses", "Targets missed", "", kLowerIsBetter,
         "Times that tissue was touched or grasped beside the target.", "Placode"},
        {"trace_coverage_percent", "Contour followed", "%", kHigherIsBetter,
         "Share of the planned contour along which the tip passed within 1 mm.", "Placode"},
        {"trace_error_mm", "Distance from the line", "mm", kLowerIsBetter,
         "Mean distance of the tip from the planned contour while it was followed.", "Placode"},
        {"trace_error_p95_mm", "Distance from the line, 95th percentile", "mm", kLowerIsBetter,
         "95th percentile of that distance, over stretches of 5 degrees.", "Placode"},
        {"traction_held_s", "Traction held", "s", kHigherIsBetter,
         "Time during which both hands pulled within the task's limits.", "Placode"},
    };
}

std::optional<double> MetricSet::find(std::string_view id) const {
    for (const Metric& metric : values) {
        if (metric.id == id) return metric.value;
    }
    return std::nullopt;
}

MetricSet compute_metrics(const sim::Recording& recording) {
    std::vector<Metric> found;
    add_motion_metrics(recording, found);
    add_motion_details(recording, found);
    add_tissue_metrics(recording, found);
    add_practice_metrics(recording, found);
    // In the order of the definitions; what is not finite is not known.
    MetricSet set;
    for (const MetricDefinition& definition : metric_definitions()) {
        for (const Metric& metric : found) {
            if (metric.id == definition.id && std::isfinite(metric.value))
                set.values.push_back(metric);
        }
    }
    return set;
}

const MetricDefinition* metric_definition(std::string_view id) {
    static const std::vector<MetricDefinition> all = metric_definitions();
    for (const MetricDefinition& definition : all)
        if (definition.id == id) return &definition;
    return nullptr;
}

}  // namespace placode::assessment
