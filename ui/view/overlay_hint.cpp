// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The hint for somebody who is stuck: the key or button itself, drawn, moving calmly, with the
// words below. It stands where nothing else does and moves nothing.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "ui/view/overlay.h"
#include "ui/view/overlay_shapes.h"
#include "ui/view/overlay_style.h"
#include "ui/view/practice_hint.h"

namespace placode::view {

using namespace sim;

using namespace style;

namespace {

constexpr double kCycleS = 1.8;  // of one symbol
constexpr double kGap = 1.3;     // between two of them
constexpr Colour kBody{0.20F, 0.22F, 0.25F, 1}, kBodyEdge{0.60F, 0.64F, 0.68F, 1};

/// Draws the symbols of a hint in a row.
class SymbolPainter {
 public:
    SymbolPainter(TextPainter& paint, double unit) : paint_(paint), u_(unit) {}

    [[nodiscard]] double width(const std::vector<HintSymbol>& symbols) const {
        double sum = 0;
        for (const HintSymbol& symbol : symbols) sum += width(symbol);
        return sum + kGap * u_ * static_cast<double>(symbols.size() - 1);
    }
    /// All of them, one after the other; what is held goes on until the next one is done. A clock
    /// below 0: everything stands still, as it is when it is done.
    void draw_row(const std::vector<HintSymbol>& symbols, Vec2 at, double clock_s) {
        const double turn = std::fmod(clock_s / kCycleS, static_cast<double>(symbols.size()));
        for (size_t i = 0; i < symbols.size(); ++i) {
            const HintSymbol& symbol = symbols[i];
            const bool more = i + 1 < symbols.size();
            const double first = static_cast<double>(i), lasts = more && symbol.together ? 2 : 1;
            double act = clock_s < 0 ? 1 : 0, wave = 0;
            if (clock_s >= 0 && turn >= first && turn < first + lasts) {
                const double share = (turn - first) / lasts;
                act = std::clamp(std::min(share, 1 - share) * 6, 0.0, 1.0);
                wave = std::sin(4 * std::numbers::pi * share);
            }
            const double cell = width(symbol);
            draw(symbol, at + Vec2(0.5 * cell, 0), act, wave);
            at.x() += cell;
            if (more)
                paint_.text(at.x() + 0.5 * kGap * u_, at.y() + 0.3 * u_,
                            symbol.together ? "+" : "\xE2\x86\x92", TextSize::kNormal, kMuted,
                            Align::kCentre);
            at.x() += kGap * u_;
        }
    }

 private:
    /// In a square cell around a centre; `act` runs 0 .. 1 .. 0 while it is its turn.
    void draw(const HintSymbol& symbol, const Vec2& centre, double act, double wave) {
        // Where something is let go of, it starts pressed.
        press_ = symbol.act == HintAct::kRelease ? 1 - act : act;
        wave_ = wave * act;
        switch (symbol.thing) {
            case HintThing::kKey:
                key(symbol, centre);
                break;
            case HintThing::kStick:
                stick(symbol, centre);
                break;
            case HintThing::kCap:
                cap(symbol, centre);
                break;
            case HintThing::kHandle:
                handle(symbol, centre);
                break;
            case HintThing::kYellowPedal:
            case HintThing::kBluePedal:
                pedal(centre, symbol.thing == HintThing::kYellowPedal ? kYellow : kBlue);
                break;
            default:
                mouse(symbol, centre);
                break;
        }
    }
    [[nodiscard]] double width(const HintSymbol& symbol) const {
        if (symbol.thing != HintThing::kKey) return 5.4 * u_;
        return std::max(2.6 * u_, paint_.text_width(symbol.name, TextSize::kNormal) + 1.6 * u_) +
               0.3 * u_;
    }
    [[nodiscard]] static Colour mixed(const Colour& a, const Colour& b, double share) {
        const auto s = static_cast<float>(std::clamp(share, 0.0, 1.0));
        return {a.r + s * (b.r - a.r), a.g + s * (b.g - a.g), a.b + s * (b.b - a.b), 1};
    }

    void plate(const Vec2& c, double w, double h, double r, const Colour& fill) {
        const double edge = 0.12 * u_;
        shapes::rounded(paint_, c.x() - 0.5 * w - edge, c.y() - 0.5 * h - edge, w + 2 * edge,
                        h + 2 * edge, r + edge, kBodyEdge);
        shapes::rounded(paint_, c.x() - 0.5 * w, c.y() - 0.5 * h, w, h, r, fill);
    }

    void key(const HintSymbol& symbol, const Vec2& centre) {
        const double w = width(symbol) - 0.6 * u_, h = 2.3 * u_, sink = 0.28 * u_ * press_;
        shapes::rounded(paint_, centre.x() - 0.5 * w - 0.1 * u_, centre.y() - 0.5 * h + 0.2 * u_,
                        w + 0.2 * u_, h + 0.35 * u_, 0.5 * u_, kInk);
        const Vec2 top = centre + Vec2(0, sink - 0.1 * u_);
        plate(top, w, h, 0.4 * u_, mixed(kBody, kAccent, press_));
        paint_.text(top.x(), top.y() + 0.36 * u_, symbol.name, TextSize::kNormal,
                    press_ > 0.5 ? kInk : kText, Align::kCentre);
    }

