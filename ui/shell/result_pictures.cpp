// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// Result: where a slit leaks, the field with damage or energy, the incision, and the paths of the
// instruments.

#include <QButtonGroup>
#include <QGridLayout>
#include <QStackedLayout>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "assessment/leak_map.h"
#include "reports/leak_figure.h"
#include "reports/words.h"
#include "ui/shell/result_cards.h"

namespace placode::ui {
namespace {

struct Pictures {
    Q_DECLARE_TR_FUNCTIONS(ResultPage)
};

/// "12 o'clock, placode: 2" and so on: the map for who cannot see it.
QString map_words(const std::vector<assessment::LedgerEntry>& entries) {
    QStringList lines;
    const auto counts = reports::damage_by_sector(entries);
    for (size_t hour = 0; hour < 12; ++hour)
        for (size_t region = 0; region < assessment::kRegions; ++region)
            if (counts[hour][region] > 0)
                lines << Pictures::tr("%1 o'clock, %2: %3")
                             .arg(hour == 0 ? 12 : hour)
                             .arg(reports::region_words(static_cast<assessment::Region>(region)))
                             .arg(counts[hour][region]);
    return lines.isEmpty() ? Pictures::tr("No damage was recorded.") : lines.join("; ");
}

/// Pictures beside each other, as many as have room, the rest below.
class Shelf : public QWidget {
 public:
    explicit Shelf(int least) : least_(least), grid_(new QGridLayout(this)) {
        grid_->setContentsMargins(0, 0, 0, 0);
        grid_->setSpacing(kSpace16);
    }
    void add(QWidget* picture) {
        pictures_.push_back(picture);
        arrange(static_cast<int>(pictures_.size()));
    }
    [[nodiscard]] QSize minimumSizeHint() const override {
        return {least_, grid_->minimumSize().height()};
    }

 protected:
    void resizeEvent(QResizeEvent*) override {
        const int most = static_cast<int>(pictures_.size());
        const int columns = std::clamp((width() + kSpace16) / (least_ + kSpace16), 1, most);
        if (columns != columns_) arrange(columns);
    }

 private:
    void arrange(int columns) {
        columns_ = columns;
        for (QWidget* each : pictures_) grid_->removeWidget(each);
        for (int i = 0; i < static_cast<int>(pictures_.size()); ++i) {
            grid_->addWidget(pictures_[static_cast<size_t>(i)], i / columns, i % columns);
            grid_->setColumnStretch(i, i < columns ? 1 : 0);
        }
        updateGeometry();
    }
    int least_, columns_ = 0;
    QGridLayout* grid_;
    std::vector<QWidget*> pictures_;
};

constexpr int kLeastMap = 280, kLeastWay = 260, kLeastLeak = 420;

}  // namespace

namespace {

using Draw = std::function<void(QPainter&, const QRectF&)>;

void add_map(Shelf* shelf, const QString& name, const QString& words, const char* object,
             const Draw& draw) {
    auto* titled = new QWidget;
    auto* column = new QVBoxLayout(titled);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSpace4);
    QWidget* picture = make_picture(draw, QSize(kLeastMap, 320), name, words);
    picture->setObjectName(object);
    picture->setMaximumHeight(380);
    QLabel* title = make_label(name, "muted");
    title->setAlignment(Qt::AlignHCenter);
    column->addWidget(title);
    column->addWidget(picture, 1);
    shelf->add(titled);
}

/// What an exercise asked for; nothing where it asked for no place and no line.
void add_asked(Shelf* shelf, const std::shared_ptr<const sim::Recording>& recording,
               const reports::ChartStyle& style) {
    const reports::AskedPlaces asked = reports::asked_places(*recording);
    if (!asked.any()) return;
    const QString words =
        asked.places.empty()
            ? Pictures::tr("The planned line; green where the tip followed it within 1 mm.")
            : Pictures::tr("Places done: %1 of %2. Touches beside them: %3.")
                  .arg(asked.done())
                  .arg(asked.places.size())
                  .arg(asked.missed.size());
    add_map(shelf,
            asked.places.empty() ? Pictures::tr("The line to follow")
                                 : Pictures::tr("The places of the task"),
            words, "asked_map", [recording, asked, style](QPainter& painter, const QRectF& where) {
                reports::draw_asked(painter, where, recording->header.geometry, asked, style);
            });
}

}  // namespace

