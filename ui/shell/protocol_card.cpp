// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The card of a study with a protocol: publish, enrol, where everyone stands, withdraw, export.

#include "ui/shell/protocol_card.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <algorithm>

#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "db/unsaved_recordings.h"
#include "ui/shell/device_tester.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_exports.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/study_publishing.h"
#include "ui/shell/study_standing.h"
#include "ui/shell/table_width.h"
#include "ui/shell/typed_texts.h"

namespace placode::ui {
namespace {

constexpr int kShownParticipants = 8;  ///< Of participants, before the table scrolls.
constexpr const char* kDeviceSetting = "study_device";

/// Those that are published, and those that are shipped and could be.
std::vector<std::string> known_studies(AppContext& context) {
    std::vector<std::string> ids = curriculum::list_definitions("studies");
    for (const auto& each : context.store().definitions().list("study"))
        if (std::find(ids.begin(), ids.end(), each.id) == ids.end()) ids.push_back(each.id);
    return ids;
}

class ProtocolCard : public QFrame {
    Q_DECLARE_TR_FUNCTIONS(ProtocolCard)
 public:
    ProtocolCard(AppContext& context, Page& page, const QString& chosen, const QString& participant)
        : context_(context), page_(page), participant_(participant) {
        auto* outer = new QVBoxLayout(this);
        outer->setContentsMargins(0, 0, 0, 0);
        const auto ids = known_studies(context);
        if (ids.empty()) return;
        study_ = chosen_study(context, ids, chosen);
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace12);
        const auto published = db::published_study(context.store(), study_);
        const auto protocol = published ? *published : curriculum::load_study(study_);
        auto* head = new QHBoxLayout;
        head->addWidget(make_label(context.in(protocol.title), "heading"), 1);
        if (ids.size() > 1) head->addWidget(chooser(ids));
        layout->addLayout(head);
        layout->addWidget(make_label(context.in(protocol.description), "muted"));
        if (published)
            addConduct(layout, *published);
        else
            add_publishing(layout, context, page, protocol);
        outer->addWidget(make_card(layout));
    }

 private:
    QComboBox* chooser(const std::vector<std::string>& ids) {
        QComboBox* box = make_study_chooser(context_, ids, study_);
        box->setObjectName("study");
        connect(box, &QComboBox::activated, this, [this, box] {
            study_ = box->currentData().toString().toStdString();
            again();
        });
        return box;
    }

    QPushButton* button(QHBoxLayout* row, const QString& text, const char* role, const char* icon,
                        const char* name, const std::function<void()>& work) {
        QPushButton* made = make_button(context_, text, role, icon);
        made->setObjectName(name);
        connect(made, &QPushButton::clicked, this, work);
        row->addWidget(made);
        return made;
    }

    void addConduct(QVBoxLayout* layout, const curriculum::StudyProtocol& protocol) {
        list_ = db::study_progress(context_.store(), study_);
        add_newer_version(layout, context_, page_, protocol);
        auto* row = new QHBoxLayout;
        row->addWidget(
            make_label(tr("Version %1 · participants: %2").arg(protocol.version).arg(list_.size()),
                       "muted"),
            1);
        addDevices(row, protocol);
        button(row, tr("Enrol a participant"), "primary", "plus", "enrol", [this] { enrol(); });
        layout->addLayout(row);
        if (list_.empty()) return;
        layout->addWidget(makeTable(protocol));
        connect(table_, &QTableWidget::itemSelectionChanged, this, [this] { showDevice(); });
        showDevice();
        layout->addWidget(flow(protocol));
        layout->addLayout(actions());
        layout->addWidget(make_study_exports(context_, page_, study_));
    }

    /// With which device a participant works is the coordinator's choice, once, where the protocol
    /// leaves it open.
    void addDevices(QHBoxLayout* row, const curriculum::StudyProtocol& protocol) {
        const bool open =
            std::any_of(protocol.steps.begin(), protocol.steps.end(),
                        [](const auto& step) { return step.is_attempt() && step.device.empty(); });
        if (!open) return;
        devices_ = new QComboBox;
        devices_->setObjectName("study_device");
        devices_->setAccessibleName(tr("Device of the participant"));
        devices_->setToolTip(
            tr("With what the participant works; it cannot be changed in the run."));
        if (context_.user().demonstration)
            for (const char* script : {"script:expert", "script:intermediate", "script:novice"})
                offer(script);
        const QString last = context_.settings().value(kDeviceSetting).toString();
        each_device(context_, devices_, [this, last](const ListedDevice& device) {
            offer(device.name);
            if (device.name == last && !chosen_) devices_->setCurrentIndex(devices_->count() - 1);
        });
        devices_->setCurrentIndex(std::max(0, devices_->findData(last.isEmpty() ? "mouse" : last)));
        connect(devices_, &QComboBox::activated, this, [this] { chosen_ = true; });
        QLabel* label = make_label(tr("Device"), "muted");
        label->setWordWrap(false);
        label->setBuddy(devices_);
        row->addWidget(label);
        row->addWidget(devices_);
    }

