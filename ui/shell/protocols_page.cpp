// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Protocols: build studies and questionnaires, checked while they are written, seen as participants
// will see them, published for good, imported and exported as files.

#include <QComboBox>
#include <QFile>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTimer>
#include <algorithm>
#include <optional>

#include "curriculum/draft_text.h"
#include "curriculum/study.h"
#include "db/study_conduct.h"
#include "reports/export.h"
#include "ui/shell/definition_elements.h"
#include "ui/shell/definition_fields.h"
#include "ui/shell/pages.h"
#include "ui/shell/parts.h"
#include "ui/shell/study_parts.h"
#include "ui/shell/study_preview.h"

namespace placode::ui {
namespace {

constexpr int kDeepest = 64;  // levels of brackets, as curriculum/json_reader.cpp takes

class ProtocolsPage : public Page {
    Q_DECLARE_TR_FUNCTIONS(ProtocolsPage)
 public:
    ProtocolsPage(AppContext& context, const Place& place)
        : Page(context), kind_(place.state.value("kind", "study").toString()) {
        context.require(db::Action::kRunQuestionnaire);
        QVBoxLayout* column = make_column(this, 1280);
        column->addLayout(head());
        status_ = make_label({}, "good");
        status_->setObjectName("definition_status");
        column->addWidget(status_);
        elements_ = new DefinitionElements(context, isStudy());
        elements_->changed = [this] { formChanged(); };
        elements_->ready = [this] {
            catchUp();
            return readable_;
        };
        column->addWidget(elements_);
        column->addWidget(jsonCard());
        column->addWidget(publishCard());
        preview_ = new QVBoxLayout;
        column->addLayout(preview_);
        column->addStretch();
        QString text = place.state.value("text").toString();
        // A link names the definition, shipped or published.
        if (const QString id = place.state.value("id").toString(); text.isEmpty() && !id.isEmpty())
            for (int i = 0; i < chooser_->count() && text.isEmpty(); ++i)
                if (chooser_->itemData(i).toString().section('/', 0, 0) == id) {
                    chooser_->setCurrentIndex(i);
                    text = textOf(chooser_->itemData(i).toString());
                }
        if (const QVariant chosen = place.state.value("chosen"); chosen.isValid())
            chooser_->setCurrentIndex(std::max(0, chooser_->findData(chosen)));
        shown_ = chooser_->currentIndex();
        setText(text.isEmpty() ? firstText() : text);
        elements_->choose(place.state.value("row", 0).toInt());
        if (isStudy() && place.state.value("part").toString() == "consent")
            elements_->chooseConsent();
        unsaved_ = place.state.value("unsaved").toBool();
    }

    [[nodiscard]] QString title() const override { return tr("Protocols"); }
    [[nodiscard]] QVariantMap state() const override {
        return {{"kind", kind_},
                {"text", json_->toPlainText()},
                {"unsaved", unsaved_},
                {"chosen", chooser_->currentData()},
                {"row", elements_->row()}};
    }
    [[nodiscard]] bool mayLeave() override {
        if (!unsaved_ || leaving_) return true;
        return confirm(this, tr("Leave without saving?"),
                       tr("The text was changed and neither published nor exported."), tr("Leave"),
                       tr("Stay here"));
    }

 private:
    [[nodiscard]] bool isStudy() const { return kind_ == "study"; }
    [[nodiscard]] std::string kindText() const { return kind_.toStdString(); }