QWidget* make_map_card(AppContext& context,
                       const std::shared_ptr<const sim::Recording>& recording) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(Pictures::tr("Where it happened"), "heading"));
    const reports::TaskScope scope = reports::scope_of(recording->header);
    reports::ChartStyle style = chart_style(context.theme());
    style.plan = scope.line;
    auto entries = std::make_shared<std::vector<assessment::LedgerEntry>>(
        assessment::damage_ledger(recording->events, recording->header.geometry));
    auto* shelf = new Shelf(kLeastMap);
    if (!scope.ring) add_asked(shelf, recording, style);
    add_map(shelf, Pictures::tr("Damage"), map_words(*entries), "damage_map",
            [recording, entries, style](QPainter& painter, const QRectF& where) {
                reports::draw_field_map(painter, where, *recording, *entries,
                                        reports::FieldLayer::kDamage, style);
            });
    if (scope.energy)
        add_map(shelf, Pictures::tr("Energy in tissue"),
                Pictures::tr("Where the needle delivered energy, in joules per square millimetre."),
                "energy_map", [recording, entries, style](QPainter& painter, const QRectF& where) {
                    reports::draw_field_map(painter, where, *recording, *entries,
                                            reports::FieldLayer::kEnergy, style);
                });
    if (scope.ring)
        add_map(shelf, Pictures::tr("The incision"),
                Pictures::tr("The field from above: planned contour, what was cut, the needle's "
                             "path. The measures say the same in numbers."),
                "incision", [recording, style](QPainter& painter, const QRectF& where) {
                    reports::draw_incision(painter, where, *recording, style);
                });
    layout->addWidget(shelf);
    return make_card(layout);
}

QWidget* make_leak_card(AppContext& context,
                        const std::shared_ptr<const sim::Recording>& recording) {
    const std::optional<assessment::LeakMap> map = assessment::leak_map(*recording);
    if (!map && !reports::looks_at_leak(reports::scope_of(recording->header).scored))
        return nullptr;
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace8);
    const QString name = reports::figure_word("Where it leaks");
    layout->addWidget(make_label(name, "heading"));
    const QString words = map ? reports::leak_words(*map) : reports::no_leak_map_words();
    if (map) {
        const reports::ChartStyle style = chart_style(context.theme());
        const int height = static_cast<int>(std::ceil(reports::leak_height(style)));
        QWidget* picture = make_picture(
            [map = *map, style](QPainter& painter, const QRectF& where) {
                reports::draw_leak(painter, where, map, style);
            },
            QSize(kLeastLeak, height), name, words);
        picture->setObjectName("leak_map");
        picture->setMaximumHeight(height);
        layout->addWidget(picture);
    }
    QLabel* said = make_label(words, map ? "body" : "muted");
    said->setObjectName("leak_words");
    layout->addWidget(said);
    return make_card(layout);
}

QWidget* make_ways_card(AppContext& context,
                        const std::shared_ptr<const sim::Recording>& recording) {
    auto* layout = new QVBoxLayout;
    layout->setSpacing(kSpace12);
    layout->addWidget(make_label(Pictures::tr("Paths of the instruments"), "heading"));
    const reports::TaskScope scope = reports::scope_of(recording->header);
    reports::ChartStyle style = chart_style(context.theme());
    style.plan = scope.line;
    auto* shelf = new Shelf(kLeastWay);
    const QString names[]{Pictures::tr("Ways from above"), Pictures::tr("Ways from the left side"),
                          Pictures::tr("Ways from the feet")};
    for (int i = 0; i < 3; ++i) {
        QWidget* picture = make_picture(
            [recording, style, i](QPainter& painter, const QRectF& where) {
                reports::draw_trajectory(painter, where, *recording, static_cast<reports::Side>(i),
                                         style);
            },
            QSize(kLeastWay, 270), names[i],
            Pictures::tr("Path length and time stand among the measures."));
        picture->setObjectName(QString("way_%1").arg(i));
        picture->setMaximumHeight(330);
        shelf->add(picture);
    }
    layout->addWidget(shelf);
    QStringList key;
    if (scope.energy) key << Pictures::tr("Thick where energy flowed into tissue.");
    if (scope.line) key << Pictures::tr("Dashed line: the plan.");
    if (!key.isEmpty()) layout->addWidget(make_label(key.join(' '), "small"));
    return make_card(layout);
}

}  // namespace placode::ui