    /// Adds what is not offered yet; its place.
    int offer(const QString& device) {
        if (const int at = devices_->findData(device); at >= 0) return at;
        devices_->addItem(device_name(device.toStdString()), device);
        return devices_->count() - 1;
    }

    /// The device of the participant who is selected: going on changes nothing by accident.
    void showDevice() {
        if (devices_ == nullptr || selected() == nullptr) return;
        const QString own = qstr(selected()->participant.device);
        if (own.isEmpty()) return;
        chosen_ = true;
        devices_->setCurrentIndex(offer(own));
    }

    QTableWidget* makeTable(const curriculum::StudyProtocol& protocol) {
        table_ = make_table({tr("Code"), tr("Steps"), tr("Next"), tr("Last"), tr("Remark")},
                            tr("Where everyone stands"));
        table_->setObjectName("progress_table");
        table_->setSortingEnabled(false);
        table_->setRowCount(static_cast<int>(list_.size()));
        for (int row = 0; row < table_->rowCount(); ++row) {
            const db::Progress& each = list_[static_cast<size_t>(row)];
            const auto* next = protocol.step(each.next);
            const QString remark = standing_remark(context_, protocol, each);
            table_->setItem(row, 0, make_cell(qstr(each.participant.code)));
            table_->setItem(
                row, 1, make_number_cell(tr("%1 of %2").arg(each.done).arg(each.total), each.done));
            table_->setItem(row, 2,
                            make_cell(each.participant.withdrawal ? QString()
                                      : next == nullptr           ? tr("finished")
                                                                  : context_.in(next->title)));
            table_->setItem(
                row, 3, make_cell(each.last_utc.empty() ? QString() : format_when(each.last_utc)));
            table_->setItem(row, 4, make_cell(remark));
            table_->item(row, 4)->setToolTip(remark);
        }
        fit_columns(table_, 4);
        keep_within(table_, {.stretch = 4, .least_px = 300, .keep_px = 300});
        wrap_rows(table_, kShownParticipants);
        table_->selectRow(std::max(0, rowOf(participant_)));
        return table_;
    }

    [[nodiscard]] int rowOf(const QString& code) const {
        const auto found = std::find_if(list_.begin(), list_.end(), [&](const db::Progress& each) {
            return qstr(each.participant.code) == code;
        });
        return found == list_.end() ? -1 : static_cast<int>(found - list_.begin());
    }

    /// How many have done which step, and who left.
    QLabel* flow(const curriculum::StudyProtocol& protocol) {
        QStringList words;
        for (const auto& step : protocol.steps) {
            const auto has = [&](const std::vector<std::string>& keys) {
                return std::find(keys.begin(), keys.end(), "1/" + step.id) != keys.end();
            };
            const auto done = std::count_if(list_.begin(), list_.end(), [&](const auto& each) {
                return has(each.finished) && !has(each.skipped);
            });
            words << QString("%1: %2").arg(context_.in(step.title)).arg(done);
        }
        const auto left = std::count_if(list_.begin(), list_.end(), [](const auto& each) {
            return each.participant.withdrawal.has_value();
        });
        words << tr("withdrew: %1").arg(left);
        QLabel* label = make_label(words.join(" · "), "small");
        label->setObjectName("flow");
        return label;
    }

    [[nodiscard]] const db::Progress* selected() const {
        const int row = table_->currentRow();
        return row < 0 ? nullptr : &list_[static_cast<size_t>(row)];
    }

    QHBoxLayout* actions() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        button(row, tr("Continue"), "secondary", "play", "continue_participant", [this] {
            if (selected() != nullptr) run(selected()->participant.code);
        });
        button(row, tr("Procedures"), "secondary", "data", "participant_data", [this] {
            if (selected() != nullptr)
                Q_EMIT page_.go({PageId::kStudyData,
                                 0,
                                 qstr(selected()->participant.code),
                                 {{"study", qstr(study_)}}});
        });
        row->addStretch();
        mode_ = new QComboBox;
        mode_->setObjectName("withdraw_mode");
        mode_->setAccessibleName(tr("What becomes of the data"));
        mode_->addItem(tr("use the data to date"), static_cast<int>(db::WithdrawalMode::kKeep));
        mode_->addItem(tr("use the data no more"), static_cast<int>(db::WithdrawalMode::kStop));
        mode_->addItem(tr("erase the data"), static_cast<int>(db::WithdrawalMode::kErase));
        keep_choice(mode_);
        row->addWidget(mode_);
        reason_ = new QLineEdit;
        reason_->setObjectName("withdraw_reason");
        reason_->setAccessibleName(tr("Reason"));
        reason_->setPlaceholderText(tr("Reason, or: not given"));
        reason_->setMinimumWidth(
            reason_->fontMetrics().horizontalAdvance(reason_->placeholderText()) + 2 * kSpace16);
        row->addWidget(reason_);
        button(row, tr("Withdraw"), "danger", "close", "withdraw", [this] { withdraw(); });
        return row;
    }

