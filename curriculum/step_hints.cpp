// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "curriculum/step_hints.h"

#include "haptics/hint_device.h"

#include <array>

namespace placode::curriculum {

namespace {

using haptics::HintDevice;
using sim::PracticeKind;

struct Words {
    const char *en = "", *pl = "";
};
/// Mouse, keyboard, gamepad, SpaceMouse, arm.
using ByDevice = std::array<Words, 5>;

// In the order of PracticeKind.
constexpr std::array<ByDevice, sim::kPracticeKinds> kHints{{
    // kMove
    {{{"Move the mouse. Ctrl makes it precise, Space holds the instrument still.",
       "Ruszaj myszą. Ctrl: precyzyjnie, Spacja: narzędzie stoi."},
      {"W A S D. Ctrl makes it precise.", "W A S D. Ctrl: precyzyjnie."},
      {"Left stick. The left bumper makes it precise.",
       "Lewa gałka. Lewy przycisk górny: precyzyjnie."},
      {"Push the cap sideways, up and down.", "Popychaj gałkę na boki, w górę i w dół."},
      {"Move the handle sideways. The tip goes the other way, as through a port.",
       "Poruszaj uchwytem na boki. Końcówka idzie w przeciwną stronę, jak przez port."}}},
    // kDepth
    {{{"Turn the wheel: away from you is deeper. Shift makes it quicker.",
       "Kręć kółkiem: od siebie to głębiej. Shift: szybciej."},
      {"F goes deeper, R back.", "F głębiej, R z powrotem."},
      {"Right trigger goes deeper, left trigger back.", "Prawy spust głębiej, lewy z powrotem."},
      {"Push the cap away from you to go deeper, pull it to come back.",
       "Popchnij gałkę od siebie, by wejść głębiej, pociągnij, by wrócić."},
      {"Push the handle in to go deeper, draw it out to come back.",
       "Wsuń uchwyt, by wejść głębiej, wysuń, by wrócić."}}},
    // kTurn
    {{{"Hold Shift and move the mouse sideways.", "Przytrzymaj Shift i ruszaj myszą na boki."},
      {"Q and E turn.", "Q i E obracają."},
      {"Right stick, sideways.", "Prawa gałka, na boki."},
      {"Twist the cap.", "Przekręcaj gałkę."},
      {"Turn the handle about its axis.", "Obracaj uchwyt wokół osi."}}},
    // kTouch
    {{{"Go above the ring, then down with the wheel, notch by notch. Ctrl makes notches small.",
       "Ustaw się nad pierścieniem, potem w dół kółkiem, ząbek po ząbku. Ctrl: małe ząbki."},
      {"Go above the ring, then F with Ctrl.", "Ustaw się nad pierścieniem, potem F z Ctrl."},
      {"Go above the ring, then the right trigger with the left bumper.",
       "Ustaw się nad pierścieniem, potem prawy spust z lewym przyciskiem górnym."},
      {"Go above the ring, then push the cap gently away from you.",
       "Ustaw się nad pierścieniem, potem delikatnie popchnij gałkę od siebie."},
      {"Go above the ring, then push the handle in until the tip touches.",
       "Ustaw się nad pierścieniem, potem wsuwaj uchwyt, aż końcówka dotknie."}}},
    // kCut
    {{{"Touch the ring's middle, then hold the left button: yellow pedal, cut.",
       "Dotknij środka pierścienia, potem przytrzymaj lewy przycisk: żółty pedał, cięcie."},
      {"Touch the ring's middle, then hold X: yellow pedal, cut.",
       "Dotknij środka pierścienia, potem przytrzymaj X: żółty pedał, cięcie."},
      {"Touch the ring's middle, then hold A: yellow pedal, cut.",
       "Dotknij środka pierścienia, potem przytrzymaj A: żółty pedał, cięcie."},
      {"Touch the ring's middle, then hold the left button or the yellow pedal: cut.",
       "Dotknij środka pierścienia, potem przytrzymaj lewy przycisk lub żółty pedał: cięcie."},
      {"Touch the ring's middle, then press the yellow pedal: cut.",
       "Dotknij środka pierścienia, potem naciśnij żółty pedał: cięcie."}}},
    // kCoag
    {{{"Touch the ring's middle, then hold the right button: blue pedal, coagulation.",
       "Dotknij środka pierścienia, potem przytrzymaj prawy przycisk: niebieski pedał, "
       "koagulacja."},
      {"Touch the ring's middle, then hold C: blue pedal, coagulation.",
       "Dotknij środka pierścienia, potem przytrzymaj C: niebieski pedał, koagulacja."},
      {"Touch the ring's middle, then hold B: blue pedal, coagulation.",
       "Dotknij środka pierścienia, potem przytrzymaj B: niebieski pedał, koagulacja."},
      {"Touch the ring's middle, then hold the right button or the blue pedal: coagulation.",
       "Dotknij środka pierścienia, potem przytrzymaj prawy przycisk lub niebieski pedał: "
       "koagulacja."},
      {"Touch the ring's middle, then press the blue pedal: coagulation.",
       "Dotknij środka pierścienia, potem naciśnij niebieski pedał: koagulacja."}}},
    // kGrasp
    {{{"Down until it touches, then hold the left button: the jaws close.",
       "W dół, aż dotknie, potem przytrzymaj lewy przycisk: szczęki się zamkną."},
      {"Down until it touches, then hold X: the jaws close.",
       "W dół, aż dotknie, potem przytrzymaj X: szczęki się zamkną."},
      {"Down until it touches, then hold A: the jaws close.",
       "W dół, aż dotknie, potem przytrzymaj A: szczęki się zamkną."},
      {"Down until it touches, then hold the left button: the jaws close.",
       "W dół, aż dotknie, potem przytrzymaj lewy przycisk: szczęki się zamkną."},
      {"Push in until it touches, then close the handle or hold its first button.",
       "Wsuń, aż dotknie, potem zamknij uchwyt lub przytrzymaj jego pierwszy przycisk."}}},
    // kRelease
    {{{"Let go of the left button.", "Puść lewy przycisk."},
      {"Let go of X.", "Puść X."},
      {"Let go of A.", "Puść A."},
      {"Let go of the left button.", "Puść lewy przycisk."},
      {"Open the handle, or let go of its button.", "Otwórz uchwyt lub puść jego przycisk."}}},
    // kTrace
    {{{"Down with the wheel until the tip nearly touches, then follow the line with the mouse.",
       "Kółkiem w dół, aż końcówka prawie dotknie, potem prowadź ją myszą wzdłuż linii."},
      {"F until the tip nearly touches, then W A S D with Ctrl along the line.",
       "F, aż końcówka prawie dotknie, potem W A S D z Ctrl wzdłuż linii."},
      {"Right trigger until the tip nearly touches, then the left stick along the line.",
       "Prawy spust, aż końcówka prawie dotknie, potem lewa gałka wzdłuż linii."},
      {"Push the cap away from you until the tip nearly touches, then sideways along the line.",
       "Popchnij gałkę od siebie, aż końcówka prawie dotknie, potem na boki wzdłuż linii."},
      {"Push the handle in until the tip nearly touches, then follow the line.",
       "Wsuń uchwyt, aż końcówka prawie dotknie, potem prowadź ją wzdłuż linii."}}},
    // kTraction
    {{{"Hold the left button to grasp, Tab keeps it held; grasp with the other hand, then pull "
       "gently.",
       "Przytrzymaj lewy przycisk, by chwycić, Tab zostawia chwyt; chwyć drugą ręką i delikatnie "
       "ciągnij."},
      {"Hold X to grasp, Tab keeps it held; grasp with the other hand, then pull gently with "
       "Ctrl.",
       "Przytrzymaj X, by chwycić, Tab zostawia chwyt; chwyć drugą ręką i delikatnie ciągnij z "
       "Ctrl."},
      {"Hold A to grasp, Tab on the keyboard keeps it held; grasp with the other hand, then pull "
       "gently.",
       "Przytrzymaj A, by chwycić, Tab na klawiaturze zostawia chwyt; chwyć drugą ręką i "
       "delikatnie ciągnij."},
      {"Hold the left button to grasp, Tab on the keyboard keeps it held; grasp with the other "
       "hand, then pull gently.",
       "Przytrzymaj lewy przycisk, by chwycić, Tab na klawiaturze zostawia chwyt; chwyć drugą "
       "ręką i delikatnie ciągnij."},
      {"Grasp with both hands, then pull gently until both bars stand in the green band.",
       "Chwyć obiema rękami, potem delikatnie ciągnij, aż oba paski staną w zielonym polu."}}},
    // kWithdraw
    {{{"Wheel towards you.", "Kółko do siebie."},
      {"R draws back.", "R cofa."},
      {"Left trigger draws back.", "Lewy spust cofa."},
      {"Pull the cap towards you.", "Pociągnij gałkę do siebie."},
      {"Draw the handle out.", "Wysuń uchwyt."}}},
    // kNeedleIn
    {{{"Mouse and wheel bring the point over the mark; Shift and mouse sideways turn it in.",
       "Mysz i kółko ustawiają ostrze nad znakiem; Shift i mysz na boki wkłuwają je obrotem."},
      {"W A S D, F and R bring the point over the mark; Q and E turn it in.",
       "W A S D, F i R ustawiają ostrze nad znakiem; Q i E wkłuwają je obrotem."},
      {"Left stick and triggers bring the point over the mark; the right stick turns it in.",
       "Lewa gałka i spusty ustawiają ostrze nad znakiem; prawa gałka wkłuwa je obrotem."},
      {"Push the cap until the point stands over the mark; twist it to turn the needle in.",
       "Popychaj gałkę, aż ostrze stanie nad znakiem; skręć ją, by wkłuć igłę obrotem."},
      {"Bring the point over the mark, then turn the handle about its axis.",
       "Ustaw ostrze nad znakiem, potem obracaj uchwyt wokół osi."}}},
    // kNeedleOut
    {{{"Go on turning with Shift and the mouse until the point comes out.",
       "Obracaj dalej z Shift i myszą, aż ostrze wyjdzie."},
      {"Go on turning with Q or E until the point comes out.",
       "Obracaj dalej klawiszem Q lub E, aż ostrze wyjdzie."},
      {"Go on turning with the right stick until the point comes out.",
       "Obracaj dalej prawą gałką, aż ostrze wyjdzie."},
      {"Go on twisting the cap until the point comes out.",
       "Skręcaj dalej gałkę, aż ostrze wyjdzie."},
      {"Go on turning the handle until the point comes out.",
       "Obracaj dalej uchwyt, aż ostrze wyjdzie."}}},
    // kNeedleTake
    {{{"Press and let go of the left button, go over the needle behind its point, hold the button.",
       "Naciśnij i puść lewy przycisk, najedź na igłę za ostrzem i przytrzymaj przycisk."},
      {"Press and let go of X, go over the needle behind its point, hold X.",
       "Naciśnij i puść X, najedź na igłę za ostrzem i przytrzymaj X."},
      {"Press and let go of A, go over the needle behind its point, hold A.",
       "Naciśnij i puść A, najedź na igłę za ostrzem i przytrzymaj A."},
      {"Press and let go of the left button, go over the needle behind its point, hold it again.",
       "Naciśnij i puść lewy przycisk, najedź na igłę za ostrzem i znów go przytrzymaj."},
      {"Open the handle, go over the needle behind its point, and close it.",
       "Otwórz uchwyt, najedź na igłę za ostrzem i zamknij go."}}},
    // kNeedleThrough
    {{{"Hold the left button and turn with Shift and the mouse, round the needle's own circle.",
       "Trzymaj lewy przycisk i obracaj z Shift i myszą, po okręgu igły."},
      {"Hold X and turn with Q or E, round the needle's own circle.",
       "Trzymaj X i obracaj klawiszem Q lub E, po okręgu igły."},
      {"Hold A and turn with the right stick, round the needle's own circle.",
       "Trzymaj A i obracaj prawą gałką, po okręgu igły."},
      {"Hold the left button and twist the cap, round the needle's own circle.",
       "Trzymaj lewy przycisk i skręcaj gałkę, po okręgu igły."},
      {"Keep it closed and turn the handle, round the needle's own circle.",
       "Trzymaj zamknięty i obracaj uchwyt, po okręgu igły."}}},
    // kThreadDraw
    {{{"Hold the left button and draw back with the wheel, towards you; go slowly once it is taut.",
       "Trzymaj lewy przycisk i ciągnij kółkiem do siebie; powoli, gdy nić się napnie."},
      {"Hold X and draw back with R; with Ctrl once it is taut.",
       "Trzymaj X i ciągnij klawiszem R; z Ctrl, gdy nić się napnie."},
      {"Hold A and draw back with the left trigger; go slowly once it is taut.",
       "Trzymaj A i ciągnij lewym spustem; powoli, gdy nić się napnie."},
      {"Hold the left button and pull the cap towards you; go slowly once it is taut.",
       "Trzymaj lewy przycisk i ciągnij gałkę do siebie; powoli, gdy nić się napnie."},
      {"Keep it closed and draw the handle out; go slowly once you feel the thread.",
       "Trzymaj zamknięty i wysuwaj uchwyt; powoli, gdy poczujesz nić."}}},
    // kPatchTake
    {{{"Down with the wheel at the ring until the jaws touch, then hold the left button.",
       "Kółkiem w dół przy pierścieniu, aż szczęki dotkną, potem przytrzymaj lewy przycisk."},
      {"F at the ring until the jaws touch, then hold X.",
       "F przy pierścieniu, aż szczęki dotkną, potem przytrzymaj X."},
      {"Right trigger at the ring until the jaws touch, then hold A.",
       "Prawy spust przy pierścieniu, aż szczęki dotkną, potem przytrzymaj A."},
      {"Push the cap at the ring until the jaws touch, then hold the left button.",
       "Popchnij gałkę przy pierścieniu, aż szczęki dotkną, potem przytrzymaj lewy przycisk."},
      {"Push the handle in at the ring until the jaws touch, then close it.",
       "Wsuń uchwyt przy pierścieniu, aż szczęki dotkną, potem go zamknij."}}},
    // kPatchLay
    {{{"Keep the left button down, lift a little with the wheel, draw it over with the mouse, "
       "lower "
       "it.",
       "Trzymaj lewy przycisk, unieś trochę kółkiem, przeciągnij myszą na miejsce, opuść."},
      {"Keep X down, lift a little with R, draw it over with W A S D, lower it with F.",
       "Trzymaj X, unieś trochę klawiszem R, przeciągnij W A S D na miejsce, opuść klawiszem F."},
      {"Keep A down, lift a little with the left trigger, draw it over with the left stick, lower "
       "it.",
       "Trzymaj A, unieś trochę lewym spustem, przeciągnij lewą gałką na miejsce, opuść."},
      {"Keep the left button down, lift a little with the cap, draw it over sideways, lower it.",
       "Trzymaj lewy przycisk, unieś trochę gałką, przeciągnij w bok na miejsce, opuść."},
      {"Keep it closed, lift a little, draw it over its place, lower it.",
       "Trzymaj zamknięty, unieś trochę, przeciągnij na miejsce, opuść."}}},
    // kPatchSpread
    {{{"Let go of the left button; where a fold is, take its rim again and draw it outwards.",
       "Puść lewy przycisk; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz."},
      {"Let go of X; where a fold is, take its rim again and draw it outwards.",
       "Puść X; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz."},
      {"Let go of A; where a fold is, take its rim again and draw it outwards.",
       "Puść A; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz."},
      {"Let go of the left button; where a fold is, take its rim again and draw it outwards.",
       "Puść lewy przycisk; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz."},
      {"Open the handle; where a fold is, take its rim again and draw it outwards.",
       "Otwórz uchwyt; gdzie jest fałda, chwyć znów brzeg i pociągnij go na zewnątrz."}}},
    // kWash
    {{{"Stay 1 cm above, point the jet beside the ring, hold the left button: water.",
       "Zostań 1 cm nad polem, skieruj strumień obok pierścienia, przytrzymaj lewy przycisk: "
       "woda."},
      {"Stay 1 cm above, point the jet beside the ring, hold X: water.",
       "Zostań 1 cm nad polem, skieruj strumień obok pierścienia, przytrzymaj X: woda."},
      {"Stay 1 cm above, point the jet beside the ring, hold A: water.",
       "Zostań 1 cm nad polem, skieruj strumień obok pierścienia, przytrzymaj A: woda."},
      {"Stay 1 cm above, point the jet beside the ring, hold the left button: water.",
       "Zostań 1 cm nad polem, skieruj strumień obok pierścienia, przytrzymaj lewy przycisk: "
       "woda."},
      {"Stay 1 cm above, point the jet beside the ring, press the yellow pedal: water.",
       "Zostań 1 cm nad polem, skieruj strumień obok pierścienia, naciśnij żółty pedał: woda."}}},
    // kSuck
    {{{"Down with the wheel into the fluid at the ring, not onto tissue; hold the right button.",
       "Kółkiem w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj prawy przycisk."},
      {"F down into the fluid at the ring, not onto tissue; hold C.",
       "F w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj C."},
      {"Right trigger down into the fluid at the ring, not onto tissue; hold B.",
       "Prawy spust w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj B."},
      {"Push the cap down into the fluid at the ring, not onto tissue; hold the right button.",
       "Popchnij gałkę w dół do płynu przy pierścieniu, nie na tkankę; przytrzymaj prawy "
       "przycisk."},
      {"Down into the fluid at the ring, not onto tissue; press the blue pedal.",
       "W dół do płynu przy pierścieniu, nie na tkankę; naciśnij niebieski pedał."}}},
    // kUndermine
    {{{"Left button down, in below the lifted edge, raise the tip by 2 mm with the wheel; deeper.",
       "Lewy przycisk, wejdź pod uniesiony brzeg, unieś końcówkę kółkiem o 2 mm; potem głębiej."},
      {"Hold X, in below the lifted edge, raise the tip by 2 mm with R, F down; deeper.",
       "Trzymaj X, wejdź pod uniesiony brzeg, R unosi końcówkę o 2 mm, F opuszcza; potem głębiej."},
      {"Hold A, in below the lifted edge, raise the tip by 2 mm with the left trigger; deeper.",
       "Trzymaj A, wejdź pod uniesiony brzeg, unieś końcówkę o 2 mm lewym spustem; potem głębiej."},
      {"Left button down, in below the lifted edge, raise the tip by 2 mm with the cap; deeper.",
       "Lewy przycisk, wejdź pod uniesiony brzeg, unieś końcówkę gałką o 2 mm; potem głębiej."},
      {"Closed, in below the lifted edge; raise the tip and open a little, 2 mm; then deeper.",
       "Zamknięty wejdź pod uniesiony brzeg; unieś końcówkę o 2 mm, trochę otwierając; potem "
       "głębiej."}}},
}};

// The scope has devices of its own.
constexpr ByDevice kScope{{{"Hold the middle button and move the mouse.",
                            "Przytrzymaj środkowy przycisk i ruszaj myszą."},
                           {"Arrow keys.", "Klawisze strzałek."},
                           {},
                           {},
                           {}}};

constexpr ByDevice kOtherHand{
    {{"Tab changes hands. ", "Tab zmienia rękę. "},
     {"Tab changes hands. ", "Tab zmienia rękę. "},
     {"Tab on the keyboard changes hands. ", "Tab na klawiaturze zmienia rękę. "},
     {"Tab on the keyboard changes hands. ", "Tab na klawiaturze zmienia rękę. "},
     {"With one arm: tap its second button to change hands. ",
      "Jedno ramię: jego drugi przycisk zmienia rękę. "}}};

}  // namespace

LocalText step_hint(const TaskStep& step, const std::string& device, bool changes_hand) {
    const auto own = step.hints.find(device.substr(0, device.find(':')));
    if (own != step.hints.end()) return own->second;
    const HintDevice hand = haptics::hint_device(device);
    if (hand == HintDevice::kNone) return {};
    const size_t column = static_cast<size_t>(hand) - 1;
    const bool scope = step.goal.hand == sim::Hand::kCamera;
    const Words& words =
        scope ? kScope[column] : kHints[static_cast<size_t>(step.goal.kind)][column];
    if (*words.en == '\0') return {};
    LocalText text{words.en, words.pl};
    if (changes_hand && !scope) {
        text.en.insert(0, kOtherHand[column].en);
        text.pl.insert(0, kOtherHand[column].pl);
    }
    return text;
}

}  // namespace placode::curriculum
