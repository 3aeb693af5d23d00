// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The text of the manual is true and whole: links and pictures are there, commands parse, words in
// bold stand on the screen, both languages say the same, every page, message and metric has its
// place. The page of metrics is written here:  PLACODE_WRITE_MANUAL=1 shell_manual_test

#include <QProcess>
#include <QRegularExpression>
#include <map>
#include <set>

#include "shell_harness.h"
#include "store_sentences.h"
#include "ui/shell/manual.h"
#include "ui/shell/metric_words.h"
#include "ui/shell/parts.h"

namespace placode::ui {

namespace {

constexpr const char* kLanguages[]{"en", "pl"};

QString read_text(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

QString source(const char* path) { return read_text(QString(PLACODE_SOURCE_DIR) + "/" + path); }

QStringList files_of(const QString& language) {
    return QDir(manual_folder(language)).entryList({"*.md"}, QDir::Files, QDir::Name);
}

/// Every match of the first group.
QStringList all_of(const QString& text, const char* pattern) {
    QStringList found;
    auto each = QRegularExpression(pattern, QRegularExpression::MultilineOption).globalMatch(text);
    while (each.hasNext()) found << each.next().captured(1);
    return found;
}

/// "Publish version %1" and "publish version ..." are the same words.
QString as_words(QString text) {
    static const QRegularExpression kVaries("%[L]?[1-9n]");
    text = text.replace(kVaries, QString(QChar(0x2026))).simplified();
    if (text.endsWith('.')) text.chop(1);
    if (!text.isEmpty()) text[0] = text[0].toLower();
    return text.trimmed();
}

QString unescaped(QString text) {
    return text.replace("&lt;", "<")
        .replace("&gt;", ">")
        .replace("&quot;", "\"")
        .replace("&apos;", "'")
        .replace("&amp;", "&");
}

/// What can stand on the screen of the shell and of the simulator.
std::set<QString> words_on_screen(const QString& language) {
    std::set<QString> words{"pL", "eN"};  // the buttons of the languages
    // The portal's are on other screens.
    static const QRegularExpression kPortal("<name>Web</name>.*?</context>",
                                            QRegularExpression::DotMatchesEverythingOption);
    const QString strings = source("ui/shell/translations/placode_pl.ts").remove(kPortal);
    const char* element =
        language == "en" ? "<source>([^<]*)</source>" : "<(?:translation|numerusform)>([^<]*)</";
    for (const QString& text : all_of(strings, element)) words.insert(as_words(unescaped(text)));
    return words;
}

}  // namespace

class ShellManualTest : public QObject {
    Q_OBJECT

 private Q_SLOTS:
    void initTestCase() { shell_ = std::make_unique<ShellHarness>(); }
    void cleanupTestCase() { shell_.reset(); }
    void thePageOfMetricsIsFresh();
    void everyLinkAndPictureIsThere();
    void everyPageOfTheShellHasAChapter();
    void bothLanguagesHaveTheSamePages();
    void wordsInBoldStandOnTheScreen();
    void everyMessageIsExplained();
    void everyCommandParses();
    void everyDeviceAndFormatHasAPage();

 private:
    [[nodiscard]] QString metricsPage(const QString& language);
    [[nodiscard]] QString helpOf(const QStringList& command);
    /// What is wrong with a line such as `placodectl study demo`; empty when nothing is.
    [[nodiscard]] QString complaint(const QString& line);