    QLayout* head() {
        auto* both = new QVBoxLayout;
        both->setSpacing(kSpace12);
        auto* title = new QHBoxLayout;
        title->addWidget(make_label(tr("Protocols"), "display"), 1);
        both->addLayout(title);
        auto* row = new QHBoxLayout;  // Of its own: titles of studies are long.
        row->setSpacing(kSpace8);
        both->addLayout(row);
        auto* kinds = new QComboBox;
        kinds->setObjectName("definition_kind");
        kinds->setAccessibleName(tr("Kind"));
        kinds->addItem(tr("Study"), "study");
        kinds->addItem(tr("Questionnaire"), "questionnaire");
        kinds->setCurrentIndex(isStudy() ? 0 : 1);
        connect(kinds, &QComboBox::activated, this, [this, kinds] {
            const QString kind = kinds->currentData().toString();
            kinds->setCurrentIndex(isStudy() ? 0 : 1);  // Whoever stays here is at this kind.
            Q_EMIT go({PageId::kProtocols, 0, {}, {{"kind", kind}}});
        });
        row->addWidget(kinds);
        chooser_ = new QComboBox;
        chooser_->setObjectName("definition_id");
        chooser_->setAccessibleName(tr("Definition"));
        fillChooser();
        connect(chooser_, &QComboBox::activated, this, [this] {
            if (!mayLeave()) return chooser_->setCurrentIndex(shown_);
            shown_ = chooser_->currentIndex();
            setText(textOf(chooser_->currentData().toString()));
        });
        row->addWidget(chooser_, 1);
        title->addWidget(
            make_action(context_, this, tr("New"), "quiet", "plus", "definition_new", [this] {
                if (mayLeave()) setText(empty_definition(isStudy()));
            }));
        return both;
    }

    /// Every published version, then what is shipped.
    void fillChooser() {
        for (const auto& each : context_.store().definitions().list(kindText()))
            chooser_->addItem(tr("%1, version %2, published")
                                  .arg(definition_title(each.json, each.id, context_.language()))
                                  .arg(each.version),
                              qstr(each.id) + "/" + QString::number(each.version));
        const std::string folder = isStudy() ? "studies" : "questionnaires";
        for (const std::string& id : curriculum::list_definitions(folder))
            chooser_->addItem(
                tr("%1, shipped")
                    .arg(definition_title(textOf(qstr(id)).toStdString(), id, context_.language())),
                qstr(id));
        for (int i = 0; i < chooser_->count(); ++i)
            chooser_->setItemData(i, chooser_->itemData(i), Qt::ToolTipRole);
        chooser_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        chooser_->setMinimumContentsLength(26);
    }

    [[nodiscard]] QString textOf(const QString& name) const {
        QString text;
        context_.guard(tr("Opening the definition"), [&] {
            const std::string id = name.section('/', 0, 0).toStdString();
            if (name.contains('/'))
                text = qstr(context_.store()
                                .definitions()
                                .find(kindText(), id, name.section('/', 1).toInt())
                                ->json);
            else
                text = qstr(isStudy() ? curriculum::load_study(id).json
                                      : curriculum::load_questionnaire(id).json);
        });
        return text;
    }
    [[nodiscard]] QString firstText() const {
        const QString name = chooser_->currentData().toString();
        return name.isEmpty() ? empty_definition(isStudy()) : textOf(name);
    }

    QWidget* jsonCard() {
        auto* layout = new QVBoxLayout;
        layout->setSpacing(kSpace8);
        auto* row = new QHBoxLayout;
        row->addWidget(make_label(tr("As a file (JSON)"), "heading"), 1);
        row->addWidget(make_action(context_, this, tr("Import"), "quiet", "plus",
                                   "definition_import", [this] { importFile(); }));
        row->addWidget(make_action(context_, this, tr("Export"), "quiet", "download",
                                   "definition_export", [this] { exportFile(); }));
        layout->addLayout(row);
        json_ = new QPlainTextEdit;
        json_->setObjectName("definition_json");
        json_->setAccessibleName(tr("Text of the definition"));
        json_->setLineWrapMode(QPlainTextEdit::NoWrap);
        json_->setTabChangesFocus(true);
        json_->setMinimumHeight(260);
        json_->setStyleSheet("font-family: 'DejaVu Sans Mono', monospace;");
        // While it is typed: a moment after the last key.
        timer_ = new QTimer(this);
        timer_->setSingleShot(true);
        timer_->setInterval(250);
        connect(timer_, &QTimer::timeout, this, [this] { jsonChanged(); });
        connect(json_, &QPlainTextEdit::textChanged, this, [this] {
            if (filling_) return;
            unsaved_ = true;
            timer_->start();
        });
        layout->addWidget(json_);
        return make_card(layout);
    }

