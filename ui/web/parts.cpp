// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/web/parts.h"

#include <QByteArray>
#include <QCoreApplication>
#include <QDate>
#include <QPainter>
#include <QRegularExpression>
#include <algorithm>
#include <mutex>

#include "db/attempt_counting.h"
#include "reports/svg.h"
#include "reports/text.h"
#include "reports/words.h"

namespace placode::web {

using namespace std::string_view_literals;

namespace {

/// The dark theme of the shell (ui/shell/theme.cpp); the light one is the style's own.
reports::ChartStyle dark_style() {
    reports::ChartStyle style;
    style.text = 0xffecedee, style.muted = 0xff9aa3ad, style.line = 0xff33373d;
    style.accent = 0xff4fb8c2, style.surface = 0xff1f2226;
    style.good = 0xff6cc58f, style.warn = 0xffe0a44a, style.critical = 0xfff2857c;
    return style;
}

std::string data_address(const std::string& svg) {
    return "data:image/svg+xml;base64," + QByteArray::fromStdString(svg).toBase64().toStdString();
}

/// English days stay ISO 8601; other languages have the month as a word, as in the shell.
QString day_words(const QString& iso) {
    const QDate day = QDate::fromString(iso, Qt::ISODate);
    if (spoken_code() == "en" || !day.isValid()) return iso;
    return reports::spoken().toString(day, QStringLiteral("d MMM yyyy"));
}

}  // namespace

Text dash() { return text("–"sv); }

Html moment(const std::string& utc) {
    if (utc.size() < 16) return day(utc);
    Html out = day(utc);
    out << text(spoken_code() == "en" ? " "sv : ", "sv) << text(utc.substr(11, 5));
    return out;
}

// In one piece: a browser would break it at its hyphens.
Html day(const std::string& utc) {
    Html out;
    out << "<span class=\"day\">"
        << (utc.empty() ? dash() : text(day_words(QString::fromStdString(utc.substr(0, 10)))))
        << "</span>";
    return out;
}

Text with_days(const std::string& sentence) {
    static const QRegularExpression iso(QStringLiteral("\\b\\d{4}-\\d{2}-\\d{2}\\b"));
    QString words = QString::fromStdString(sentence);
    for (QRegularExpressionMatch found = iso.match(words); found.hasMatch();) {
        const QString said = day_words(found.captured());
        words.replace(found.capturedStart(), found.capturedLength(), said);
        found = iso.match(words, found.capturedStart() + said.size());
    }
    return text(words);
}

Text points(double value) {
    const QString number = reports::number(value, 1);
    return number_text(number.startsWith('-') ? QString::fromUtf8("−") + number.mid(1) : number);
}

Text verdict(assessment::Verdict verdict) {
    switch (verdict) {
        case assessment::Verdict::kPassed:
            return Web::phrase("Passed");
        case assessment::Verdict::kNotYet:
            return Web::phrase("Not yet");
        case assessment::Verdict::kFailed:
            return Web::phrase("Failed");
        case assessment::Verdict::kNotAttempted:
            return Web::phrase("Not attempted");
    }
    return dash();
}

Html verdict_badge(const db::AttemptRecord& attempt) {
    if (!db::counts(attempt)) return badge(Web::phrase("does not count"), Tone::kPlain);
    const Text word = verdict(attempt.verdict);
    switch (attempt.verdict) {
        case assessment::Verdict::kPassed:
            return badge(word, Tone::kGood);
        case assessment::Verdict::kFailed:
            return badge(word, Tone::kCritical);
        default:
            return badge(word, Tone::kWarn);
    }
}

Html demonstration_badge() { return badge(Web::phrase("DEMONSTRATION"), Tone::kWarn); }

Html standing_badge(assessment::Standing standing) {
    switch (standing) {
        case assessment::Standing::kNotTried:
            return badge(Web::phrase("not tried"), Tone::kPlain);
        case assessment::Standing::kLearning:
            return badge(Web::phrase("learning"), Tone::kPlain);
        case assessment::Standing::kPassing:
            return badge(Web::phrase("passing"), Tone::kGood);
        case assessment::Standing::kRegressed:
            return badge(Web::phrase("regressed"), Tone::kWarn);
        case assessment::Standing::kStuck:
            return badge(Web::phrase("stuck"), Tone::kCritical);
    }
    return dash();
}

Text standings_explained() {
    return Web::phrase(
        "Stuck: none of the last %1 attempts passed and no gain of %2 points. Regressed: passed "
        "before, but neither of the last two attempts.",
        text(assessment::kStuckTrials), text(reports::number(assessment::kProgressPoints, 0)));
}

Text metric_words(const assessment::MetricDefinition& metric) {
    return text(QCoreApplication::translate("Metric", std::string(metric.name).c_str()));
}

std::string role_words(db::Roles roles) {
    std::string all;
    const auto add = [&](db::Role role, const std::string& word) {
        if (db::has_role(roles, role)) all += (all.empty() ? "" : ", ") + word;
    };
    add(db::Role::kTrainee, Web::plain_phrase("trainee"));
    add(db::Role::kEducator, Web::plain_phrase("educator"));
    add(db::Role::kCoordinator, Web::plain_phrase("coordinator"));
    add(db::Role::kAdministrator, Web::plain_phrase("administrator"));
    return all;
}

std::string name_or_number(const std::string& name, int64_t id) {
    return name.empty() ? Web::plain_phrase("number %1", {std::to_string(id)}) : name;
}

Html picture(
    const std::string& title, const std::string& description, int width, int height,
    const std::function<void(QPainter&, const QRectF&, const reports::ChartStyle&)>& draw) {
    // Qt lets several threads draw at once; two at a time is all that this computer has for it.
    static std::mutex drawing;
    const auto drawn = [&](const reports::ChartStyle& style) {
        const std::lock_guard lock(drawing);
        return data_address(
            reports::svg_of({width, height}, title, description, [&](QPainter& painter) {
                painter.setRenderHint(QPainter::Antialiasing);
                const QRectF whole(0, 0, width, height);
                painter.fillRect(whole, QColor::fromRgba(style.surface));
                draw(painter, whole.adjusted(8, 8, -8, -8), style);
            }));
    };
    Html out;
    out << "<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" << text(title)
        << "\"><picture><source media=\"(prefers-color-scheme: dark)\" srcset=\""
        << text(drawn(dark_style())) << "\"><img src=\"" << text(drawn({})) << "\" width=\""
        << text(width) << "\" height=\"" << text(height) << "\" alt=\""
        << text(title + ". " + description) << "\"></picture></div>\n";
    return out;
}

Html figure(const std::function<reports::Figure(const reports::ChartStyle&)>& make) {
    const reports::Figure plain = make({});
    Html out;
    out << "<figure>"
        << picture(plain.title, plain.caption, static_cast<int>(plain.width) + 16,
                   static_cast<int>(plain.height) + 16,
                   [&](QPainter& painter, const QRectF& where, const reports::ChartStyle& style) {
                       make(style).draw(painter, where);
                   })
        << "<figcaption>" << text(plain.caption) << "</figcaption></figure>\n";
    return out;
}

Part part_of(const Visit& visit, int64_t total) {
    Part part;
    part.total = total;
    const int64_t last = std::max<int64_t>(0, (total - 1) / kRowsOfPage);
    part.page = std::clamp<int64_t>(visit.number("page") - 1, 0, last);
    part.first = part.page * kRowsOfPage;
    part.past = std::min(total, part.first + kRowsOfPage);
    return part;
}

Html pager(const Part& part, const std::string& path, std::vector<QueryPart> parts) {
    Html out;
    if (part.total <= kRowsOfPage) return out;
    const auto to = [&](int64_t page) {
        std::vector<QueryPart> all = parts;
        all.push_back({"page", std::to_string(page + 1)});
        return path + query(all);
    };
    out << "<nav class=\"pager\" aria-label=\"" << Web::phrase("Pages of the list") << "\">";
    if (part.page > 0) out << link(to(part.page - 1), Web::phrase("← Before"));
    out << "<span>"
        << Web::phrase("%1 to %2 of %3", text(part.first + 1), text(part.past), text(part.total))
        << "</span>";
    if (part.past < part.total) out << link(to(part.page + 1), Web::phrase("Next →"));
    out << "</nav>\n";
    return out;
}

Html views(const Text& label, const std::string& here, const std::vector<View>& all) {
    Html out;
    out << "<nav aria-label=\"" << label << "\"><ul class=\"ways\">";
    for (const View& each : all) {
        out << "<li><a href=\"" << text(each.address) << "\"";
        if (each.address == here) out << " aria-current=\"page\"";
        out << ">" << each.words << "</a></li>";
    }
    out << "</ul></nav>\n";
    return out;
}

Html choices(const std::string& path, const std::vector<Choice>& all) {
    Html out;
    out << "<form class=\"choices\" method=\"get\" action=\"" << text(path) << "\">";
    for (const Choice& choice : all) {
        out << "<div><label for=\"" << text(choice.name) << "\">" << choice.label
            << "</label><select id=\"" << text(choice.name) << "\" name=\"" << text(choice.name)
            << "\">";
        for (const auto& [value, words] : choice.values) {
            out << "<option value=\"" << text(value) << "\"";
            if (value == choice.chosen) out << " selected=\"\"";
            out << ">" << words << "</option>";
        }
        out << "</select></div>";
    }
    out << "<button type=\"submit\">" << Web::phrase("Show") << "</button></form>\n";
    return out;
}

Choice group_choice(const Visit& visit) {
    Choice choice{
        "group", Web::phrase("Group"), visit.asked("group"), {{"", Web::phrase("Everybody")}}};
    for (const db::GroupRecord& group : visit.store.groups().list())
        choice.values.emplace_back(std::to_string(group.id), text(group.name));
    return choice;
}

Html attempts_table(const Visit& visit, const Text& caption,
                    const std::vector<db::AttemptRecord>& attempts, bool with_person) {
    std::vector<Column> columns{{Web::phrase("Attempt")}, {Web::phrase("Started (UTC)")}};
    if (with_person) columns.push_back({Web::phrase("Person")});
    for (const Column& each : std::vector<Column>{{Web::phrase("Task")},
                                                  {Web::phrase("Points"), true},
                                                  {Web::phrase("Result")},
                                                  {Web::phrase("Why it does not count")},
                                                  {Web::phrase("Length"), true}})
        columns.push_back(each);
    Table table(caption, columns);
    for (const db::AttemptRecord& each : attempts) {
        Html number;
        number << "#" << text(each.id);
        Html task = text(visit.tasks.of(each.task_id).title);
        if (each.demonstration) task << " " << demonstration_badge();
        std::vector<Html> cells{link("/attempts/" + std::to_string(each.id), number),
                                moment(each.started_utc)};
        if (with_person)
            cells.emplace_back(each.user_id == 0
                                   ? Html(text(each.user_name))
                                   : link("/people/" + std::to_string(each.user_id),
                                          text(name_or_number(each.user_name, each.user_id))));
        cells.push_back(task);
        cells.emplace_back(points(each.points));
        cells.push_back(verdict_badge(each));
        const QString why = reports::not_counted_words(each);
        cells.emplace_back(why.isEmpty() ? dash() : text(why));
        cells.emplace_back(text(reports::duration_words(each.duration_s)));
        table.row(cells);
    }
    return table.html();
}

}  // namespace placode::web