    void mouse(const HintSymbol& symbol, const Vec2& centre) {
        const bool moves = symbol.act == HintAct::kSideways;
        const Vec2 c = centre + Vec2(moves ? 0.5 * u_ * wave_ : 0, 0);
        const double w = 2.6 * u_, h = 4.0 * u_, r = 1.3 * u_, split = c.y() - 0.45 * u_;
        plate(c, w, h, r, kBody);
        const Colour lit = mixed(kBody, kAccent, press_);
        const double left = c.x() - 0.5 * w, top = c.y() - 0.5 * h;
        const auto button = [&](bool right) {
            const double x = right ? c.x() : left;
            const Vec2 bend(right ? left + w - r : left + r, top + r);
            shapes::wedge(paint_, bend, r, right ? 0 : -0.5 * std::numbers::pi,
                          right ? 0.5 * std::numbers::pi : 0, lit);
            paint_.box(x, top + r, 0.5 * w, split - top - r, lit);
        };
        if (symbol.thing == HintThing::kMouseLeft) button(false);
        if (symbol.thing == HintThing::kMouseRight) button(true);
        paint_.box(c.x() - 0.5, top, 1.2, split - top, kBodyEdge);
        paint_.box(left, split, w, 1.2, kBodyEdge);
        const bool wheel = symbol.thing == HintThing::kMouseWheel,
                   middle = symbol.thing == HintThing::kMouseMiddle;
        shapes::rounded(paint_, c.x() - 0.34 * u_, top + 0.45 * u_, 0.68 * u_, 1.15 * u_, 0.34 * u_,
                        kBodyEdge);
        shapes::rounded(paint_, c.x() - 0.24 * u_, top + 0.55 * u_, 0.48 * u_, 0.95 * u_, 0.24 * u_,
                        wheel || middle ? mixed(kBody, kAccent, press_) : kBody);
        if (wheel) arrows(Vec2(c.x() + 0.5 * w + 0.55 * u_, c.y() - 0.4 * u_), symbol.act);
        if (moves)
            for (const double side : {-1.0, 1.0})
                shapes::chevron(paint_, centre + Vec2(side * 2.6 * u_, 0.4 * u_), Vec2(side, 0),
                                0.45 * u_, 0.16 * u_, kAccent);
    }

    /// In is away from the user (up), out towards the user.
    void arrows(const Vec2& at, HintAct act) {
        const double slide = 0.35 * u_ * press_;
        if (act != HintAct::kOut)
            shapes::arrow(paint_, at + Vec2(0, -0.1 * u_ - slide), at + Vec2(0, -1.5 * u_ - slide),
                          0.45 * u_, 0.16 * u_, kAccent);
        if (act != HintAct::kIn)
            shapes::arrow(paint_, at + Vec2(0, 0.3 * u_ + slide), at + Vec2(0, 1.7 * u_ + slide),
                          0.45 * u_, 0.16 * u_, kAccent);
    }

    void stick(const HintSymbol& symbol, const Vec2& c) {
        paint_.ring(c.x(), c.y(), 1.9 * u_, 0.90, kBodyEdge);
        const Vec2 top = c + Vec2(0.8 * u_ * wave_, 0);
        paint_.ring(top.x(), top.y(), 1.15 * u_, 0, kBodyEdge);
        paint_.ring(top.x(), top.y(), 1.02 * u_, 0, mixed(kBody, kAccent, 0.7 * press_));
        paint_.text(top.x(), top.y() + 0.36 * u_, symbol.name, TextSize::kNormal, kText,
                    Align::kCentre);
    }

    void cap(const HintSymbol& symbol, const Vec2& c) {
        Vec2 at = c;
        if (symbol.act == HintAct::kSideways) at.x() += 0.6 * u_ * wave_;
        plate(c + Vec2(0, 1.35 * u_), 3.4 * u_, 0.7 * u_, 0.35 * u_, kBody);
        plate(at + Vec2(0, -0.1 * u_), 2.5 * u_, 1.9 * u_, 0.5 * u_,
              mixed(kBody, kAccent, 0.7 * press_));
        direction_arrows(c + Vec2(2.0 * u_, 0), symbol.act, c);
    }

    void handle(const HintSymbol& symbol, const Vec2& c) {
        // A pen seen from the side, leaning as it is held.
        const Vec2 along = Vec2(0.5, -1).normalized();
        Vec2 at = c;
        if (symbol.act == HintAct::kSideways) at.x() += 0.7 * u_ * wave_;
        if (symbol.act == HintAct::kIn) at -= 0.6 * u_ * press_ * along;
        if (symbol.act == HintAct::kOut) at += 0.6 * u_ * press_ * along;
        if (symbol.act == HintAct::kInOut) at += 0.6 * u_ * wave_ * along;
        shapes::stroke(paint_, at - 1.9 * u_ * along, at + 1.9 * u_ * along, 0.9 * u_, kBodyEdge);
        shapes::stroke(paint_, at - 1.75 * u_ * along, at + 1.75 * u_ * along, 0.64 * u_,
                       mixed(kBody, kAccent, 0.7 * press_));
        shapes::stroke(paint_, at - 2.5 * u_ * along, at - 1.9 * u_ * along, 0.3 * u_, kBodyEdge);
        direction_arrows(c + Vec2(1.9 * u_, 0), symbol.act, c);
    }