    QWidget* publishCard() {
        auto* row = new QHBoxLayout;
        row->setSpacing(kSpace8);
        row->addWidget(make_action(context_, this, tr("Preview"), "secondary", "play",
                                   "definition_preview", [this] { preview(); }));
        reason_ = new QLineEdit;
        reason_->setObjectName("publish_reason");
        reason_->setAccessibleName(tr("Reason of the change"));
        reason_->setPlaceholderText(tr("Reason of the change, from version 2 on"));
        row->addWidget(reason_, 1);
        publish_ = make_action(context_, this, tr("Publish"), "primary", "check",
                               "definition_publish", [this] { publish(); });
        row->addWidget(publish_);
        return make_card(row);
    }

    void setText(const QString& text) {
        timer_->stop();
        filling_ = true;
        json_->setPlainText(text);
        filling_ = false;
        unsaved_ = false;
        elements_->forgetRemoved();
        jsonChanged();
    }

    /// The text leads: list and form follow where it can be read. Where it cannot, they wait: they
    /// hold what it was before, and one touch would write that over what was typed since.
    void jsonChanged() {
        // What stands deeper than any definition is not taken over: copying it goes as deep.
        bool deep = false;
        const auto read = OrderedJson::parse(
            json_->toPlainText().toStdString(),
            [&deep](int depth, OrderedJson::parse_event_t, OrderedJson&) {
                deep = deep || depth > kDeepest;
                return depth <= kDeepest;
            },
            false);
        readable_ = !deep && read.is_object();
        elements_->setEnabled(readable_);
        check();
        if (readable_) elements_->follow(read);
    }

    /// What was typed a moment ago is read now.
    void catchUp() {
        if (!timer_->isActive()) return;
        timer_->stop();
        jsonChanged();
    }

    /// The form leads: the text follows, unless it holds what the form does not know yet. Then the
    /// timer reads it: made anew now, the form would take away the field that is speaking.
    void formChanged() {
        if (timer_->isActive()) return;
        unsaved_ = true;
        filling_ = true;
        json_->setPlainText(qstr(elements_->definition().dump(2)));
        filling_ = false;
        check();
    }

    /// Empty when the text can be published.
    [[nodiscard]] QString problem() const {
        const std::string text = json_->toPlainText().toStdString();
        try {
            if (isStudy())
                check_study_questionnaires(context_, curriculum::load_study_text(text, kindText()));
            else
                (void)curriculum::load_questionnaire_text(text, kindText());
            return {};
        } catch (const std::exception& error) {
            return QString::fromUtf8(error.what());
        }
    }

    void check() {
        const QString found = problem();
        if (found.isEmpty())
            status_->setText(tr("No errors."));
        else
            status_->setText(
                readable_ ? found : tr("The form waits until the text can be read: %1").arg(found));
        status_->setProperty("role", found.isEmpty() ? "good" : "critical");
        status_->style()->unpolish(status_);
        status_->style()->polish(status_);
        publish_->setEnabled(found.isEmpty());
    }

    void preview() {
        if (!problem().isEmpty()) return check();
        leaving_ = true;
        const std::string text = json_->toPlainText().toStdString();
        if (!isStudy()) {
            Q_EMIT go({PageId::kParticipant,
                       0,
                       {},
                       {{"preview", json_->toPlainText()}, {"unsaved", unsaved_}}});
            return;
        }
        while (QLayoutItem* item = preview_->takeAt(0)) {
            if (item->widget() != nullptr) item->widget()->deleteLater();
            delete item;
        }
        leaving_ = false;
        context_.guard(tr("Preview"), [&] {
            preview_->addWidget(
                make_study_preview(context_, curriculum::load_study_text(text, kindText())));
        });
    }

