// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/shell/answer_fields.h"

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QCoreApplication>
#include <QGridLayout>
#include <QLineEdit>
#include <QLocale>
#include <QPlainTextEdit>
#include <QRadioButton>
#include <QRegularExpressionValidator>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>
#include <memory>

#include "ui/shell/participant_steps.h"
#include "ui/shell/parts.h"

namespace placode::ui {
namespace {

using curriculum::ItemKind;
using curriculum::QuestionnaireItem;

constexpr int kNoValue = 1000;  ///< "does not apply" among the values of a scale.

/// Says when it is left, whatever stands in it.
class TypedField : public QLineEdit {
 public:
    TypedField(const QString& text, std::function<void()> left)
        : QLineEdit(text), left_(std::move(left)) {}

 protected:
    void focusOutEvent(QFocusEvent* event) override {
        QLineEdit::focusOutEvent(event);
        // Another window in front, or the field's own menu, is not the end of typing.
        if (event->reason() != Qt::ActiveWindowFocusReason &&
            event->reason() != Qt::PopupFocusReason && left_)
            left_();
    }

 private:
    std::function<void()> left_;
};

class AnswerFields {
    Q_DECLARE_TR_FUNCTIONS(ParticipantPage)
 public:
    AnswerFields(QVBoxLayout* layout, AppContext& context, AnswerField field)
        : layout_(layout), context_(context), field_(std::move(field)), item_(field_.item) {
        // "NA" is the box's answer; the fields themselves have none then.
        applies_ = !item_.not_applicable || field_.given != curriculum::kNotApplicable;
        if (applies_) *own_ = field_.given;
        keep_ = [own = own_, keep = field_.keep](const QString& answer) {
            *own = answer;
            keep(answer);
        };
    }

    void add() {
        switch (item_.kind) {
            case ItemKind::kLikert:
                if (item_.point_labels.empty())
                    layout_->addLayout(scale());
                else
                    layout_->addLayout(labelledScale());
                break;
            case ItemKind::kChoice:
                layout_->addWidget(choice());
                break;
            case ItemKind::kMultiple:
                layout_->addLayout(multiple());
                break;
            case ItemKind::kDate:
                layout_->addWidget(date());
                break;
            case ItemKind::kVisualAnalogue:
                layout_->addLayout(analogue());
                break;
            default:
                layout_->addWidget(line());
        }
        if (!item_.not_applicable || item_.kind == ItemKind::kLikert) return;
        layout_->addWidget(doesNotApply());
        if (!applies_) show_({}, false);
    }

 private:
    /// Sets the field without giving an answer: empty = none; false = "does not apply" is ticked.
    using Show = std::function<void(const QString&, bool)>;

    /// The points of a scale side by side, the words at its ends beside them; above them where
    /// there are many points, in rows of at most 11.
    QLayout* scale() {
        constexpr int kFew = 7, kLine = 11;
        const bool few = item_.scale_max - item_.scale_min < kFew;
        QLabel* low = make_label(context_.in(item_.anchor_low), "muted");
        QLabel* high = make_label(context_.in(item_.anchor_high), "muted");
        auto* grid = new QGridLayout;
        grid->setSpacing(kSpace4);
        auto* group = new QButtonGroup(field_.owner);
        for (int value = item_.scale_min; value <= item_.scale_max; ++value) {
            const int at = value - item_.scale_min;
            grid->addWidget(point(value, few ? 72 : 56, group), at / kLine, at % kLine);
        }
        QObject::connect(group, &QButtonGroup::idClicked, field_.owner,
                         [keep = field_.keep](int value) {
                             keep(value == kNoValue ? QString(curriculum::kNotApplicable)
                                                    : QString::number(value));
                         });
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        auto* points = new QVBoxLayout;
        if (few) {
            for (QLabel* label : {low, high}) label->setFixedWidth(150);
            low->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
            row->addWidget(low);
        } else {
            high->setAlignment(Qt::AlignRight);
            auto* ends = new QHBoxLayout;  // Above, over the ends of the points.
            ends->addWidget(low);
            ends->addWidget(high);
            points->addLayout(ends);
        }
        points->addLayout(grid);
        row->addLayout(points);
        if (few) row->addWidget(high);
        row->addStretch();
        auto* column = new QVBoxLayout;
        column->addLayout(row);
        if (item_.not_applicable) column->addWidget(doesNotApplyPoint(group), 0, Qt::AlignLeft);
        return column;
    }

    QRadioButton* point(int value, int width, QButtonGroup* group) {
        auto* button = new QRadioButton(QString::number(value));
        button->setObjectName(QString("answer_%1_%2").arg(qstr(item_.id)).arg(value));
        QString name = tr("%1: %2 of %3").arg(field_.question).arg(value).arg(item_.scale_max);
        if (value == item_.scale_min) name += ", " + context_.in(item_.anchor_low);
        if (value == item_.scale_max) name += ", " + context_.in(item_.anchor_high);
        button->setAccessibleName(name);
        button->setMinimumSize(width, kTouchTarget);
        button->setChecked(field_.given == QString::number(value));
        group->addButton(button, value);
        return button;
    }

