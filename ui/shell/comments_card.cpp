// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Remarks on an attempt: educators and the person who made it write them, both read them.

#include <QApplication>
#include <QElapsedTimer>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>

#include "reports/words.h"
#include "ui/shell/result_cards.h"
#include "ui/shell/training.h"

namespace placode::ui {
namespace {

/// Enter that is held writes one remark and not one for each time that it repeats.
class OneEnter : public QObject {
 public:
    explicit OneEnter(QWidget* field) : QObject(field) { field->installEventFilter(this); }
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() != QEvent::KeyPress) return false;
        const auto* key = static_cast<QKeyEvent*>(event);
        return key->isAutoRepeat() && (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter);
    }
};

class CommentsCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(CommentsCard)
 public:
    CommentsCard(AppContext& context, int64_t attempt_id, int64_t owner_id,
                 std::function<double()> moment, ShowMoment show,
                 std::function<void(const std::vector<db::CommentRecord>&)> changed)
        : context_(context),
          attempt_id_(attempt_id),
          owner_id_(owner_id),
          moment_(std::move(moment)),
          show_(std::move(show)),
          changed_(std::move(changed)) {
        setProperty("role", "card");
        setObjectName("comments");
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(kSpace24, kSpace16, kSpace24, kSpace16);
        layout->setSpacing(kSpace12);
        layout->addWidget(make_label(tr("Remarks"), "heading"));
        auto* list = new QWidget;
        list_ = new QVBoxLayout(list);
        list_->setContentsMargins(0, 0, 0, 0);
        list_->setSpacing(kSpace8);
        layout->addWidget(list);
        if (may_remark(context, owner_id)) layout->addLayout(writer());
        undo_ = make_button(context, tr("Put the remark back"), "secondary", "again");
        undo_->setObjectName("undo_remove");
        undo_->hide();
        connect(undo_, &QPushButton::clicked, this, [this] { remove(removed_, false); });
        layout->addWidget(undo_, 0, Qt::AlignLeft);
        refill();
    }

 private:
    QHBoxLayout* writer() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        text_ = new QLineEdit;
        text_->setObjectName("comment_text");
        text_->setAccessibleName(tr("New remark"));
        const bool timed = moment_ && moment_() >= 0;
        text_->setPlaceholderText(timed ? tr("A remark on what is shown now")
                                        : tr("A remark on the whole attempt"));
        text_->setMaxLength(1000);
        row->addWidget(text_, 1);
        QPushButton* add = make_button(context_, timed ? tr("Remark here") : tr("Add a remark"),
                                       "secondary", "plus");
        add->setObjectName("comment_add");
        connect(add, &QPushButton::clicked, this, [this] { this->add(); });
        connect(text_, &QLineEdit::returnPressed, this, [this] { this->add(); });
        for (QWidget* field : {static_cast<QWidget*>(text_), static_cast<QWidget*>(add)})
            new OneEnter(field);
        row->addWidget(add);
        return row;
    }

    /// The second press of a double click: nothing was typed since the remark before. Its moment
    /// may be a later one, where the replay runs on.
    [[nodiscard]] bool isPressedTwice() const {
        return text_->text().trimmed().isEmpty() && added_.isValid() &&
               added_.elapsed() < QApplication::doubleClickInterval();
    }

    void add() {
        if (isPressedTwice()) return;
        context_.guard(tr("Saving the remark"), [this] {
            db::CommentRecord comment;
            comment.attempt_id = attempt_id_;
            comment.author_id = context_.user().id;
            comment.time_s = moment_ ? moment_() : -1;
            comment.text = text_->text().trimmed().toStdString();
            (void)context_.store().reviews().add_comment(comment);
            text_->clear();
            refill();
            added_.start();
        });
    }

    void remove(int64_t id, bool removed) {
        context_.guard(removed ? tr("Removing the remark") : tr("Putting the remark back"), [&] {
            context_.store().reviews().set_comment_removed(id, removed);
            removed_ = id;
            refill();
            undo_->setVisible(removed);
            if (removed) undo_->setFocus();
        });
    }

    void refill() {
        while (QLayoutItem* item = list_->takeAt(0)) {
            if (item->widget()) item->widget()->deleteLater();
            delete item;
        }
        const std::vector<db::CommentRecord> comments =
            context_.store().reviews().comments(attempt_id_);
        if (comments.empty())
            list_->addWidget(make_label(may_remark(context_, owner_id_)
                                            ? tr("No remarks yet.")
                                            : tr("No remarks. Educators can write them here."),
                                        "muted"));
        int number = 0;
        for (const db::CommentRecord& each : comments) list_->addWidget(line(each, ++number));
        if (owner_id_ == context_.user().id) remarks_read(context_, attempt_id_, comments);
        if (changed_) changed_(comments);
    }

    QWidget* line(const db::CommentRecord& comment, int number) {
        auto* whole = new QWidget;
        auto* row = new QHBoxLayout(whole);
        row->setContentsMargins(0, 0, 0, 0);
        row->setSpacing(kSpace12);
        QLabel* flag = make_badge(QString::number(number), comment.time_s >= 0 ? "accent" : "");
        flag->setMinimumWidth(30);
        flag->setAlignment(Qt::AlignCenter);
        row->addWidget(flag, 0, Qt::AlignTop);
        auto* text = new QVBoxLayout;
        text->setSpacing(0);
        QLabel* words = make_label(comment.text.empty() ? tr("Look here.") : qstr(comment.text));
        words->setObjectName(QString("comment_%1").arg(number));
        text->addWidget(words);
        QStringList facts{qstr(comment.author_name), format_when(comment.at_utc)};
        if (comment.time_s >= 0) facts.prepend(reports::minute_second(comment.time_s));
        text->addWidget(make_label(facts.join(" · "), "small"));
        row->addLayout(text, 1);
        if (comment.time_s >= 0 && show_) {
            QPushButton* button = make_button(context_, tr("Show"), "quiet", "play");
            button->setObjectName(QString("comment_show_%1").arg(number));
            button->setAccessibleName(
                tr("Show the moment %1").arg(reports::minute_second(comment.time_s)));
            connect(button, &QPushButton::clicked, this,
                    [this, t = comment.time_s] { show_(std::max(0.0, t - 3)); });
            row->addWidget(button, 0, Qt::AlignTop);
        }
        if (comment.author_id == context_.user().id) {
            QPushButton* button = press_once(make_button(context_, tr("Remove"), "quiet", "close"));
            button->setObjectName(QString("comment_remove_%1").arg(number));
            button->setAccessibleName(tr("Remove remark %1").arg(number));
            connect(button, &QPushButton::clicked, this,
                    [this, id = comment.id] { remove(id, true); });
            row->addWidget(button, 0, Qt::AlignTop);
        }
        return whole;
    }

    AppContext& context_;
    int64_t attempt_id_, owner_id_, removed_ = 0;
    std::function<double()> moment_;
    ShowMoment show_;
    std::function<void(const std::vector<db::CommentRecord>&)> changed_;
    QVBoxLayout* list_ = nullptr;
    QLineEdit* text_ = nullptr;
    QPushButton* undo_ = nullptr;
    QElapsedTimer added_;  ///< Since the last remark; a slow store counts as no time.
};

}  // namespace

bool may_remark(AppContext& context, int64_t owner_id) {
    return context.may(db::Action::kRemark,
                       db::scope_between(context.store(), context.user().id, owner_id));
}

QWidget* make_comments_card(
    AppContext& context, int64_t attempt_id, int64_t owner_id,
    const std::function<double()>& moment, const ShowMoment& show,
    const std::function<void(const std::vector<db::CommentRecord>&)>& changed) {
    return new CommentsCard(context, attempt_id, owner_id, moment, show, changed);
}

}  // namespace placode::ui
