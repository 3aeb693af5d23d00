// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The certificate of a mastered course: one page, in English and in Polish.
#include "reports/cohort_report.h"
#include "reports/paper.h"

namespace placode::reports {
namespace {

QString date_of(const std::string& utc) { return safe(utc.substr(0, 10)); }

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
    const auto half = [&](const QString& title, const QString& says, const QString& course_title,
                          const QString& what, const QString& code) {
        paper.html("<p align='center' style='font-size:30px'><b>" + title + "</b></p>" +
                   "<p align='center' style='font-size:15px'>" + says + "</p>" +
                   "<p align='center' style='font-size:24px'><b>" + name + "</b></p>" +
                   "<p align='center' style='font-size:15px'>" + what + "</p>" +
                   "<p align='center' style='font-size:18px'><b>" + course_title + "</b></p>" +
                   "<p align='center' style='color:#5f666e'>" + code + "</p><p>&nbsp;</p>");
    };
    const QString version = QString::number(certificate.course_version);
    half("Certificate", "This is to certify that", safe(course.title.in("en")),
         "has mastered all " + QString::number(course.stages.size()) + " stages of the course",
         "version " + version + ", mastered on " + date_of(certificate.mastered_utc) +
             ", issued on " + date_of(certificate.issued_utc) + ", code " + safe(certificate.code));
    half(QString::fromUtf8("Zaświadczenie"), QString::fromUtf8("Niniejszym zaświadcza się, że"),
         safe(course.title.in("pl")),
         QString::fromUtf8("zalicza wszystkie etapy kursu (") +
             QString::number(course.stages.size()) + ")",
         "wersja " + version + ", zaliczono " + date_of(certificate.mastered_utc) + ", wydano " +
             date_of(certificate.issued_utc) + ", kod " + safe(certificate.code));
    paper.html(
        QString::fromUtf8("<p style='color:#5f666e'>Mastery in simulation "
                          "by the rules of this course version; "
                          "not a licence to operate. / Zaliczenie w "
                          "symulacji według zasad tej wersji kursu; "
                          "nie jest uprawnieniem do operowania.</p>"));
    paper.finish();
}

}  // namespace placode::reports