    QRadioButton* doesNotApplyPoint(QButtonGroup* group) {
        auto* none = new QRadioButton(tr("does not apply"));
        none->setObjectName(QString("answer_%1_NA").arg(qstr(item_.id)));
        none->setMinimumHeight(kTouchTarget);
        none->setChecked(field_.given == curriculum::kNotApplicable);
        group->addButton(none, kNoValue);
        return none;
    }

    /// Every value with its words, one below the other.
    QVBoxLayout* labelledScale() {
        auto* column = new QVBoxLayout;
        auto* group = new QButtonGroup(field_.owner);
        const auto add = [&](int value, const QString& text, const QString& name, bool checked) {
            auto* button = new QRadioButton(text);
            button->setObjectName(QString("answer_%1_%2").arg(qstr(item_.id), name));
            button->setMinimumHeight(kTouchTarget);
            button->setChecked(checked);
            group->addButton(button, value);
            column->addWidget(button);
        };
        for (int value = item_.scale_min; value <= item_.scale_max; ++value) {
            const auto& label = item_.point_labels.at(static_cast<size_t>(value - item_.scale_min));
            const QString number = QString::number(value);
            add(value, number + "  " + context_.in(label), number, field_.given == number);
        }
        if (item_.not_applicable)
            add(kNoValue, tr("does not apply"), "NA", field_.given == curriculum::kNotApplicable);
        QObject::connect(group, &QButtonGroup::idClicked, field_.owner,
                         [keep = field_.keep](int value) {
                             keep(value == kNoValue ? QString(curriculum::kNotApplicable)
                                                    : QString::number(value));
                         });
        return column;
    }

    QVBoxLayout* multiple() {
        auto* column = new QVBoxLayout;
        std::vector<QCheckBox*> boxes;
        for (size_t i = 0; i < item_.choices.size(); ++i) {
            auto* box = new QCheckBox(context_.in(item_.choices[i]));
            box->setObjectName(QString("answer_%1_%2").arg(qstr(item_.id)).arg(i));
            box->setMinimumHeight(kTouchTarget);
            boxes.push_back(box);
            column->addWidget(box);
        }
        show_ = [boxes](const QString& answer, bool applies) {
            const std::vector<int> chosen =
                curriculum::answer_indices(answer.toStdString()).value_or(std::vector<int>{});
            for (size_t i = 0; i < boxes.size(); ++i) {
                boxes[i]->setEnabled(applies);
                boxes[i]->setChecked(std::count(chosen.begin(), chosen.end(), static_cast<int>(i)) >
                                     0);
            }
        };
        show_(*own_, true);
        for (QCheckBox* box : boxes) {
            QObject::connect(box, &QCheckBox::clicked, field_.owner, [keep = keep_, boxes] {
                QStringList chosen;
                for (size_t i = 0; i < boxes.size(); ++i)
                    if (boxes[i]->isChecked()) chosen << QString::number(i);
                keep(chosen.join(';'));
            });
        }
        return column;
    }

    QWidget* date() {
        auto* edit = new TypedField(*own_, field_.left);
        show_ = showing(edit);
        edit->setObjectName("answer_" + qstr(item_.id));
        edit->setAccessibleName(context_.in(item_.text));
        edit->setPlaceholderText(tr("year-month-day, e.g. 2026-11-21"));
        edit->setMaximumWidth(320);
        QObject::connect(edit, &QLineEdit::textChanged, field_.owner,
                         [keep = keep_, edit] { keep(edit->text().trimmed()); });
        return edit;
    }

    static Show showing(QLineEdit* edit) {
        return [edit](const QString& answer, bool applies) {
            const QSignalBlocker quiet(edit);
            edit->setText(answer);
            edit->setEnabled(applies);
        };
    }

