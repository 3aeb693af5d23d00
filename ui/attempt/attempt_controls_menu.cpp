// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
// The menu and the questions of an attempt: how one moves in them, and what they ask.

#include <algorithm>
#include <cmath>

#include "ui/attempt/attempt_controls.h"
#include "ui/view/strings.h"

namespace placode::ui {

namespace {

using curriculum::AttemptMode;
using sim::EndReason;
using sim::Key;
using sim::PauseCause;
using view::WindowEvent;
using Kind = view::WindowEvent::Kind;

constexpr double kMeantPx = 4;  // a pointer that moved less still rests

std::string with(std::string text, const std::string& first, const std::string& second = {}) {
    for (const auto& [mark, value] : {std::pair{"%1", first}, std::pair{"%2", second}}) {
        const size_t found = text.find(mark);
        if (found != std::string::npos) text.replace(found, 2, value);
    }
    return text;
}

}  // namespace

std::string AttemptControls::say(const std::string& english) const {
    return view::translated(english, setup_.language);
}

bool AttemptControls::too_short() const { return attempt_s_ < setup_.least_s; }
bool AttemptControls::early() const {
    return attempt_s_ < curriculum::kEarlyShare * setup_.usual_s;
}

void AttemptControls::menu_key(const WindowEvent& event) {
    const int items = static_cast<int>(menu_.items.size());
    if (event.kind == Kind::kStart) return show(Screen::kOperate, cause_);
    if (event.kind == Kind::kButton && event.down && event.button == 0) {
        // Not where the pointer happens to lie when the menu comes up under it.
        if (anchor_ && pointer_.menu_item >= 0 &&
            std::hypot(pointer_.x - anchor_->x, pointer_.y - anchor_->y) > kMeantPx) {
            menu_.selected = std::min(pointer_.menu_item, items - 1);
            choose();
        }
        return;
    }
    if (event.kind != Kind::kKey || !event.down) return;
    if (event.key == Key::kF1 || event.key == Key::kF2) return refuse(event.key);
    if (event.key == Key::kUp) menu_.selected = (menu_.selected + items - 1) % items;
    if (event.key == Key::kDown) menu_.selected = (menu_.selected + 1) % items;
    if (event.key == Key::kEscape) return show(Screen::kOperate, cause_);
    if (event.key == Key::kEnter) choose();
}

/// What this mode does not have is refused in the menu with the words of the attempt, once.
void AttemptControls::refuse(Key key) {
    const char* why = key == Key::kF2 ? no_tuning() : no_help();
    if (why == nullptr) return;
    const std::string line = say(why);
    if (std::find(menu_.lines.begin(), menu_.lines.end(), line) == menu_.lines.end())
        menu_.lines.push_back(line);
}

const char* AttemptControls::no_tuning() const {
    if (conduct_.tuning) return nullptr;
    return setup_.mode == AttemptMode::kExam ? "No tuning in an exam" : "No tuning in a study";
}

const char* AttemptControls::no_help() const {
    return conduct_.help ? nullptr : "No help in an exam";
}

void AttemptControls::choose() {
    const int item = menu_.selected;
    if (item == 0) return show(Screen::kOperate, cause_);
    if (screen_ == Screen::kMenu)
        return item == 1 ? finish_or_ask() : ask(Question::kLeave, PauseCause::kMenu);
    const bool leaves = question_ == Question::kLeave || item == 2;
    end_ = leaves ? EndReason::kInterrupted : EndReason::kFinished;
}

/// The menu was gone through or Enter held for it: one more question only where an end by mistake
/// costs much.
void AttemptControls::finish_or_ask() {
    if (conduct_.always_ask || early() || too_short()) return ask(Question::kFinish, cause_);
    end_ = EndReason::kFinished;
}

void AttemptControls::hover(const Pointer& pointer) {
    const bool open = screen_ == Screen::kMenu || screen_ == Screen::kQuestion;
    if (open && !anchor_) anchor_ = pointer;
    if (!open) anchor_.reset();
    // Keys and pointer share the selection: it follows the pointer only when that moves.
    const bool moved = std::hypot(pointer.x - pointer_.x, pointer.y - pointer_.y) > 0;
    const bool meant =
        anchor_ && std::hypot(pointer.x - anchor_->x, pointer.y - anchor_->y) > kMeantPx;
    pointer_ = pointer;
    if (open && moved && meant && pointer.menu_item >= 0)
        menu_.selected = std::min(pointer.menu_item, static_cast<int>(menu_.items.size()) - 1);
}

void AttemptControls::open_menu(const char* title, PauseCause cause) {
    show(Screen::kMenu, cause);
    anchor_.reset();
    menu_.title = say(title);
    menu_.lines.clear();
    menu_.items = {say("Continue"), say("Finish and score"), say("Leave without finishing")};
    if (!conduct_.own_score) menu_.items[1] = say("Finish");
    // What leaving costs is said where it is chosen, not only in the question after it.
    if (attempt_s_ > 0 && setup_.mode == AttemptMode::kExam)
        menu_.items[2] = say("Leave: uses up an attempt");
    if (attempt_s_ > 0 && setup_.mode == AttemptMode::kStudy)
        menu_.items[2] = say("Leave: has to be done again");
    menu_.selected = 0;
}

void AttemptControls::ask(Question question, PauseCause cause) {
    show(Screen::kQuestion, cause);
    anchor_.reset();
    question_ = question;
    const std::string finish = say(conduct_.own_score ? "Finish and score" : "Finish");
    const std::string leave = say("Leave without finishing");
    menu_.lines = warnings(question);
    menu_.selected = 0;
    switch (question) {
        case Question::kFinish:
            menu_.title = say("Finish the attempt?");
            menu_.items = {say("Go on operating"), finish};
            break;
        case Question::kLeave:
            menu_.title = say("Leave the attempt?");
            menu_.items = {say("Go on operating"), leave};
            break;
        case Question::kClose:
            menu_.title = say("Close the window?");
            menu_.items = {say("Go on operating"), finish, leave};
            break;
    }
}

/// What is lost when the attempt ends now.
std::vector<std::string> AttemptControls::warnings(Question question) const {
    std::vector<std::string> lines;
    if (question != Question::kLeave && too_short())
        lines.push_back(
            with(say("The study asks for at least %1. Ended after %2 it does not count."),
                 view::clock_text(setup_.least_s), view::clock_text(attempt_s_)));
    else if (question != Question::kLeave && early())
        lines.push_back(with(say("Only %2 have passed; it usually takes %1."),
                             view::clock_text(setup_.usual_s), view::clock_text(attempt_s_)));
    const bool exam = setup_.mode == AttemptMode::kExam;
    if (exam && question == Question::kFinish)
        lines.push_back(say("This is an exam: an end is final."));
    // Before the first motion nothing is recorded and nothing is used up.
    const bool begun = attempt_s_ > 0;
    if (exam && question != Question::kFinish)
        lines.push_back(say(begun ? "This is an exam: leaving uses up this attempt."
                                  : "The exam has not begun yet: leaving uses up nothing."));
    const bool study = setup_.mode == AttemptMode::kStudy;
    if (study && question != Question::kLeave && !too_short())
        lines.push_back(say("This procedure then is over for good."));
    if (study && (question != Question::kFinish || too_short()))
        lines.push_back(say("A procedure that is broken off has to be done again from the start."));
    if (!study && !exam && question != Question::kFinish)
        lines.push_back(
            say(begun ? "An attempt that is left is kept as interrupted and counts for nothing."
                      : "The attempt has not begun yet: nothing is kept."));
    return lines;
}

}  // namespace placode::ui