    void direction_arrows(const Vec2& at, HintAct act, const Vec2& c) {
        if (act == HintAct::kSideways) {
            for (const double side : {-1.0, 1.0})
                shapes::chevron(paint_, c + Vec2(side * 2.6 * u_, 0.9 * u_), Vec2(side, 0),
                                0.45 * u_, 0.16 * u_, kAccent);
        } else if (act == HintAct::kTurn) {
            const double turn = 1.2 + 0.5 * wave_;
            shapes::arc(paint_, c - Vec2(0, 1.2 * u_), 1.7 * u_, 0.16 * u_, -1.1, turn, kAccent);
            shapes::chevron(
                paint_, c - Vec2(0, 1.2 * u_) + 1.7 * u_ * Vec2(std::sin(turn), -std::cos(turn)),
                Vec2(std::cos(turn), std::sin(turn)), 0.45 * u_, 0.16 * u_, kAccent);
        } else if (act != HintAct::kPress && act != HintAct::kRelease) {
            arrows(at, act);
        }
    }

    void pedal(const Vec2& c, const Colour& colour) {
        const double lift = 0.9 * u_ * (1 - press_);
        paint_.box(c.x() - 1.9 * u_, c.y() + 1.0 * u_, 3.8 * u_, 0.35 * u_, kBodyEdge);
        paint_.quad({c + Vec2(-1.8 * u_, 0.85 * u_), c + Vec2(1.8 * u_, 0.85 * u_ - lift),
                     c + Vec2(1.8 * u_, 0.25 * u_ - lift), c + Vec2(-1.8 * u_, 0.25 * u_)},
                    mixed(kBody, colour, 0.45 + 0.55 * press_));
    }

    TextPainter& paint_;
    double u_, press_ = 0, wave_ = 0;
};

}  // namespace

void Overlay::hint() {
    if (!practising() || state_->menu.shown || state_->show_help || state_->exam) return;
    if (!state_->heading.empty()) return;  // a replay
    const bool wrong = wrong_hand();
    if (!watch_.stuck() && !wrong) return;
    if (state_->tuning.shown) return;  // it stands where the panel does
    const PracticeOverlay& practice = state_->practice;
    const auto now = static_cast<size_t>(practice.goal.index);
    if (now >= practice.steps.size()) return;
    const PracticeOverlay::Step& step = practice.steps[now];
    // Of a step for the other hand the keys begin with the change; done, it is not asked for again.
    const bool change = practice.in_hand < 0 ? step.changes_hand : wrong;
    std::vector<HintSymbol> symbols =
        hint_symbols(practice.goal.step, practice.device, change, state_->layout);
    if (wrong && !step.changes_hand && !symbols.empty()) symbols.resize(1);
    if (symbols.empty()) return;
    const double room = 0.5 * width_ - circle_.radius - 2 * margin_;
    const bool wide = room > 9 * unit_;
    // As large as the place allows. In a narrow window the words stand in the line at the foot.
    double u = 1.15 * unit_;
    const double most = wide ? room - 0.8 * unit_ : 0.9 * width_;
    u = std::min(u, u * most / SymbolPainter(*paint_, u).width(symbols));
    const std::vector<std::string> lines =
        wide ? paint_->wrapped(hint_text(), TextSize::kSmall, room - 0.8 * unit_)
             : std::vector<std::string>{};
    const double line = paint_->line_height(TextSize::kSmall);
    SymbolPainter painter(*paint_, u);
    const double row = painter.width(symbols);
    const double w = wide ? room + 0.4 * unit_ : row + 1.2 * unit_;
    const double h = 5.4 * u + (lines.empty() ? 0 : 0.6 * unit_) +
                     line * static_cast<double>(lines.size()) + 0.6 * unit_;
    // In a narrow window in the corner, where least of the picture is.
    const double x = width_ - margin_ - w;
    const double y = wide ? 0.5 * (height_ - h) : foot_top_ - h - 0.4 * unit_;
    hint_box_ = {x, y, w, h};
    paint_->box(x, y, w, h, kRaised);
    paint_->box(x, y, w, 0.2 * unit_, kAccent);
    painter.draw_row(symbols, Vec2(x + 0.5 * (w - row), y + 2.9 * u),
                     state_->motion ? tips_->clock_s : -1);
    double text = y + 5.4 * u + 1.0 * unit_;
    for (const std::string& words : lines) {
        paint_->text(x + 0.5 * w, text, words, TextSize::kSmall, kText, Align::kCentre);
        text += line;
    }
}

}  // namespace placode::view
