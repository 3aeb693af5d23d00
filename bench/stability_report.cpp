// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/stability_report.h"

#include <algorithm>

#include "sim/core/number_text.h"

namespace placode::bench {

std::string recovery_text(const sim::StabilityResult& result) {
    const bool back = result.verdict == sim::StabilityVerdict::kRecovers ||
                      result.verdict == sim::StabilityVerdict::kRestored;
    return back ? sim::fixed_text(result.seconds, 2) + " s" : "";
}

std::string stability_csv(const std::vector<sim::StabilityResult>& results) {
    std::string text = "case,method,verdict,seconds,error,detail\n";
    for (const sim::StabilityResult& r : results) {
        std::string detail = r.detail;
        std::replace(detail.begin(), detail.end(), '"', '\'');
        text += '"' + r.name + "\"," + r.method + ",\"" + sim::verdict_name(r.verdict) + "\"," +
                sim::shortest_text(r.seconds) + ',' + sim::shortest_text(r.error) + ",\"" + detail +
                "\"\n";
    }
    return text;
}

std::string stability_report(const std::vector<sim::StabilityResult>& results,
                             const StabilityRun& run) {
    const Machine& m = run.machine;
    std::string text =
        "<!-- Written by `placodectl bench stability --report`; run it again instead of editing. "
        "-->\n# Hard cases for the tissue solvers\n\nRun by `placodectl bench stability` on " +
        m.processor + ", " + m.compiler + ", " + m.build + ", kernels " + m.kernel_target +
        ", one thread. " + run.length +
        ".\n\nA block of 6 mm, 1,296 tets of 1 mm, 5 kPa, nu 0.45; `vbd` with 4 substeps a frame "
        "of 1 ms, `xpbd` and `xpbd_pair` with 8. Verdicts: holds (never left its bounds), recovers "
        "(edges within 2 % and nothing inverted, from then to the end), re-seeded (an event says "
        "so), refused at load (with the reason), FAILS.\n\nCases of needle and thread: the field "
        "of `suture_bite`; the scripted expert bites, then the hand does what no hand should. As "
        "many frames without sense as random pokes. Cases of the patch: the field of "
        "`patch_place`, "
        "the first with a hole of 4 x 8 mm below the patch.\n\n"
        "| case | method | verdict | after | detail |\n|---|---|---|---|---|\n";
    for (const sim::StabilityResult& r : results)
        text += "| " + r.name + " | `" + r.method + "` | " + sim::verdict_name(r.verdict) + " | " +
                recovery_text(r) + " | " + r.detail + " |\n";
    return text + "\n" + std::to_string(run.failed) + " failed. Simulated in " +
           sim::fixed_text(run.wall_s / 60, 1) + " minutes.\n";
}

}  // namespace placode::bench
