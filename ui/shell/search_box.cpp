// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/search_box.h"

#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <memory>

#include "db/attempt_counting.h"
#include "ui/shell/manual.h"
#include "ui/shell/parts.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

constexpr size_t kShown = 12;
/// Attempts that can be found: the newest ones.
constexpr size_t kAttempts = 5000;

Findable findable(Findable::Kind kind, const QString& title, const QString& detail,
                  const Place& place) {
    return {kind, title, detail, place, folded(title + " " + detail), {}};
}

}  // namespace

QString folded(const QString& text) {
    QString plain;
    for (const QChar c : text.normalized(QString::NormalizationForm_D)) {
        if (c.category() == QChar::Mark_NonSpacing) continue;
        // The one Polish letter that does not come apart.
        plain += c == QChar(0x142) || c == QChar(0x141) ? QChar('l') : c.toLower();
    }
    return plain;
}

std::vector<const Findable*> find_in(const std::vector<Findable>& all, const QString& typed,
                                     size_t limit) {
    const QStringList words = folded(typed).split(' ', Qt::SkipEmptyParts);
    std::vector<const Findable*> found;
    for (const Findable& each : all) {
        const bool fits = std::all_of(words.begin(), words.end(),
                                      [&](const QString& word) { return each.key.contains(word); });
        if (fits) found.push_back(&each);
    }
    const QString start = words.isEmpty() ? QString() : words.front();
    std::stable_sort(found.begin(), found.end(), [&](const Findable* a, const Findable* b) {
        const bool first_a = !start.isEmpty() && a->key.startsWith(start);
        const bool first_b = !start.isEmpty() && b->key.startsWith(start);
        return first_a != first_b ? first_a : a->kind < b->kind;
    });
    if (found.size() > limit) found.resize(limit);
    return found;
}

SearchBox::SearchBox(AppContext& context, std::vector<Findable> pages, QWidget* parent)
    : QDialog(parent), context_(context), all_(std::move(pages)) {
    setObjectName("search_box");
    setWindowTitle(tr("Search"));
    setAccessibleName(tr("Search"));
    for (Findable& each : all_) each.key = folded(each.title + " " + each.detail);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(kSpace16, kSpace16, kSpace16, kSpace16);
    layout->setSpacing(kSpace12);
    typed_ = new QLineEdit;
    typed_->setObjectName("search_text");
    typed_->setPlaceholderText(tr("Page, task, person, attempt, manual"));
    typed_->setAccessibleName(tr("Search"));
    typed_->installEventFilter(this);
    layout->addWidget(typed_);
    list_ = new QListWidget;
    list_->setObjectName("search_list");
    list_->setAccessibleName(tr("Found"));
    list_->setUniformItemSizes(true);
    layout->addWidget(list_, 1);
    said_ = make_label({}, "small");
    said_->setObjectName("search_said");
    layout->addWidget(said_);
    const int width = std::min(640, parent->width() - 80);
    resize(width, std::min(560, parent->height() - 120));
    move(parent->mapToGlobal(QPoint((parent->width() - width) / 2, 60)));
    connect(typed_, &QLineEdit::textChanged, this, [this] { refill(); });
    connect(list_, &QListWidget::itemActivated, this, [this] { openCurrent(); });
    connect(list_, &QListWidget::itemClicked, this, [this] { openCurrent(); });
    addTasks();
    addPeople();
    addManual();
    readAttempts();
    refill();
    typed_->setFocus();
}

void SearchBox::addTasks() {
    if (!context_.may(db::Action::kPerformAttempt)) return;
    for (const std::string& id : curriculum::list_definitions("tasks")) {
        (void)context_.problemOf([&] {
            all_.push_back(findable(Findable::Kind::kTask,
                                    context_.in(curriculum::load_task(id).title), tr("task"),
                                    {PageId::kTask, 0, qstr(id), {}}));
        });
    }
}

