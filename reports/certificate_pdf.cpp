// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a mastered course: one page, in English and in Polish.
#include "curriculum/bilingual.h"
#include "reports/cohort_report.h"
#include "reports/paper.h"

namespace placode::reports {
namespace {

std::string day_of(const std::string& utc) { return utc.substr(0, 10); }

}  // namespace

void write_certificate_pdf(const db::CertificateRecord& certificate, const db::UserRecord& user,
                           const curriculum::Course& course, const std::string& path) {
    const QString name = safe(user.display_name);
    Paper paper(path, "Placode certificate " + QString::fromStdString(certificate.code), "Placode",
                "Placode certificate " + QString::fromStdString(certificate.code) +
                    (user.demonstration ? " - DEMONSTRATION" : ""));
    if (user.demonstration)
        paper.html(
            "<p style='background-color:#fff1d6'><b>&nbsp;DEMONSTRATION</b> "
            "- not a person's "
            "certificate.</p>");
    using curriculum::Bilingual;
    const auto line = [](int size, const QString& text) {
        return "<p align='center' style='font-size:" + QString::number(size) + "px'>" + text +
               "</p>";
    };
    const auto stages = Bilingual::phrase("has mastered all %1 stages of the course",
                                          {Bilingual::as_is(std::to_string(course.stages.size()))});
    const auto details = Bilingual::phrase(
        "version %1, mastered on %2, issued on %3, code %4",
        {Bilingual::as_is(std::to_string(certificate.course_version)),
         Bilingual::as_is(day_of(certificate.mastered_utc)),
         Bilingual::as_is(day_of(certificate.issued_utc)), Bilingual::as_is(certificate.code)});
    for (const char* language : {"en", "pl"}) {
        const auto in = [&](const curriculum::LocalText& text) { return safe(text.in(language)); };
        paper.html(line(30, "<b>" + in(Bilingual::phrase("Certificate")) + "</b>") +
                   line(15, in(Bilingual::phrase("This is to certify that"))) +
                   line(24, "<b>" + name + "</b>") + line(15, in(stages)) +
                   line(18, "<b>" + in(course.title) + "</b>") +
                   "<p align='center' style='color:#5f666e'>" + in(details) + "</p><p>&nbsp;</p>");
    }
    const auto foot = Bilingual::phrase(
        "Mastery in simulation by the rules of this course version; not a licence to operate.");
    paper.html("<p style='color:#5f666e'>" + safe(foot.en) + " / " + safe(foot.pl) + "</p>");
    paper.finish();
}

}  // namespace placode::reports