    void enrol() {
        context_.guard(tr("Making a participant code"), [this] {
            context_.require(db::Action::kRunQuestionnaire);
            const std::string code =
                context_.store().studies().new_participant(study_, context_.user().demonstration);
            // Whoever only lists people beforehand keeps the screen.
            confirm(window(), tr("%1 is enrolled").arg(qstr(code)),
                    tr("Hand the screen over now? The participant answers and operates; you take "
                       "it back with your password."),
                    tr("Hand over"), tr("Not yet"))
                ? run(code)
                : enrolled(code);
        });
    }

    /// In the list, with the device that was chosen, for "Continue".
    void enrolled(const std::string& code) {
        setDevice(code);
        Q_EMIT page_.notice(
            tr("%1 is enrolled. \"Continue\" hands the screen over.").arg(qstr(code)));
        Q_EMIT page_.go(
            {PageId::kStudies, 0, {}, {{"study", qstr(study_)}, {"participant", qstr(code)}}});
    }

    /// None of the three can be taken back, and the list begins with somebody selected.
    [[nodiscard]] bool asksToWithdraw(const std::string& code, db::WithdrawalMode mode) {
        if (mode == db::WithdrawalMode::kErase)
            return confirm(this, tr("Erase the data of %1?").arg(qstr(code)),
                           tr("Answers and attempts of the study are deleted. The code stays."),
                           tr("Erase"));
        return confirm(this, tr("Withdraw %1?").arg(qstr(code)),
                       mode == db::WithdrawalMode::kKeep
                           ? tr("The run ends here for good. The data to date may be used.")
                           : tr("The run ends here for good. The data are used no more."),
                       tr("Withdraw"));
    }

    void withdraw() {
        if (selected() == nullptr) return;
        const std::string code = selected()->participant.code;
        const auto mode = static_cast<db::WithdrawalMode>(mode_->currentData().toInt());
        if (!asksToWithdraw(code, mode)) return;
        context_.guard(tr("Withdrawing %1").arg(qstr(code)), [&] {
            context_.require(db::Action::kRunQuestionnaire);
            context_.store().studies().withdraw(study_, code, mode,
                                                reason_->text().trimmed().toStdString());
            if (mode != db::WithdrawalMode::kErase) return again();
            (void)db::unsaved_recordings(context_.recordingsFolder().toStdString(), {study_, code},
                                         db::Unsaved::kRemove);
            // The page says where the data may still be.
            Q_EMIT page_.go(
                {PageId::kStudies, 0, {}, {{"study", qstr(study_)}, {"erased", qstr(code)}}});
        });
    }

    void setDevice(const std::string& code) {
        if (devices_ == nullptr) return;
        const QString device = devices_->currentData().toString();
        context_.settings().setValue(kDeviceSetting, device);
        context_.store().studies().set_participant_device(study_, code, device.toStdString());
    }

    /// The device is set, then the screen is the participant's.
    void run(const std::string& code) {
        context_.guard(tr("Handing the screen over"), [&] {
            context_.require(db::Action::kRunQuestionnaire);
            setDevice(code);
            Q_EMIT page_.go({PageId::kStudyRun, 0, qstr(code), {{"study", qstr(study_)}}});
        });
    }
    void again() { Q_EMIT page_.go({PageId::kStudies, 0, {}, {{"study", qstr(study_)}}}); }

    AppContext& context_;
    Page& page_;
    QString participant_;  ///< Selected at first; empty: the first one.
    std::string study_;
    std::vector<db::Progress> list_;
    QTableWidget* table_ = nullptr;
    QComboBox* devices_ = nullptr;  ///< nullptr: the protocol says it for every step.
    bool chosen_ = false;           ///< Somebody has chosen; what is found later changes nothing.
    QComboBox* mode_ = nullptr;
    QLineEdit* reason_ = nullptr;
};

}  // namespace

QWidget* make_protocol_card(AppContext& context, Page& page, const QString& study,
                            const QString& participant) {
    return new ProtocolCard(context, page, study, participant);
}

}  // namespace placode::ui
