// SPDX-FileCopyrightText: 2026 The Placode authors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sim/view/strings.h"

#include <array>
#include <utility>

namespace placode::sim {
namespace {

constexpr std::pair<std::string_view, std::string_view> kPolish[] = {
    {"Inspect", "Oględziny"},
    {"Incise", "Nacięcie"},
    {"Release", "Uwolnienie"},
    {"Resect", "Resekcja"},
    {"Check", "Kontrola"},
    {"Practice", "Ćwiczenie"},
    {"CUT", "CIĘCIE"},
    {"COAG", "KOAG."},
    {"force", "siła"},
    {"ring", "obwód"},
    {"of", "z"},
    {"Paused", "Pauza"},
    {"Continue", "Kontynuuj"},
    {"Finish and score", "Zakończ i oceń"},
    {"Leave without finishing", "Wyjdź bez kończenia"},
    {"Arrows and Enter, or the mouse", "Strzałki i Enter albo mysz"},
    {"Controls", "Sterowanie"},
    {"DEMONSTRATION", "POKAZ"},
    {"REPLAY", "ODTWARZANIE"},
    {"F1 help   Esc pause   Enter finish", "F1 pomoc   Esc pauza   Enter koniec"},
    {"Screenshot saved", "Zapisano zrzut ekranu"},
    {"Screenshot could not be saved", "Nie udało się zapisać zrzutu ekranu"},
    {"Placode touched", "Dotknięto płytki nerwowej"},
    {"Placode heated", "Płytka nerwowa przegrzana"},
    {"Placode burned", "Płytka nerwowa oparzona"},
    {"Beside the mark", "Obok celu"},
    {"TUNED, not scored", "STROJONE, bez oceny"},
    {"Tuning", "Strojenie"},
    {"Tissue", "Tkanka"},
    {"Stiffness", "Sztywność"},
    {"Damping", "Tłumienie"},
    {"Friction", "Tarcie"},
    {"Failure stretch", "Rozciągnięcie zerwania"},
    {"Cut power", "Moc cięcia"},
    {"Coag power", "Moc koagulacji"},
    {"Skin", "Skóra"},
    {"Thin skin", "Cienka skóra"},
    {"Subcutis", "Tkanka podskórna"},
    {"Muscle", "Mięsień"},
    {"Junctional zone", "Strefa łącząca"},
    {"Placode", "Płytka nerwowa"},
    {"Gel", "Żel"},
    {"Dura", "Opona twarda"},
    {"Reset", "Przywróć"},
    {"Save as preset", "Zapisz jako zestaw"},
    {"Name:", "Nazwa:"},
    {"Saved as", "Zapisano jako"},
    {"Enter saves, Esc does not", "Enter zapisuje, Esc nie"},
    {"Everything as the scene says", "Wszystko jak w scenie"},
    {"Nothing was changed: there is nothing to save", "Nic nie zmieniono: nie ma czego zapisać"},
    {"The hands stand still. F2 once more: operate, arrows tune.",
     "Ręce stoją. F2 jeszcze raz: operujesz, strzałki stroją."},
    {"Arrows tune while you operate. F2 closes.", "Strzałki stroją podczas pracy. F2 zamyka."},
    {"No tuning in an exam", "Podczas egzaminu nie ma strojenia"},
    {"No sound on this computer", "Brak dźwięku na tym komputerze"},
    {"Sound off", "Dźwięk wyłączony"},
    {"Sound on", "Dźwięk włączony"},
    {"Wipe the lens", "Przetarcie optyki"},
    {"Lens wiped", "Optyka przetarta"},
    {"Sound off, louder, softer", "Dźwięk: wył., głośniej, ciszej"},
    {"Clinician's tuning", "Strojenie przez klinicystę"},
    {"Energy in air", "Energia poza tkanką"},
    {"Too long on one spot", "Za długo w jednym miejscu"},
    {"Too much force", "Za duża siła"},
    {"Tissue torn", "Rozerwanie tkanki"},
    {"Tissue overstretched", "Tkanka nadmiernie rozciągnięta"},
    {"The ring is complete", "Obwód zamknięty"},
    {"Recording stopped", "Nagrywanie przerwane"},
    {"Finished", "Zakończono"},
    {"Move the instrument", "Ruch narzędzia"},
    {"Deeper, shallower", "Głębiej, płycej"},
    {"Shallower, deeper", "Płycej, głębiej"},
    {"Move the scope", "Ruch endoskopu"},
    {"middle button", "środkowy przycisk"},
    {"Shift + mouse", "Shift + mysz"},
    {"arrows", "strzałki"},
    {"left bumper", "lewy przycisk górny"},
    {"Turn about the shaft", "Obrót wokół osi"},
    {"Cut (yellow pedal)", "Cięcie (żółty pedał)"},
    {"Coagulate (blue pedal)", "Koagulacja (niebieski pedał)"},
    {"Precise", "Precyzyjnie"},
    {"Other hand", "Druga ręka"},
    {"Freeze the hand", "Zatrzymanie ręki"},
    {"Planned line on, off", "Linia planowana wł., wył."},
    {"Performance", "Wydajność"},
    {"Screenshot", "Zrzut ekranu"},
    {"Pause and menu", "Pauza i menu"},
    {"Finish and be scored", "Zakończ i oceń"},
    {"Pause, go on", "Pauza, dalej"},
    {"5 s back, 5 s on", "5 s wstecz, 5 s dalej"},
    {"Faster, slower", "Szybciej, wolniej"},
    {"Next camera", "Następna kamera"},
    {"Close", "Zamknij"},
    {"Help on, off", "Pomoc wł., wył."},
    {"mouse", "mysz"},
    {"wheel", "kółko"},
    {"left button", "lewy przycisk"},
    {"right button", "prawy przycisk"},
    {"left stick", "lewa gałka"},
    {"triggers", "spusty"},
    {"right stick", "prawa gałka"},
    {"arm", "ramię"},
    {"pedals", "pedały"},
    {"The simulated operator works by itself; watch.", "Symulowany operator pracuje sam; patrz."},
};

}  // namespace

std::string translated(std::string_view english, std::string_view language) {
    if (language == "pl") {
        for (const auto& [en, pl] : kPolish) {
            if (en == english) return std::string(pl);
        }
    }
    return std::string(english);
}

}  // namespace placode::sim