    void publish() {
        catchUp();
        context_.guard(tr("Publishing"), [&] {
            context_.require(db::Action::kRunQuestionnaire);
            db::DefinitionRecord record;
            record.kind = kindText();
            record.json = json_->toPlainText().toStdString();
            record.reason = reason_->text().trimmed().toStdString();
            std::optional<curriculum::StudyProtocol> study;
            if (isStudy()) {
                study = curriculum::load_study_text(record.json, kindText());
                if (record.reason.empty()) record.reason = ownReason(*study);
                record.id = study->id, record.version = study->version;
            } else {
                const auto read = curriculum::load_questionnaire_text(record.json, kindText());
                record.id = read.id, record.version = read.version;
            }
            if (!mayPublish(record)) return;
            if (study) publish_questionnaires(context_, *study);
            context_.store().definitions().publish(record);
            unsaved_ = false;
            chooser_->clear();
            fillChooser();
            chooser_->setCurrentIndex(
                chooser_->findData(qstr(record.id) + "/" + QString::number(record.version)));
            shown_ = chooser_->currentIndex();
            Q_EMIT notice(tr("%1 version %2 is published; it is never changed from now on.")
                              .arg(qstr(record.id))
                              .arg(record.version));
        });
    }

    /// Why this version differs, as its text says; empty where that is still the reason of the
    /// version before.
    [[nodiscard]] std::string ownReason(const curriculum::StudyProtocol& study) {
        const auto before = context_.store().definitions().find(kindText(), study.id);
        if (!before || before->version == study.version) return study.reason;
        const bool same =
            curriculum::load_study_text(before->json, kindText()).reason == study.reason;
        return same ? std::string() : study.reason;
    }

    /// One question: about a text that still calls itself a draft, or that it is for good.
    [[nodiscard]] bool mayPublish(const db::DefinitionRecord& record) {
        if (curriculum::draft_text(record.json))
            return confirm_draft(context_, window(), record.json);
        return confirm(window(), tr("Publish version %1?").arg(record.version),
                       tr("A published version is never changed; a change is the next one."),
                       publish_->text());
    }

    void importFile() {
        if (!mayLeave()) return;
        const QString path = context_.askOpenFile(this, tr("Import a definition"), "JSON (*.json)");
        if (path.isEmpty()) return;
        context_.guard(tr("Importing a definition"), [&] {
            setText(qstr(reports::read_file(path.toStdString())));
            unsaved_ = true;
        });
    }

    /// Of a text that was never readable there is no definition, and its id may be anything.
    [[nodiscard]] QString name() const {
        const OrderedJson& definition = elements_->definition();
        if (!definition.is_object()) return "definition";
        const auto id = definition.find("id");
        return id != definition.end() && id->is_string() ? qstr(id->get<std::string>())
                                                         : QString("definition");
    }

    void exportFile() {
        const QString name = this->name() + ".json";
        const QString path =
            context_.askSaveFile(this, tr("Export the definition"), name, "JSON (*.json)");
        if (path.isEmpty()) return;
        context_.guard(tr("Exporting the definition"), [&] {
            reports::save_file(path.toStdString(), json_->toPlainText().toStdString());
            unsaved_ = false;
            Q_EMIT written(tr("Written: %1").arg(path), path);
        });
    }

    QString kind_;
    QComboBox* chooser_ = nullptr;
    int shown_ = 0;  ///< Row of the chooser whose definition was opened last.
    DefinitionElements* elements_ = nullptr;
    QPlainTextEdit* json_ = nullptr;
    QLineEdit* reason_ = nullptr;
    QPushButton* publish_ = nullptr;
    QLabel* status_ = nullptr;
    QVBoxLayout* preview_ = nullptr;
    QTimer* timer_ = nullptr;
    bool filling_ = false, unsaved_ = false, leaving_ = false;
    bool readable_ = false;  ///< The text, when it was last read: it is one object.
};

}  // namespace

Page* make_protocols_page(AppContext& context, const Place& place) {
    return new ProtocolsPage(context, place);
}

}  // namespace placode::ui
