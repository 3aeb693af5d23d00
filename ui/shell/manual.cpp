// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/manual.h"

#include <QDir>
#include <QFile>
#include <QRegularExpression>
#include <algorithm>

#include "curriculum/definitions.h"
#include "ui/shell/search_box.h"

namespace placode::ui {
namespace {

QString read_text(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// Markdown as it is read aloud: no pictures, no marks, the words of links.
QString plain(QString text) {
    static const QRegularExpression kPicture("!\\[[^\\]]*\\]\\([^)]*\\)");
    static const QRegularExpression kLink("\\[([^\\]]*)\\]\\([^)]*\\)");
    static const QRegularExpression kRule("\\|[-:| ]+\\|\\s*$",
                                          QRegularExpression::MultilineOption);
    static const QRegularExpression kMarks("\\*\\*|`|\\||\\\\|^[>#-] ",
                                           QRegularExpression::MultilineOption);
    text.remove(kPicture).replace(kLink, "\\1").remove(kRule).replace(kMarks, " ");
    return text.simplified();
}

ManualPage read_page(const QString& folder, const QString& part, const QString& file) {
    ManualPage page{part, {}, file, {}};
    QString body;
    bool code = false;
    const auto close = [&] {
        if (page.sections.empty()) return;
        ManualSection& last = page.sections.back();
        last.text = plain(body);
        last.key = folded(page.title + " " + last.heading + " " + last.text);
        body.clear();
    };
    for (const QString& line : read_text(folder + file).split('\n')) {
        if (line.startsWith("```")) code = !code;
        const bool heading = !code && line.startsWith('#');
        if (!heading) {
            body += line + "\n";
            continue;
        }
        close();
        const QString words = plain(line.mid(line.indexOf(' ') + 1));
        if (page.title.isEmpty()) page.title = words;
        page.sections.push_back(
            {words, page.sections.empty() ? QString() : heading_anchor(words), {}, {}});
    }
    close();
    return page;
}

/// 0 = in the title, 1 = in a heading, 2 = in the text.
int rank(const ManualHit& hit, const QStringList& words) {
    const auto holds = [&](const QString& text) {
        const QString key = folded(text);
        return std::all_of(words.begin(), words.end(),
                           [&](const QString& word) { return key.contains(word); });
    };
    const bool title = hit.section->anchor.isEmpty();
    if (title && holds(hit.page->title)) return 0;
    return holds(hit.section->heading) ? 1 : 2;
}

}  // namespace

QString manual_folder(const QString& language) {
    // Installed it lies beside the tasks, in the tree beside the other documents.
    const QDir data(QString::fromStdString(curriculum::data_folder().string()));
    const QString installed = data.filePath("manual");
    const QString base = QDir(installed).exists() ? installed : data.filePath("../docs/manual");
    return QDir::cleanPath(base + "/" + language) + "/";
}

Manual load_manual(const QString& language) {
    Manual manual{manual_folder(language), {}};
    if (!QFile::exists(manual.folder + "index.md")) manual.folder = manual_folder("en");
    static const QRegularExpression kEntry("^- \\[[^\\]]+\\]\\(([^)#]+\\.md)\\)");
    QString part;
    for (const QString& line : read_text(manual.folder + "index.md").split('\n')) {
        if (line.startsWith("## ")) part = plain(line.mid(3));
        if (const auto entry = kEntry.match(line); entry.hasMatch())
            manual.pages.push_back(read_page(manual.folder, part, entry.captured(1)));
    }
    return manual;
}

QString heading_anchor(const QString& heading) {
    QString anchor;
    for (const QChar c : heading.toLower()) {
        if (c.isLetterOrNumber() || c == '-' || c == '_') anchor += c;
        if (c == ' ') anchor += '-';
    }
    return anchor;
}

// Without a default: whoever adds a page is told that it needs a chapter.
QString manual_chapter(PageId page) {
    switch (page) {
        case PageId::kSetup:
            return "admin-setup.md";
        case PageId::kLogin:
        case PageId::kJoin:
            return "sign-in.md";
        case PageId::kToday:
        case PageId::kCourse:
            return "trainee-course.md";
        case PageId::kTask:
        case PageId::kRunning:
            return "trainee-attempt.md";
        case PageId::kResult:
            return "trainee-result.md";
        case PageId::kWatch:
        case PageId::kCompare:
            return "trainee-watch.md";
        case PageId::kHistory:
            return "trainee-history.md";
        case PageId::kRecovery:
            return "trainee-recovery.md";
        case PageId::kAccount:
            return "account.md";
        case PageId::kAttempts:
            return "educator-attempts.md";
        case PageId::kCohort:
            return "educator-cohort.md";
        case PageId::kRatings:
            return "educator-ratings.md";
        case PageId::kStandards:
            return "educator-standards.md";
        case PageId::kNorms:
            return "educator-norms.md";
        case PageId::kCourses:
        case PageId::kCourseEditor:
            return "educator-courses.md";
        case PageId::kGroups:
            return "educator-groups.md";
        case PageId::kStudies:
            return "study-enrol.md";
        case PageId::kStudyRun:
        case PageId::kParticipant:
            return "study-run.md";
        case PageId::kStudyData:
            return "study-data.md";
        case PageId::kStudyResults:
            return "study-results.md";
        case PageId::kProtocols:
            return "study-protocol.md";
        case PageId::kPeople:
        case PageId::kAdmissions:
            return "admin-people.md";
        case PageId::kDevices:
            return "admin-devices.md";
        case PageId::kHealth:
            return "admin-backup.md";
        case PageId::kAudit:
            return "admin-audit.md";
    }
    return "index.md";
}

std::vector<ManualHit> find_in_manual(const Manual& manual, const QString& typed, size_t limit) {
    const QStringList words = folded(typed).split(' ', Qt::SkipEmptyParts);
    std::vector<ManualHit> hits;
    if (words.isEmpty()) return hits;
    for (const ManualPage& page : manual.pages)
        for (const ManualSection& section : page.sections)
            if (std::all_of(words.begin(), words.end(),
                            [&](const QString& word) { return section.key.contains(word); }))
                hits.push_back({&page, &section});
    std::stable_sort(hits.begin(), hits.end(), [&](const ManualHit& a, const ManualHit& b) {
        return rank(a, words) < rank(b, words);
    });
    if (hits.size() > limit) hits.resize(limit);
    return hits;
}

}  // namespace placode::ui