    std::unique_ptr<ShellHarness> shell_;
    std::map<QString, QString> helps_;
};

QString ShellManualTest::metricsPage(const QString& language) {
    shell_->context().setLanguage(language);
    const bool polish = language == "pl";
    QString page = polish ? "# Co jest mierzone\n\n" : "# What is measured\n\n";
    page += polish ? QString::fromUtf8(
                         "Ta strona powstaje z definicji w programie, zestaw miar w wersji %1. "
                         "Strona **Wynik** pokazuje te miary;\npliki eksportu podają je pod nazwą "
                         "z wiersza „W plikach”.\n")
                   : QString(
                         "This page is made from the definitions in the program, version %1 of "
                         "the set. The page **Result** shows these\nmeasures; files have them "
                         "under the name in the line \"In files\".\n");
    page = page.arg(assessment::kMetricSetVersion);
    // "95. percentyl" at the beginning of a line would be the 95th entry of a list.
    static const QRegularExpression kNumber("^([0-9]+)\\.");
    for (const assessment::MetricDefinition& metric : assessment::metric_definitions())
        page += QString("\n## %1\n\n%2 %3 `%4`.\n")
                    .arg(metric_name(metric.name),
                         metric_explanation(metric).replace(kNumber, "\\1\\."),
                         polish ? "W plikach:" : "In files:", qstr(std::string(metric.id)));
    shell_->context().setLanguage("en");
    return page;
}

void ShellManualTest::thePageOfMetricsIsFresh() {
    for (const char* language : kLanguages) {
        const QString path = manual_folder(language) + "metrics.md";
        const QString page = metricsPage(language);
        if (qEnvironmentVariableIsSet("PLACODE_WRITE_MANUAL")) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(page.toUtf8());
        }
        QVERIFY2(read_text(path) == page,
                 "write it again with PLACODE_WRITE_MANUAL=1 shell_manual_test");
        QVERIFY(page.count("\n## ") == static_cast<int>(assessment::metric_definitions().size()));
    }
}

void ShellManualTest::everyLinkAndPictureIsThere() {
    QStringList wrong;
    std::set<QString> shown;
    for (const char* language : kLanguages) {
        const QString folder = manual_folder(language);
        const Manual manual = load_manual(language);
        const QString index = read_text(folder + "index.md");
        for (const QString& file : files_of(language)) {
            const QString text = read_text(folder + file);
            if (file != "index.md" && !index.contains("](" + file + ")"))
                wrong << folder + file + " is in no list of contents";
            for (const QString& link : all_of(text, "\\]\\(([^)]*)\\)")) {
                const QString name = link.section('#', 0, 0), anchor = link.section('#', 1);
                const QString there = name.isEmpty() ? file : name;
                if (!QFile::exists(folder + there)) wrong << folder + file + ": no " + link;
                if (link.startsWith("../pictures/")) {
                    shown.insert(link.mid(12));
                    if (!link.startsWith(QString("../pictures/") + language))
                        wrong << file + ": a picture in the other language, " + link;
                }
                bool found = anchor.isEmpty();
                for (const ManualPage& page : manual.pages)
                    for (const ManualSection& section : page.sections)
                        found = found || (page.file == there && section.anchor == anchor);
                if (!found) wrong << folder + file + ": no heading " + link;
            }
        }
        for (const QString& picture :
             QDir(folder + "../pictures/" + language).entryList(QDir::Files))
            if (!shown.contains(QString(language) + "/" + picture))
                wrong << QString("pictures/%1/%2 is shown nowhere").arg(language, picture);
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
}

void ShellManualTest::everyPageOfTheShellHasAChapter() {
    for (const char* language : kLanguages) {
        const Manual manual = load_manual(language);
        QVERIFY(manual.folder.endsWith(QString("/%1/").arg(language)));
        for (int page = 0; page <= static_cast<int>(PageId::kCompare); ++page) {
            const QString chapter = manual_chapter(static_cast<PageId>(page));
            const bool listed =
                std::any_of(manual.pages.begin(), manual.pages.end(), [&](const ManualPage& each) {
                    return each.file == chapter && !each.title.isEmpty();
                });
            QVERIFY2(listed, qPrintable(QString("page %1: %2").arg(page).arg(chapter)));
        }
    }
}

void ShellManualTest::bothLanguagesHaveTheSamePages() {
    QCOMPARE(files_of("pl"), files_of("en"));
    QStringList wrong;
    for (const QString& file : files_of("en")) {
        const QString en = read_text(manual_folder("en") + file);
        const QString pl = read_text(manual_folder("pl") + file);
        for (const char* same : {"^#+ ", "^ *\\d+\\. ", "^ *- ", "^\\|", "!\\[", "^    \\S"}) {
            const auto count = [&](const QString& text) {
                return text.count(QRegularExpression(same, QRegularExpression::MultilineOption));
            };
            if (count(en) != count(pl))
                wrong << QString("%1: %2 of \"%3\" in English, %4 in Polish")
                             .arg(file)
                             .arg(count(en))
                             .arg(same)
                             .arg(count(pl));
        }
    }
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
}

void ShellManualTest::wordsInBoldStandOnTheScreen() {
    QStringList wrong;
    for (const char* language : kLanguages) {
        const std::set<QString> known = words_on_screen(language);
        for (const QString& file : files_of(language)) {
            const QString text = read_text(manual_folder(language) + file);
            for (const QString& bold : all_of(text, "\\*\\*([^*]+)\\*\\*"))
                if (known.count(as_words(bold)) == 0 && bold != QString::fromUtf8("pogrubione") &&
                    bold != "bold")
                    wrong << QString("%1/%2: %3").arg(language, file, bold.simplified());
        }
    }
    for (const QString& each : wrong) std::fprintf(stderr, "%s\n", qPrintable(each));
    QVERIFY2(wrong.isEmpty(), qPrintable(QString("%1 words").arg(wrong.size())));
}

void ShellManualTest::everyMessageIsExplained() {
    QStringList said = store_sentences();
    for (const QString& title :
         all_of(source("ui/shell/messages.cpp"),
                "title =\\s*(?:words\\.isEmpty\\(\\) \\? )?Messages::tr\\(\\s*\"([^\"]*)\""))
        said << title;
    QVERIFY(said.size() > 95);
    std::set<QString> explained;
    for (const QString& bold :
         all_of(read_text(manual_folder("en") + "messages.md"), "\\*\\*([^*]+)\\*\\*"))
        explained.insert(as_words(bold));
    QStringList missing;
    for (const QString& each : said)
        if (explained.count(as_words(each)) == 0) missing << each;
    QVERIFY2(missing.isEmpty(),
             qPrintable("messages.md does not say what to do:\n" + missing.join("\n")));
}

QString ShellManualTest::helpOf(const QStringList& command) {
    QString& text = helps_[command.join(' ')];
    if (!text.isEmpty()) return text;
    QProcess process;
    process.start(PLACODE_BIN_DIR "/" + command.front(), command.mid(1) + QStringList{"--help"});
    if (process.waitForFinished(20000) && process.exitCode() == 0)
        text = process.readAllStandardOutput();
    return text;
}

QString ShellManualTest::complaint(const QString& line) {
    const QStringList words = QProcess::splitCommand(line);
    QStringList command{words.front()};
    QString all = helpOf(command);
    // Subcommands, as far as the help names some.
    for (qsizetype i = 1; i < words.size(); ++i) {
        if (words[i] == "--store" || words[i] == "--as") {
            ++i;  // and its value
            continue;
        }
        if (words[i].startsWith("--")) continue;
        const QString subcommands = helpOf(command).section("\nSubcommands:", 1);
        if (subcommands.isEmpty()) break;
        if (!subcommands.contains(QRegularExpression("\\n  " + words[i] + "\\s")))
            return line + ": no subcommand " + words[i];
        command << words[i];
        all += helpOf(command);
    }
    if (all.isEmpty()) return line + ": no help";
    for (const QString& word : words)
        if (word.startsWith("--") && !all.contains(QRegularExpression(word + "\\b")))
            return line + ": no option " + word;
    return {};
}

void ShellManualTest::everyCommandParses() {
    if (!QFile::exists(PLACODE_BIN_DIR "/placodectl")) QSKIP("the programs are not built");
    QStringList wrong;
    int seen = 0;
    for (const char* language : kLanguages)
        for (const QString& file : files_of(language)) {
            const QString text = read_text(manual_folder(language) + file);
            QStringList lines = all_of(text, "^ {4,}((?:placodectl|placode-sim|placode) .*)$");
            lines += all_of(text, "`((?:placodectl|placode-sim|placode) [^`]*)`");
            for (const QString& line : lines) {
                ++seen;
                const QString problem = complaint(line.section(" | ", 0, 0));
                if (!problem.isEmpty()) wrong << QString(language) + "/" + file + ": " + problem;
            }
        }
    QVERIFY(seen > 60);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join("\n")));
}

void ShellManualTest::everyDeviceAndFormatHasAPage() {
    const QString index = read_text(manual_folder("en") + "index.md");
    const QString formats =
        all_of(helpOf({"placodectl", "export"}), "FORMAT TEXT:\\{([^}]*)\\}").value(0);
    QVERIFY(formats.split(',').size() >= 8);
    for (const QString& format : formats.split(','))
        QVERIFY2(index.contains("(export-" + format + ".md)"), qPrintable(format));
    const QString devices =
        all_of(helpOf({"placode-sim"}), "--device TEXT +([a-z, ]+), script:").value(0);
    QVERIFY(devices.split(", ").size() >= 8);
    for (const QString& device : devices.split(", "))
        QVERIFY2(index.contains("(device-" + device + ".md)"), qPrintable(device));
}

}  // namespace placode::ui

int main(int argc, char** argv) {
    placode::ui::prepare_display();
    QApplication application(argc, argv);
    placode::ui::ShellManualTest test;
    return QTest::qExec(&test, argc, argv);
}

#include "shell_manual_test.moc"