void SearchBox::addPeople() {
    const bool names = context_.may(db::Action::kViewPersonalData, db::Scope::kOther);
    const bool scores = context_.may(db::Action::kViewAttempts, db::Scope::kOther);
    if (!names) return;
    context_.guard(tr("Reading the people"), [&] {
        for (const db::UserRecord& user : context_.store().accounts().list()) {
            // An educator wants the attempts, an administrator the account.
            const Place place = scores ? Place{PageId::kAttempts,
                                               0,
                                               {},
                                               {{"person", QVariant::fromValue<qint64>(user.id)}}}
                                       : Place{PageId::kPeople, 0, {}, {}};
            all_.push_back(findable(Findable::Kind::kPerson, qstr(user.display_name),
                                    qstr(user.login) + " · " + role_names(user.roles), place));
        }
    });
}

/// Titles and headings: what stands below them is found in the manual's own window.
void SearchBox::addManual() {
    for (const ManualPage& page : load_manual(context_.language()).pages) {
        Findable one = findable(Findable::Kind::kManual, page.title, tr("manual"), {});
        for (const ManualSection& section : page.sections) one.key += " " + folded(section.heading);
        one.manual = page.file;
        all_.push_back(one);
    }
}

void SearchBox::readAttempts() {
    const bool everybody = context_.may(db::Action::kViewAttempts, db::Scope::kOther);
    const int64_t user = everybody ? 0 : context_.user().id;
    auto attempts = std::make_shared<std::vector<db::AttemptRecord>>();
    context_.background(
        this, tr("Reading the attempts"),
        [attempts, user, studies = context_.may(db::Action::kRunQuestionnaire)](db::Store& store) {
            db::AttemptFilter newest;
            newest.user_id = user;
            newest.limit = static_cast<int>(kAttempts);
            newest.studies = studies;
            *attempts = store.attempts().page(newest).rows;
        },
        [this, attempts, everybody](bool) {
            reading_ = false;
            std::map<std::string, QString> titles;
            for (const db::AttemptRecord& each : *attempts) {
                QString& title = titles[each.task_id];
                if (title.isEmpty()) title = task_title(context_, each.task_id);
                // Points only where there are any: those of an attempt that was left are no score.
                QStringList facts{format_when(each.started_utc), verdict_word(each),
                                  db::counts(each) ? points_words(each.points) : QString("–"),
                                  tr("attempt %1").arg(each.id)};
                if (everybody) facts.prepend(qstr(each.user_name));
                all_.push_back(findable(Findable::Kind::kAttempt, title, facts.join(" · "),
                                        {PageId::kResult, each.id, {}, {}}));
            }
            refill();
        });
}

void SearchBox::refill() {
    const QString typed = typed_->text();
    shown_ = find_in(all_, typed, kShown);
    list_->clear();
    const Tokens& colors = context_.colors();
    static constexpr const char* kIcons[]{"next", "course", "people", "help", "history"};
    for (const Findable* each : shown_) {
        const QString text =
            each->detail.isEmpty() ? each->title : each->title + "   " + each->detail;
        auto* item = new QListWidgetItem(
            line_icon(kIcons[static_cast<size_t>(each->kind)], colors.muted), text);
        item->setSizeHint(QSize(0, kTouchTarget));
        list_->addItem(item);
    }
    if (!shown_.empty()) list_->setCurrentRow(0);
    said_->setText(shown_.empty() && reading_ ? tr("Reading the attempts …")
                   : shown_.empty() ? tr("Nothing found. Try fewer letters, a name or a date.")
                                    : tr("Arrow keys choose, Enter opens, Escape closes."));
}

void SearchBox::openCurrent() {
    const int row = list_->currentRow();
    if (row < 0 || row >= static_cast<int>(shown_.size())) return;
    const Findable& one = *shown_[static_cast<size_t>(row)];
    if (one.manual.isEmpty()) {
        Q_EMIT chosen(one.place);
    } else {
        Q_EMIT manualChosen(one.manual);
    }
    accept();
}

bool SearchBox::eventFilter(QObject* watched, QEvent* event) {
    if (watched == typed_ && event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
        if (step != 0 && list_->count() > 0) {
            list_->setCurrentRow(std::clamp(list_->currentRow() + step, 0, list_->count() - 1));
            return true;
        }
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            openCurrent();
            return true;
        }
    }
    return QDialog::eventFilter(watched, event);
}

}  // namespace placode::ui
