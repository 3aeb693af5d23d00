// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// What every metric measures, in the words of assessment/metric_definitions.cpp: listed here so
// that the translation tool finds them; a test compares the list with what is said there.

#include <QtGlobal>

namespace {

[[maybe_unused]] const char* const kMetricDefinitions[] = {
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the marked volume that is no longer there, taken out or destroyed, "
                      "as the picture shows it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the marked volume that burned, tore or was washed away as crumbs."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Time with the tip of an instrument inside tissue that it was pushed through; "
        "only periods longer than 0.3 s; a tip in a hole that was cut or torn is not stuck."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that the tip of an instrument was inside tissue that it was pushed "
                      "through for over 0.3 s."),
    QT_TRANSLATE_NOOP("MetricDefinition", "From the first instrument in view to the end."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the planned contour's points that are cut through to the target "
                      "depth within 1 mm, "
                      "as the picture shows it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Longest stretch of the planned contour without a point that is cut."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean distance of the kerf's centre from the planned contour."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "95th percentile of the distance of the kerf's centre from the planned contour."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest distance of the kerf's centre from the planned contour."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Largest distance from the kerf's centre to the plan or from the plan to it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean signed distance: negative towards the placode, positive outwards."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Mean width of what was removed along the contour."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Length of the incision whose centre is more than 0.5 mm off the plan, or "
                      "that reaches into "
                      "healthy skin or to the placode."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Length of the contour beside which tissue over 1 mm outside the skin edge was removed."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Length of the contour beside which tissue within 0.5 mm of the placode was removed."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times an instrument, needle or thread pressed on the placode with more than "
                      "the force that the scene warns of."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Total time an instrument, needle or thread pressed on the placode with more "
                      "than that force."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Largest contact force on the placode."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Time an energised instrument touched the placode, with whatever force."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Largest thermal dose in the placode, equivalent minutes at 43 C, at most 1e6."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Highest temperature in the placode."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Arrhenius integral of the placode's highest temperature with constants of "
                      "skin: an upper bound, 1 = 63 % dead, at most 1e6."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Places of the placode, squares of 2 mm, where tissue passed the warning dose."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the placode's volume beyond the injury dose or temperature."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Volume of the placode that heat removed or stretch tore; pulling or "
                      "pressing beside it tears it, too, without a contact."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times the energy was switched on."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Time with the pedal down."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Time with the pedal down and no contact with tissue."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times the pedal was down in the air for over 1 s; taps with pauses of up to "
                      "1 s count together."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Time with the pedal down and the tip within 1 mm of the placode, or over it."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Energy that reached tissue."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Time of energy that stayed on one spot for over 1 s; taps with pauses of up "
                      "to 1 s count together."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Largest force of an instrument on tissue."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times the force was above the scene's limit, and once more for each 2 s "
                      "that it was; a spell that begins within 3 s of the last one's end counts as "
                      "the share of 3 s between them."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Time with the force above the scene's limit."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Undeformed volume of elements torn by stretch, and of tissue that left with "
                      "a loose piece though it was not to go."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Undeformed volume of skin elements torn by stretch, and of healthy skin "
                      "that left with a loose piece."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Undeformed volume of skin that heat removed more than 1 mm outside the "
                      "lesion's edge, however far from the plan."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Energy that reached skin more than 1 mm outside the lesion's edge, whether "
                      "it removed any or not."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Sectors of 5 degrees in which no tissue leads from the placode to the skin."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Area over which scissors parted placode from placode."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Area of snips that went mostly through skin."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times that scissors closed on tissue."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Loose pieces drawn back to the port."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Undeformed volume of these pieces."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the marked volume that was drawn out of the field in pieces; what "
                      "burned, tore or was washed away does not count."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times that jaws closed on tissue."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Time during which held tissue was at least 0.7 mm above where it was grasped."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times that tissue slid out of the jaws."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Grasps with a jaw pressure above the tissue's limit, each once more for "
                      "each 2 s that the jaws stayed shut as far."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Pulls above the tissue's limit for over 0.3 s, tugs with pauses of up to "
                      "0.3 s as one, and "
                      "once more for each 2 s of them; one that begins within 3 s of the last "
                      "one's end counts as "
                      "the share of 3 s between them."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Largest pull of held tissue on the jaws."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Length of the paths of the instrument tips, filtered at 10 Hz, 100 Hz."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Path of the tips along their own shafts."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Total rotation of the instruments."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Path length over time."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times a tip's speed rose through 20 mm/s after having been below 10 mm/s."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Time with all instruments below 1 mm/s and no pedal down."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Spectral arc length, median over movements above 5 mm/s that last 0.3 s or more."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Log dimensionless jerk of the vector velocity, median over the same movements."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Log dimensionless jerk of the speed, median over the same movements."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Time that instrument tips were outside the picture."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times that an instrument tip left the picture."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the time that instrument tips were outside the picture."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Idle time over the whole time."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Total rotation of the instruments about their own shafts."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Total change of the shafts' direction up and down, seen from the first pose."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Total change of the shafts' direction to the sides, seen from the first pose."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Planned contour that was cut, over the path of the tip while energy was on."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Cube root of the box around the tip's path over its length, busiest instrument."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Box around the path of the busiest instrument's tip."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Straight lines over the paths of the tips, over the movements of SPARC."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times a tip moved faster than 50 mm/s for over 0.2 s."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times an instrument turned faster than 50 degrees a second for over 0.2 s."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Dimensionless root-squared jerk, median over the movements of SPARC; 19 at best."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Local maxima of the tips' speeds above 20 mm/s, per minute."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Way of the left hand's instrument."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Way of the right hand's instruments."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Correlation of the hands' speeds."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Shorter path divided by the longer one, of the two hands."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Share of the time with both hands above 5 mm/s."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the time with the left hand alone above 5 mm/s."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the time with the right hand alone above 5 mm/s."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Share of the time with no hand above 5 mm/s."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Correlation of the hands' angular speeds."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Root of the tip's power from 8 to 12 Hz, unfiltered, worst instrument."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Root of the power of the tip's acceleration from 8 to 12 Hz, unfiltered, "
                      "worst instrument."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean force of instruments on tissue while they touch it."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Root mean square of that force."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Force on tissue summed up over time."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "What the force was above the scene's limit, summed up over time."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Force on the placode summed up over time."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Root mean square of the distance of the kerf's centre from the planned contour."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Stretches of the planned contour without a point that is cut."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that tissue was stretched beyond its injury limit."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest principal stretch beyond that limit, 1 = at rest."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Undeformed volume beyond its injury stretch times how long; only periods "
                      "longer than 50 ms."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean distance from the edge of the incision to where heat damage (Omega) "
                      "falls to 1, on both sides, along rays across the plan."),
    QT_TRANSLATE_NOOP("MetricDefinition", "95th percentile of that distance."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Largest of these distances; 4 at most."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean distance from the edge of the incision to where the dose falls to 240 "
                      "equivalent minutes at 43 C."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Share of the task's steps that were done."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean distance from the target's centre where tissue was first touched, one "
                      "touch a target."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that tissue was touched or grasped beside the target."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the planned contour along which the tip passed within 1 mm."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean distance of the tip from the planned contour over stretches of 5 "
                      "degrees, of each its worst pass; beyond 3 mm a pass counts where the tip "
                      "goes along the surface for over 0.3 s."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "95th percentile of that distance, over the same stretches."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Time during which both hands pulled within the task's limits."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Hardest pull on the thread while the slit was shut, of the bite where it was least."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that the thread cut through the edge of its channel."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Share of a slit along which its edges stand at most 0.2 mm apart at the end, "
        "at the depth where they are nearest."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "How far the edges of a slit stand apart at the end, at the depth where they "
                      "are nearest: mean along the slit."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "How far the edges of a slit stand apart at the end, at the depth where they "
                      "are nearest: where it gapes most."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "What the slit as it is left would let through at a pressure of 6 cmH2O, were it cut right "
        "through: calculated for rigid walls from the gap along its length. Only where no pressure "
        "was put on it."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "What the slit lets through at the end when fluid below it stands at 6 cmH2O and presses "
        "its walls apart, hands off."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "What the slit lets through at the end when fluid below it stands at 12.5 cmH2O and "
        "presses its walls apart, hands off."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Pressure below the slit at which more than 10 ml/min pass it, rounded down to 0.1; the "
        "test ends at 40 cmH2O."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Where the slit leaks most at 12.5 cmH2O, from its left end, or its upper one where it "
        "runs up and down: the worst place of the stretch between two bites that lets most "
        "through."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "How many finished bites lie between that end of the slit and the stretch that leaks most "
        "at 12.5 cmH2O: 0 before the first bite, 1 between the first and the second, and so on."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Where most passes at the pressure at which the slit bursts, from its left end, or its "
        "upper one where it runs up and down; nothing where it holds to the end of the test."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Bites that came out, through which all of the needle was drawn, and whose "
                      "thread is still in them."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest distance of an entry from its mark, over the bites of a row."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest distance of an exit from its mark, over the bites of a row."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Depth of the shallowest bite of a row, below the surface at rest."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Depth of the deepest bite of a row, below the surface at rest."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Depth of the deepest bite of a row less that of the shallowest."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Mean distance between the middles of neighbouring bites, along the line."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest less smallest distance between neighbouring bites, along the line."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Largest difference between the distances of a bite's entry and exit from the line."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Smallest angle between the needle's path and the surface at rest where it "
                      "went in, over the bites of a row."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Share of the placode's edge beyond which the patch reaches 5 mm or more, hands off."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "How far the patch reaches beyond the placode's edge, hands off: mean along "
                      "the edge, where more than 5 mm counts as 5."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "How far the patch reaches beyond the placode's edge, hands off, where it "
                      "reaches least; 0 where it does not cover the edge, 10 at most."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the placode that the patch does not cover, hands off."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the patch that lies on another layer of it, or stands or turns "
                      "more than 60 degrees away from the rest of it, hands off."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that jaws closed on the patch, or on tissue instead of it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Highest pressure of the jet on the placode: 1/2 rho v^2, less with "
                      "distance, beside its axis and aslant."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Time in which the jet pressed on the placode with more than 500 Pa."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Share of the crumbs of char and spots of blood that are out of the field at the end."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Fluid that stands more than 0.2 mm deep at the end."),
    QT_TRANSLATE_NOOP("MetricDefinition", "What the jet has given."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Light that blood in the standing fluid takes, mean over the lesion, at the end."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Time in which blood in the standing fluid hid more than 30 % of the lesion."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Time in which tissue took more than half of the suction."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Time in which the placode took more than half of the suction."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Share of the area to be freed beside the wound, on its left, that has come "
                      "off the fascia."),
    QT_TRANSLATE_NOOP("MetricDefinition", "The same on its right."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "From the edges of the wound outwards to what still holds, mean of all lines."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Area that has come off the fascia farther from the edges than skin may be freed."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Undeformed volume of elements of fascia and muscle torn by stretch."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Force over length with which the edges of the untouched wound pull when "
                      "they are drawn to the midline."),
    QT_TRANSLATE_NOOP("MetricDefinition", "The same at the end, hands off."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Tension to close at the end over that of the untouched wound."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times that the needle slid or turned in the jaws."),
    QT_TRANSLATE_NOOP("MetricDefinition", "Times that jaws took the needle after the first."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that the needle went to the other driver while both held it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that the other driver took the needle after it had been let go."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that the needle was let go in the open, and not to lie at its mark."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest distance between where jaws took the needle and where the step "
                      "wanted it, as a share of its arc."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Largest angle between the wire and what is square to the driver, when jaws took it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "How far the needle was turned in hands, in all, in steps of 2 degrees."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest angle by which the needle turned while both drivers held it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Largest force between the drivers through the needle while both held it."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Times that the needle's point opened a surface from outside."),
    QT_TRANSLATE_NOOP("MetricDefinition",
                      "Angle between the needle's path and the surface at rest where the last bite "
                      "went in, 90 = upright."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Deepest place of the needle's channel below the surface at rest, last bite."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Distance of the needle's last exit from its mark, along the tissue at rest."),
    QT_TRANSLATE_NOOP(
        "MetricDefinition",
        "Distance of the needle's last entry from its mark, along the tissue at rest."),
};

}  // namespace