    /// A line without marks. Nothing is answered before it was touched.
    QHBoxLayout* analogue() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace12);
        row->addWidget(make_label(context_.in(item_.anchor_low), "muted"));
        auto* slider = new QSlider(Qt::Horizontal);
        slider->setObjectName("answer_" + qstr(item_.id));
        slider->setAccessibleName(context_.in(item_.text));
        // Whole numbers on a long scale, a hundredth of the line on a short one.
        const double span = item_.number_max - item_.number_min;
        const double unit = span >= 20 ? 1 : span / 100;
        slider->setRange(0, static_cast<int>(std::lround(span / unit)));
        slider->setMinimumSize(360, kTouchTarget);
        auto* state = make_label({}, "small");
        show_ = [slider, state, unit, low = item_.number_min](const QString& answer, bool applies) {
            const QSignalBlocker quiet(slider);
            const auto given = curriculum::answer_number(answer.toStdString());
            slider->setValue(given ? static_cast<int>(std::lround((*given - low) / unit))
                                   : slider->maximum() / 2);
            slider->setEnabled(applies);
            state->setText(applies && answer.isEmpty() ? tr("not answered") : tr("answered"));
        };
        show_(*own_, true);
        const auto take = [keep = keep_, slider, state, unit, low = item_.number_min] {
            keep(QString::number(low + unit * slider->value(), 'g', 6));
            state->setText(tr("answered"));
        };
        QObject::connect(slider, &QSlider::valueChanged, field_.owner, take);
        QObject::connect(slider, &QSlider::sliderReleased, field_.owner,
                         take);  // a tap on the middle counts
        row->addWidget(slider, 1);
        row->addWidget(make_label(context_.in(item_.anchor_high), "muted"));
        row->addWidget(state);
        return row;
    }

    QWidget* doesNotApply() {
        auto* box = new QCheckBox(tr("does not apply"));
        box->setObjectName(QString("answer_%1_NA").arg(qstr(item_.id)));
        box->setChecked(!applies_);
        // What stood in the field is put aside and comes back: field and answer say the same.
        QObject::connect(box, &QCheckBox::clicked, field_.owner,
                         [show = show_, keep = field_.keep, own = own_](bool on) {
                             show(on ? QString() : *own, !on);
                             keep(on ? QString(curriculum::kNotApplicable) : *own);
                         });
        return box;
    }

    QWidget* choice() {
        auto* box = new QComboBox;
        box->setObjectName("answer_" + qstr(item_.id));
        box->setAccessibleName(context_.in(item_.text));
        box->addItem(tr("Choose …"), -1);
        for (size_t i = 0; i < item_.choices.size(); ++i)
            box->addItem(context_.in(item_.choices[i]), static_cast<int>(i));
        show_ = [box](const QString& answer, bool applies) {
            const QSignalBlocker quiet(box);
            box->setCurrentIndex(answer.isEmpty() ? 0 : answer.toInt() + 1);
            box->setEnabled(applies);
        };
        show_(*own_, true);
        box->setMaximumWidth(420);
        QObject::connect(box, &QComboBox::currentIndexChanged, field_.owner, [keep = keep_, box] {
            const int value = box->currentData().toInt();
            keep(value < 0 ? QString() : QString::number(value));
        });
        return box;
    }

    QWidget* line() {
        if (item_.kind == ItemKind::kText) {
            auto* edit = new QPlainTextEdit(*own_);
            show_ = [edit](const QString& answer, bool applies) {
                const QSignalBlocker quiet(edit);
                edit->setPlainText(answer);
                edit->setEnabled(applies);
            };
            edit->setObjectName("answer_" + qstr(item_.id));
            edit->setAccessibleName(context_.in(item_.text));
            edit->setTabChangesFocus(true);
            edit->setFixedHeight(110);
            QObject::connect(edit, &QPlainTextEdit::textChanged, field_.owner,
                             [keep = keep_, edit] { keep(edit->toPlainText().trimmed()); });
            return edit;
        }
        auto* edit = new TypedField(*own_, field_.left);
        show_ = showing(edit);
        // A letter would be silently wrong until the review.
        edit->setValidator(new QRegularExpressionValidator(
            QRegularExpression(item_.number_min < 0 ? "-?[0-9]{0,9}([.,][0-9]{0,6})?"
                                                    : "[0-9]{0,9}([.,][0-9]{0,6})?"),
            edit));
        edit->setObjectName("answer_" + qstr(item_.id));
        edit->setAccessibleName(context_.in(item_.text));
        const auto said = [](double limit) { return QLocale().toString(limit, 'g', 6); };
        edit->setPlaceholderText(
            tr("%1 to %2")
                .arg(said(item_.number_min), with_unit(said(item_.number_max), item_.unit)));
        edit->setMaximumWidth(240);
        // A comma is a decimal point to half of Europe; the store always holds '.'.
        QObject::connect(edit, &QLineEdit::textChanged, field_.owner,
                         [keep = keep_, edit] { keep(edit->text().trimmed().replace(',', '.')); });
        return edit;
    }

    QVBoxLayout* layout_;
    AppContext& context_;
    AnswerField field_;
    const QuestionnaireItem& item_;
    bool applies_ = true;  ///< "Does not apply" was not the answer so far.
    /// What the field says, also while "does not apply" is ticked and the field is empty.
    std::shared_ptr<QString> own_ = std::make_shared<QString>();
    std::function<void(const QString&)> keep_;  ///< An answer of the field itself.
    Show show_;
};

}  // namespace

void add_answer_field(QVBoxLayout* layout, AppContext& context, const AnswerField& field) {
    AnswerFields(layout, context, field).add();
}

}  // namespace placode::ui
